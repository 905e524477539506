"""Bad inputs, made from one good press case: name -> how to make it. Each writes files into a folder and gives the
arguments of the program. What is to be said about them is in expected.txt."""

import struct

BASE = """title = "A small press"
[blank]
size = ["60 mm", "60 mm"]
elements = 72
thickness = "1 mm"
[material]
card = "gf_pp_twill"
temperature = "190 degC"
[[tool]]
name = "punch"
mesh = "punch.stl"
motion = { displacement = "-5 mm" }
[[tool]]
name = "table"
mesh = "table.stl"
[time]
end = "5 ms"
[output]
frames = 3
history = 10
"""
CHECK = ("check", "case.toml")


def edited(*edits):
    """The good case with texts replaced."""
    text = BASE
    for old, new in edits:
        assert old in text, old
        text = text.replace(old, new)
    return {"case.toml": text.encode()}, CHECK


def with_lines(*lines):
    """The good case with lines after it (of [output]), or tables."""
    return {"case.toml": (BASE + "\n".join(lines) + "\n").encode()}, CHECK


def whole(content, name="case.toml", arguments=CHECK):
    return {"case.toml": BASE.encode(), name: content if isinstance(content, bytes) else content.encode()}, arguments


def boundary(text):
    """The case as a specimen test."""
    return {"case.toml": (BASE[:BASE.index("[[tool]]")] + text + BASE[BASE.index("[time]"):]).encode()}, CHECK


def material(*lines):
    return edited(('card = "gf_pp_twill"\n', 'card = "gf_pp_twill"\n' + "\n".join(lines) + "\n"))


