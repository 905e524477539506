"""What a run leaves that a response can ask for; tests compare these lists with a real run's files."""

import re

SUMMARY = ["elements", "nodes", "steps", "simulated_time_s", "wall_time_s", "threads", "ns_per_element_step", "step_min_s",
           "step_max_s", "energy_error", "kinetic_to_internal_max", "shear_angle_max_deg", "shear_angle_p99_deg",
           "fibre_strain_max", "fibre_strain_p99", "fibre_strain_over_2_percent", "fibre_compression_max",
           "fibre_compression_p99", "fibre_compression_over_half_percent", "draw_in_mm.x_mid", "draw_in_mm.y_mid",
           "draw_in_mm.corner", "punch_force_max_N", "penetration_max_mm", "added_mass_fraction"]
_ENERGIES = ["kinetic", "yarn", "shear_elastic", "shear_dissipated", "bending", "bending_damping", "contact", "friction",
             "damping", "external"]
SUMMARY += [f"energies_J.{kind}" for kind in _ENERGIES]
_HISTORY = ["time_s", "step", "dt_s", *(f"energy_{kind}_J" for kind in _ENERGIES), "energy_error", "kinetic_to_internal",
            "draw_in_x_mid_mm", "draw_in_y_mid_mm", "draw_in_corner_mm", "shear_angle_max_deg", "fibre_strain_p99",
            "penetration_mm"]
# Component names of a field's columns; none of a field with one value.
_XYZ, _YARNS = ("x", "y", "z"), ("warp", "weft")
FIELDS = {"position": _XYZ, "velocity": _XYZ, "contact_pressure": (), "clearance": (), "shear_angle": (), "shear_rate": (),
          "curve_index": (), "curve_position": (), "shear_force": (), "fibre_1": _XYZ, "fibre_2": _XYZ,
          "fibre_strain": _YARNS, "curvature": _YARNS, "thickness": (), "temperature": ()}
FIELD_UNITS = {"position": "m", "velocity": "m/s", "contact_pressure": "Pa", "clearance": "m", "shear_angle": "deg",
               "shear_rate": "rad/s", "shear_force": "N/m", "curvature": "1/m", "thickness": "m", "temperature": "K"}
OUTLINE = {"draw_in": "mm"}
_UNIT = re.compile(r"_(mm|deg|N|J|s|m)(?:\.|\Z)")


def history_columns(case):
    """Columns of history.csv of a resolved case."""
    moved = [entry["name"] for section in ("tool", "boundary") for entry in case.get(section, [])
             if section == "tool" or "motion" in entry]
    return _HISTORY + [f"{what}_{name}_{unit}" for name in moved for what, unit in (("force", "N"), ("position", "m"))]


def unit_of(name):
    """The unit that a key of the summary or a column of the history carries in its name."""
    match = _UNIT.search(name)
    return match[1] if match else ""