CASES = {
    # TOML
    "empty": whole(""),
    "only_a_comment": whole("# nothing\n"),
    "not_toml": whole("this is not a case\n"),
    "unclosed_string": edited(('"60 mm", "60 mm"', '"60 mm, "60 mm"')),
    "unclosed_table": edited(("[blank]", "[blank")),
    "unclosed_array": edited(('"60 mm"]', '"60 mm"')),
    "two_equal_signs": edited(("elements = 72", "elements = = 72")),
    "duplicate_key": edited(("elements = 72", "elements = 72\nelements = 73")),
    "duplicate_table": edited(("[time]", "[blank]\n[time]")),
    "table_as_list": edited(("[blank]", "[[blank]]")),
    "list_as_table": edited(("[[tool]]\nname = \"punch\"", "[tool]\nname = \"punch\"")),
    "value_as_table": edited(("[time]", "[time.end]")),
    "deeply_nested_array": whole("a = " + "[" * 5000 + "]" * 5000),
    "deeply_nested_table": whole("a = " + "{a = " * 5000 + "1" + "}" * 5000),
    "deep_dotted_key": whole(".".join("a" for _ in range(20000)) + " = 1\n"),
    "endless_string": whole('title = "' + "x" * 1_000_000),
    "long_unknown_key": with_lines("x" * 100_000 + " = 1"),
    "latin_1": whole(BASE.replace("small", "großen").encode("latin-1")),
    "utf_16": whole(BASE.encode("utf-16")),
    "utf_8_cut_short": whole(BASE.encode() + b"# \xe2\x82"),
    "surrogates": whole(BASE.encode() + b"# \xed\xa0\x80\n"),
    "random_bytes": whole(bytes((i * 7919 + 13) % 256 for i in range(4096))),
    "zero_bytes": whole(b"\0" * 4096),
    "control_character": edited(("small", "sm\x01all")),
    "carriage_returns_only": whole(BASE.replace("\n", "\r")),
    "eleven_megabytes": whole("# " + "x" * 11_000_000),
    "date_for_a_number": edited(("frames = 3", "frames = 1979-05-27")),
    "nothing_after_equals": edited(("frames = 3", "frames =")),
    "hexadecimal_overflow": edited(("frames = 3", "frames = 0xffffffffffffffffff")),
    "integer_overflow": edited(("frames = 3", "frames = 99999999999999999999")),
    # keys
    "misspelt_key": edited(("thickness", "thicknes")),
    "misspelt_table": edited(("[time]", "[tme]")),
    "key_in_the_wrong_table": edited(("frames = 3", "frames = 3\nthickness = \"1 mm\"")),
    "key_at_the_top": whole("thickness = \"1 mm\"\n" + BASE),
    "capital_key": edited(("elements", "Elements")),
    "unknown_motion_key": edited(("displacement =", "distance =")),
    "empty_key": with_lines('"" = 1'),
    "no_blank": edited((BASE[BASE.index("[blank]"):BASE.index("[material]")], "")),
    "no_material": edited((BASE[BASE.index("[material]"):BASE.index("[[tool]]")], "")),
    "no_time": edited(('[time]\nend = "5 ms"\n', "")),
    "no_end": edited(('end = "5 ms"\n', "")),
    "no_size": edited(('size = ["60 mm", "60 mm"]\n', "")),
    "no_thickness": edited(('thickness = "1 mm"\n', "")),
    "no_temperature": edited(('temperature = "190 degC"\n', "")),
    # types and units
    "length_in_seconds": edited(('thickness = "1 mm"', 'thickness = "1 s"')),
    "length_in_grams": edited(('thickness = "1 mm"', 'thickness = "1 g"')),
    "unknown_unit": edited(('thickness = "1 mm"', 'thickness = "1 furlong"')),
    "no_unit": edited(('thickness = "1 mm"', 'thickness = "1"')),
    "unit_only": edited(('thickness = "1 mm"', 'thickness = "mm"')),
    "empty_quantity": edited(('thickness = "1 mm"', 'thickness = ""')),
    "comma_for_a_point": edited(('thickness = "1 mm"', 'thickness = "1,5 mm"')),
    "two_numbers": edited(('thickness = "1 mm"', 'thickness = "1 2 mm"')),
    "two_signs": edited(('thickness = "1 mm"', 'thickness = "--1 mm"')),
    "unit_twice": edited(('thickness = "1 mm"', 'thickness = "1 mm mm"')),
    "time_in_metres": edited(('end = "5 ms"', 'end = "5 m"')),
    "temperature_in_fahrenheit": edited(('"190 degC"', '"374 degF"')),
    "temperature_bare_celsius": edited(('temperature = "190 degC"', "temperature = 190")),
    "text_for_a_number": edited(("frames = 3", 'frames = "three"')),
    "fraction_of_a_frame": edited(("frames = 3", "frames = 2.5")),
    "true_for_a_number": edited(("frames = 3", "frames = true")),
    "list_for_a_number": edited(("frames = 3", "frames = [3]")),
    "table_for_a_number": edited(("frames = 3", "frames = { n = 3 }")),
    "number_for_a_text": edited(('title = "A small press"', "title = 5")),
    "number_for_a_name": edited(('name = "punch"', "name = 5")),
    "number_for_a_table": edited(("[output]\nframes = 3\nhistory = 10\n", ""), ("title", "output = 3\ntitle")),
    "one_size": edited(('["60 mm", "60 mm"]', '["60 mm"]')),
    "three_sizes": edited(('["60 mm", "60 mm"]', '["60 mm", "60 mm", "1 mm"]')),
    "size_not_a_list": edited(('["60 mm", "60 mm"]', '"60 mm"')),
    "sizes_of_two_kinds": edited(('["60 mm", "60 mm"]', '["60 mm", "60 s"]')),
    # values
    "thickness_negative": edited(('thickness = "1 mm"', 'thickness = "-1 mm"')),
    "thickness_zero": edited(('thickness = "1 mm"', "thickness = 0")),
    "thickness_nan": edited(('thickness = "1 mm"', "thickness = nan")),
    "thickness_inf": edited(('thickness = "1 mm"', "thickness = inf")),
    "thickness_nan_text": edited(('thickness = "1 mm"', 'thickness = "nan mm"')),
    "thickness_inf_text": edited(('thickness = "1 mm"', 'thickness = "inf mm"')),
    "thickness_in_kilometres": edited(('thickness = "1 mm"', "thickness = 1000")),
    "size_zero": edited(('["60 mm", "60 mm"]', '["0 mm", "60 mm"]')),
    "size_negative": edited(('["60 mm", "60 mm"]', '["60 mm", "-60 mm"]')),
    "size_infinite": edited(('["60 mm", "60 mm"]', "[inf, 0.06]")),
    "size_too_large_for_a_double": edited(('["60 mm", "60 mm"]', "[1e400, 0.06]")),
    "size_tiny": edited(('["60 mm", "60 mm"]', "[1e-300, 1e-300]")),
    "size_very_long": edited(('["60 mm", "60 mm"]', "[1e9, 1e-9]")),
    "elements_none": edited(("elements = 72", "elements = 0")),
    "elements_negative": edited(("elements = 72", "elements = -72")),
    "elements_a_thousand_million": edited(("elements = 72", "elements = 1000000000")),
    "elements_beyond_int": edited(("elements = 72", "elements = 9223372036854775807")),
    "edge_tiny": edited(("elements = 72", 'edge = "1 um"')),
    "edge_zero": edited(("elements = 72", "edge = 0")),
    "edge_nan": edited(("elements = 72", "edge = nan")),
    "edge_and_elements": edited(("elements = 72", 'elements = 72\nedge = "5 mm"')),
    "neither_edge_nor_elements": edited(("elements = 72\n", "")),
    "edge_tiny_unstructured": edited(("elements = 72", 'edge = "1 um"\npattern = "unstructured"')),
    "angle_nan": edited(("elements = 72", "elements = 72\nfibre_angle = nan")),
    "angle_infinite": edited(("elements = 72", "elements = 72\nmesh_angle = inf")),
    "pattern_unknown": edited(("elements = 72", 'elements = 72\npattern = "hexagonal"')),
    "symmetry_unknown": edited(("elements = 72", 'elements = 72\nsymmetry = "half"')),
    "yarns_parallel": edited(("elements = 72", "elements = 72\nfibre_1 = [1, 0, 0]\nfibre_2 = [2, 0, 0]")),
    "yarn_of_no_length": edited(("elements = 72", "elements = 72\nfibre_1 = [0, 0, 0]\nfibre_2 = [0, 1, 0]")),
    "yarn_out_of_the_plane": edited(("elements = 72", "elements = 72\nfibre_1 = [0, 0, 1]\nfibre_2 = [0, 1, 0]")),
    "one_yarn_only": edited(("elements = 72", "elements = 72\nfibre_1 = [1, 0, 0]")),
    "end_zero": edited(('end = "5 ms"', "end = 0")),
    "end_negative": edited(('end = "5 ms"', 'end = "-5 ms"')),
    "end_nan": edited(('end = "5 ms"', "end = nan")),
    "safety_beyond_one": edited(('end = "5 ms"', 'end = "5 ms"\nsafety = 1.5')),
    "mass_scaling_below_one": edited(('end = "5 ms"', 'end = "5 ms"\nmass_scaling = 0.5')),
    "step_negative": edited(('end = "5 ms"', 'end = "5 ms"\nstep = "-1 us"')),
    "frames_none": edited(("frames = 3", "frames = 0")),
    "frames_a_million": edited(("frames = 3", "frames = 1000000")),
    "history_negative": edited(("history = 10", "history = -1")),
    "checkpoint_negative": with_lines('checkpoint = "-5 min"'),
    "checkpoint_nan": with_lines("checkpoint = nan"),
    "temperature_absolute_zero": edited(('"190 degC"', '"-300 degC"')),
    "temperature_of_the_sun": edited(('"190 degC"', '"5000 K"')),
    "friction_negative": edited(('mesh = "table.stl"', 'mesh = "table.stl"\nfriction = -0.1')),
    "friction_nan": edited(('mesh = "table.stl"', 'mesh = "table.stl"\nfriction = nan')),
    "penalty_zero": with_lines("[contact]", "penalty = 0"),
    "penalty_beyond_the_limit": with_lines("[contact]", "penalty = 10"),
    "gate_negative": with_lines("[gates]", 'penetration = "-1 mm"'),
    "report_as_text": with_lines('report = "yes"'),
    "locking_angle_square": with_lines("[report]", 'locking_angle = "90 deg"'),
    "reference_not_there": with_lines("[report]", 'reference = "measured.csv"'),
    "section_of_one_number": with_lines("[report]", 'from = ["1 mm"]'),
    "where_without_reference": with_lines("[report]", 'where = "layup=A"'),
    "report_key_misspelt": with_lines("[report]", 'locking_angel = "50 deg"'),
    "gravity_nan": with_lines("[load]", "gravity = [0, 0, nan]"),
    "gravity_in_the_plane_only": with_lines("[load]", "gravity = [0, -9.81]"),
    # material
    "card_unknown": edited(('"gf_pp_twill"', '"gf_pp_twil"')),
    "card_empty": edited(('"gf_pp_twill"', '""')),
    "card_leads_out_of_the_folder": edited(('"gf_pp_twill"', '"../../../etc/passwd"')),
    "card_not_there": edited(('"gf_pp_twill"', '"own.toml"')),
    "card_is_a_folder": ({**edited(('"gf_pp_twill"', '"card.toml"'))[0], "card.toml/x": b""}, CHECK),
    "card_is_the_case": edited(('"gf_pp_twill"', '"case.toml"')),
    "card_names_a_card": ({**edited(('"gf_pp_twill"', '"own.toml"'))[0], "own.toml": b'card = "own.toml"\n'}, CHECK),
    "card_is_not_toml": ({**edited(('"gf_pp_twill"', '"own.toml"'))[0], "own.toml": b"\xff\xfe\0"}, CHECK),
    "modulus_negative": material('fibre_modulus = "-1 GPa"'),
    "modulus_infinite": material("fibre_modulus = inf"),
    "volume_fraction_beyond_one": material("fibre_volume_fraction = 1.2"),
    "volume_fraction_beyond_packing": material("fibre_volume_fraction = 0.9"),
    "tow_gap_negative": material('tow_gap = "-0.1 mm"'),
    "law_unknown": material('law = "plastic"'),
    "curve_rates_crossed": material('curve_rate_min = "20 rad/s"', 'curve_rate_max = "1 rad/s"'),
    "curve_count_huge": material("curve_count = 1000000"),
    "exponent_beyond_one": material("matrix.exponent = 2"),
    "viscosity_table_falls_back": material('matrix.model = "table"', 'matrix.table = [[1, "10 Pa s"], [1, "5 Pa s"]]'),
    "viscosity_table_empty": material('matrix.model = "table"', "matrix.table = []"),
    "bending_twice": material('bending_stiffness = "1 mN m"', 'bending_table = [["1 1/m", "1 mN"]]'),
    "tangent_with_a_rate_law": material('shear_tangent = ["1 MPa"]'),
    # tools and boundaries
    "tool_without_a_mesh": edited(('mesh = "table.stl"\n', "")),
    "tool_without_a_name": edited(('name = "table"\n', "")),
    "tools_of_one_name": edited(('name = "table"', 'name = "punch"')),
    "tool_with_an_empty_name": edited(('name = "table"', 'name = ""')),
    "tool_moved_and_pushed": edited(('motion = {', 'force = "-5 N"\nmass = "1 kg"\nmotion = {')),
    "tool_pushed_without_mass": edited(('motion = { displacement = "-5 mm" }', 'force = "-5 N"\nmass = 0')),
    "tool_far_away": edited(('mesh = "table.stl"', 'mesh = "table.stl"\nposition = ["10 m", 0, 0]')),
    "tool_in_the_blank": edited(('mesh = "table.stl"', 'mesh = "table.stl"\nposition = [0, 0, "0.3 mm"]')),
    "tool_in_micrometres": edited(('mesh = "table.stl"', 'mesh = "table.stl"\nmesh_unit = "um"')),
    "motion_of_two_kinds": edited(('displacement = "-5 mm"', 'displacement = "-5 mm", velocity = "1 m/s"')),
    "motion_of_no_kind": edited(('{ displacement = "-5 mm" }', '{ axis = "z" }')),
    "motion_infinite": edited(('displacement = "-5 mm"', "displacement = -inf")),
    "motion_along_nothing": edited(('{ displacement', '{ axis = "w", displacement')),
    "motion_is_a_number": edited(('{ displacement = "-5 mm" }', "5")),
    "motion_table_back_in_time": edited(('displacement = "-5 mm"',
                                         'profile = "table", table = [["0 s", "0 mm"], ["5 ms", "1 mm"], ["4 ms", "2 mm"]]')),
    "motion_table_of_three": edited(('displacement = "-5 mm"', 'profile = "table", table = [["0 s", "0 mm", "1 mm"]]')),
    "motion_table_empty": edited(('displacement = "-5 mm"', 'profile = "table", table = []')),
    "boundary_edge_unknown": boundary('[[boundary]]\nname = "a"\nedge = "north"\nmotion = { displacement = "1 mm" }\n'),
    "boundary_twice": boundary('[[boundary]]\nname = "a"\nedge = "top"\nmotion = { axis = "y", displacement = "1 mm" }\n'
                               '[[boundary]]\nname = "b"\nedge = "top"\n'),
    "frame_beyond_its_arms": boundary('[[boundary]]\nname = "a"\nkind = "picture_frame"\n'
                                      'motion = { displacement = "1 m" }\n'),
    "implicit_with_tools": edited(("title", 'solver = "implicit"\ntitle')),
    "implicit_with_triangles": {"case.toml": b""} and (
        {"case.toml": b'solver = "implicit"\n' + boundary('[[boundary]]\nname = "a"\nkind = "picture_frame"\n'
                                                         'motion = { displacement = "1 mm" }\n')[0]["case.toml"]}, CHECK),
    "solver_unknown": edited(("title", 'solver = "magic"\ntitle')),
}

# Overrides
OVERRIDES = {
    "set_nothing": ("",),
    "set_no_value": ("blank.thickness",),
    "set_no_key": ("=1 mm",),
    "set_unknown_key": ("blank.thikness=1 mm",),
    "set_unknown_tool": ("tool.anvil.friction=0.1",),
    "set_wrong_unit": ("time.end=5 mm",),
    "set_garbage": ("blank.size=[[[[",),
    "set_deep": ("a." * 10000 + "b=1",),
    "set_whole_table": ("blank=3",),
}
for name, overrides in OVERRIDES.items():
    CASES[name] = {"case.toml": BASE.encode()}, (*CHECK, *(part for text in overrides for part in ("--set", text)))


def facets(*triangles, count=None, header=b"solid", tail=b""):
    body = b"".join(struct.pack("<12fH", 0, 0, 0, *(x for corner in t for x in corner), 0) for t in triangles)
    return header.ljust(80) + struct.pack("<I", len(triangles) if count is None else count) + body + tail


UP = ((-0.03, -0.03, 0.0006), (0.03, -0.03, 0.0006), (0.0, 0.03, 0.0006))
NAN, INF = float("nan"), float("inf")
STL = {
    "stl_empty": b"",
    "stl_header_only": b"solid".ljust(80),
    "stl_no_facets": facets(),
    "stl_lies_more": facets(UP, count=2),
    "stl_lies_less": facets(UP, UP, count=1),
    "stl_lies_four_thousand_million": facets(UP, count=0xFFFFFFFF),
    "stl_cut_short": facets(UP, UP)[:-20],
    "stl_nan": facets(((NAN, 0, 0), (1, 0, 0), (0, 1, 0))),
    "stl_infinite": facets(((INF, 0, 0), (1, 0, 0), (0, 1, 0))),
    "stl_no_area": facets(((0, 0, 0), (0, 0, 0), (0, 0, 0))),
    "stl_line": facets(((0, 0, 0), (1, 0, 0), (2, 0, 0))),
    "stl_normals_clash": facets(UP, (UP[0], UP[1], (0.0, -0.06, 0.0006))),
    "stl_huge": facets(((-3e38, 0, 0), (3e38, 0, 0), (0, 3e38, 0))),
    "stl_tiny": facets(((0, 0, 0), (1e-38, 0, 0), (0, 1e-38, 0))),
    "stl_garbage": bytes((i * 31 + 7) % 256 for i in range(1000)),
    "stl_text_empty": b"solid x\nendsolid x\n",
    "stl_text_cut_short": b"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n",
    "stl_text_two_corners": b"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\nendsolid\n",
    "stl_text_four_corners": b"solid x\nfacet normal 0 0 1\nouter loop\n" + b"vertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n"
                             b"vertex 0 1 0\nendloop\nendfacet\nendsolid\n",
    "stl_text_words": b"solid x\nfacet normal 0 0 1\nouter loop\nvertex a b c\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n",
    "stl_text_nan": b"solid x\nfacet normal 0 0 1\nouter loop\nvertex nan 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n",
    "stl_is_toml": BASE.encode(),
}
for name, content in STL.items():
    CASES[name] = whole(content, "table.stl")
CASES["stl_not_there"] = edited(('"table.stl"', '"tisch.stl"'))
CASES["stl_is_a_folder"] = edited(('"table.stl"', '"."'))
CASES["stl_of_an_empty_name"] = edited(('"table.stl"', '""'))

MSH_HEAD = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
NODES = "$Nodes\n1 3 1 3\n2 1 0 3\n1\n2\n3\n-0.03 -0.03 0\n0.03 -0.03 0\n0 0.03 0\n$EndNodes\n"
TRIANGLE = "$Elements\n1 1 1 1\n2 1 2 1\n1 1 2 3\n$EndElements\n"
MSH = {
    "msh_empty": "",
    "msh_of_version_2": "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n",
    "msh_binary": "$MeshFormat\n4.1 1 8\n$EndMeshFormat\n",
    "msh_no_nodes": MSH_HEAD + TRIANGLE,
    "msh_no_elements": MSH_HEAD + NODES,
    "msh_lies_about_nodes": MSH_HEAD + NODES.replace("1 3 1 3", "1 1000000000000 1 3") + TRIANGLE,
    "msh_lies_about_elements": MSH_HEAD + NODES + TRIANGLE.replace("1 1 1 1", "1 99999999999 1 1"),
    "msh_lies_about_blocks": MSH_HEAD + NODES.replace("1 3 1 3", "4000000000 3 1 3") + TRIANGLE,
    "msh_names_a_missing_node": MSH_HEAD + NODES + TRIANGLE.replace("1 1 2 3", "1 1 2 9"),
    "msh_one_node_twice": MSH_HEAD + NODES + TRIANGLE.replace("1 1 2 3", "1 1 2 2"),
    "msh_nan": MSH_HEAD + NODES.replace("0 0.03 0", "nan 0.03 0") + TRIANGLE,
    "msh_not_flat": MSH_HEAD + NODES.replace("0 0.03 0", "0 0.03 0.01") + TRIANGLE,
    "msh_cut_short": (MSH_HEAD + NODES + TRIANGLE)[:-30],
    "msh_words": MSH_HEAD + NODES.replace("0 0.03 0", "a b c") + TRIANGLE,
    "msh_negative_tag": MSH_HEAD + NODES.replace("\n1\n2\n3\n", "\n-1\n2\n3\n") + TRIANGLE,
    "msh_is_stl": "solid x\nendsolid x\n",
}
for name, content in MSH.items():
    CASES[name] = ({**edited(('size = ["60 mm", "60 mm"]\nelements = 72', 'mesh = "blank.msh"'))[0],
                    "blank.msh": content.encode()}, CHECK)

CURVES_HEAD = "# towform shear curves 1\n"
CURVES = {
    "curves_empty": "",
    "curves_words": "these are not curves\n",
    "curves_nan": "rate 1 rad/s\nnan nan\n",
    "curves_bytes": "\x01\x02\x03",
    "curves_html": "<html><body>404</body></html>\n",
}
for name, content in CURVES.items():
    CASES[name] = ({**material('curves = "own.txt"')[0], "own.txt": content.encode()}, CHECK)
CASES["curves_not_there"] = material('curves = "own.txt"')

FIT = ("material", "fit", "test.csv", "-o", "curves.txt", "--test", "picture-frame", "--side", "115", "--rate", "1")
for name, content in {
    "test_empty": "", "test_words": "a,b\nx,y\n", "test_nan": "angle_deg,force_N\nnan,1\n", "test_binary": "\0\1\2,\3\n",
    "test_no_points": "angle_deg,force_N\n", "test_one_column": "angle_deg\n1\n", "test_infinite": "angle_deg,force_N\ninf,1\n",
    "test_of_ten_columns": "angle_deg,force_N\n" + "1,2,3,4,5,6,7,8,9,10\n",
    "test_backwards": "angle_deg,force_N\n20,5\n10,3\n0,1\n", "test_beyond_reason": "angle_deg,force_N\n100,1\n200,2\n300,3\n",
}.items():
    CASES[name] = whole(content, "test.csv", FIT)

# Commands
CASES["no_such_case"] = {}, ("check", "none.toml")
CASES["a_folder_for_a_case"] = {"folder/x": b""}, ("check", "folder")
CASES["resume_nothing"] = {}, ("resume", "none")
CASES["resume_an_empty_folder"] = {"folder/x": b""}, ("resume", "folder")
for name, content in {"checkpoint_empty": b"", "checkpoint_text": b"not a checkpoint" * 100,
                      "checkpoint_lies": b"towform checkpoint\nschema 5\nbytes 99999999999999999999\ncrc32 0\n".ljust(600, b"\0"),
                      "checkpoint_of_another_schema": b"towform checkpoint\nschema 77\nbytes 600\ncrc32 0\n".ljust(600, b"\0"),
                      "checkpoint_of_zeros": b"\0" * 10000}.items():
    CASES[name] = {"folder/checkpoint.h5": content}, ("resume", "folder")
CASES["info_of_nothing"] = {}, ("info", "none.h5")
CASES["info_of_a_text"] = {"a.h5": b"not HDF5"}, ("info", "a.h5")
CASES["info_of_a_signature"] = {"a.h5": b"\x89HDF\r\n\x1a\n" + b"\0" * 500}, ("info", "a.h5")
CASES["info_of_a_folder"] = {"a.h5/x": b""}, ("info", "a.h5")
CASES["report_of_a_text"] = {"a/results.h5": b"not HDF5"}, ("report", "a")
CASES["report_of_a_file"] = {"results.h5": b"not HDF5"}, ("report", "results.h5")
CASES["preview_into_a_file"] = {"case.toml": BASE.encode(), "look": b"mine"}, (*CHECK, "--preview", "look")
CASES["init_into_a_file"] = {"mine": b"mine"}, ("init", "mine")
CASES["compare_with_a_text_for_results"] = {"a.h5": b"not HDF5", "b.csv": b"x_mm,y_mm\n"}, ("compare", "a.h5", "b.csv")
