"""The parts of a study by themselves: parts_test.py TOWFORM SOURCE_DIR."""

import math
import sys
import unittest
from pathlib import Path
from types import SimpleNamespace

import numpy as np

from harness import Program, SOURCE
from study import quantity, sampling, sheet, study_keys
from study.formula import Formula
from study.pareto import pareto_set
from study.responses import reduced
from study.sensitivity import rank_correlations, sobol_indices
from study.study import Parameter, Response


class Sensitivities(unittest.TestCase):
    def ishigami(self, points):
        x = np.pi * (2.0 * np.array(points) - 1.0)
        return np.sin(x[:, 0]) + 7.0 * np.sin(x[:, 1]) ** 2 + 0.1 * x[:, 2] ** 4 * np.sin(x[:, 0])

    def test_sobol_indices_of_the_ishigami_function_are_the_exact_ones(self):
        a, b = 7.0, 0.1
        parts = {(0,): 0.5 * (1 + b * math.pi**4 / 5) ** 2, (1,): a**2 / 8, (0, 2): b**2 * math.pi**8 * (1 / 18 - 1 / 50)}
        variance = sum(parts.values())
        first = [sum(v for k, v in parts.items() if k == (i,)) / variance for i in range(3)]
        total = [sum(v for k, v in parts.items() if i in k) / variance for i in range(3)]
        count = 2048
        values = self.ishigami(sampling.saltelli(count, 3, seed=1)).reshape(count, 5)
        found = sobol_indices(values, seed=1)
        for exact, estimates in zip((first, total), found):
            for i, (e, estimate) in enumerate(zip(exact, estimates)):
                with self.subTest(parameter=i):
                    self.assertAlmostEqual(estimate.value, e, delta=0.02)  # 2048 points of a Sobol sequence: some 0.01
                    self.assertLess(estimate.low, e)
                    self.assertGreater(estimate.high, e)
                    self.assertLess(estimate.high - estimate.low, 0.2)

    def test_a_failed_run_costs_its_base_point_only(self):
        values = self.ishigami(sampling.saltelli(256, 3, seed=2)).reshape(256, 5)
        without = sobol_indices(np.delete(values, 7, axis=0))
        values[7, 3] = np.nan
        self.assertEqual([e.value for e in sobol_indices(values)[1]], [e.value for e in without[1]])

    def test_nothing_is_said_of_a_constant_response(self):
        for estimates in (*sobol_indices(np.ones((64, 4))), *rank_correlations(np.random.default_rng(0).random((20, 2)), np.ones(20))):
            self.assertTrue(all(math.isnan(e.value) for e in estimates))

    def test_partial_rank_correlation_takes_the_other_parameter_away(self):
        random = np.random.default_rng(3)
        x = random.random((200, 1))
        other = x[:, 0] + 0.3 * random.random(200)  # goes with x, has no part in the response
        y = np.exp(3.0 * x[:, 0]) + 0.1 * random.random(200)
        spearman, partial = rank_correlations(np.column_stack([x, other]), y)
        self.assertGreater(spearman[1].value, 0.8)
        self.assertLess(abs(partial[1].value), 0.2)
        self.assertGreater(partial[0].value, 0.9)
        self.assertLess(partial[0].low, partial[0].value)

    def test_spearman_is_scipys(self):
        from scipy.stats import spearmanr
        x = np.random.default_rng(4).integers(0, 5, (30, 1)).astype(float)  # with ties
        y = x[:, 0] + np.random.default_rng(5).normal(size=30)
        self.assertAlmostEqual(rank_correlations(x, y)[0][0].value, spearmanr(x[:, 0], y)[0], delta=1e-12)


class Pareto(unittest.TestCase):
    def test_it_is_what_comparing_every_pair_finds(self):
        costs = np.random.default_rng(6).integers(0, 6, (60, 3)).astype(float)
        costs[5, 1] = np.nan
        wanted = [np.isfinite(a).all() and not any(np.isfinite(b).all() and (b <= a).all() and (b < a).any() for b in costs)
                  for a in costs]
        self.assertEqual(pareto_set(costs).tolist(), wanted)
        self.assertGreater(sum(wanted), 1)


class Samples(unittest.TestCase):
    def study(self, method, runs=0, *parameters):
        return SimpleNamespace(sampling=SimpleNamespace(method=method, runs=runs, seed=0), parameters=parameters, path="s.toml")

    def parameter(self, name, values=(), low=0.0, high=1.0, **more):
        return Parameter(name, name, name, "", list(values), low, high, **more)

    def test_a_grid_has_every_value_with_every_other_and_a_list_has_rows(self):
        two = self.parameter("a", [1.0, 2.0, 3.0]), self.parameter("b", ["x", "y", "z"])
        self.assertEqual(len(sampling.rows_of(self.study("grid", 0, *two))), 9)
        self.assertEqual(sampling.rows_of(self.study("list", 0, *two))[1], {"a": 2.0, "b": "y"})

    def test_a_latin_hypercube_has_one_run_in_every_slice(self):
        rows = sampling.rows_of(self.study("latin_hypercube", 10, self.parameter("a"), self.parameter("b", low=1.0, high=100.0, log=True)))
        self.assertEqual(sorted(int(10 * row["a"]) for row in rows), list(range(10)))
        self.assertEqual(sorted(int(10 * math.log(row["b"]) / math.log(100)) for row in rows), list(range(10)))

    def test_whole_numbers_and_values_are_what_is_sampled_where_they_are_wanted(self):
        rows = sampling.rows_of(self.study("sobol", 32, self.parameter("a", low=1, high=9, whole=True), self.parameter("b", ["x", "y"])))
        self.assertTrue(all(row["a"] == round(row["a"]) for row in rows))
        self.assertEqual({row["b"] for row in rows}, {"x", "y"})

    def test_a_seed_gives_the_same_runs(self):
        for method in ("latin_hypercube", "sobol", "saltelli"):
            study = self.study(method, 8, self.parameter("a"), self.parameter("b"))
            rows = sampling.rows_of(study)
            self.assertEqual(rows, sampling.rows_of(study))
            self.assertEqual(len(rows), 32 if method == "saltelli" else 8)
            study.sampling.seed = 1
            self.assertNotEqual(rows, sampling.rows_of(study))


class Formulas(unittest.TestCase):
    def test_arithmetic(self):
        self.assertAlmostEqual(Formula("-sqrt(a**2 + b) / max(2, b)").value({"a": 3.0, "b": 7.0}), -4.0 / 7.0)

    def test_nothing_but_arithmetic(self):
        for text in ("__import__('os')", "a.b", "a[0]", "'x'", "a if b else c", "open(1)", "lambda: 1", "1 +", "True", "f(x=1)", "(" * 999):
            with self.subTest(text), self.assertRaises(ValueError):
                Formula(text)

    def test_no_value(self):
        for text in ("1 / a", "sqrt(a - 1)", "(a - 1) ** 0.5", "exp(9999)", "(a + 1e300) * 1e300"):
            with self.subTest(text), self.assertRaises(ValueError):
                Formula(text).value({"a": 0.0})

    def test_quantities(self):
        self.assertEqual(quantity.split("-35.5e1 kN mm"), (-355.0, "kN mm"))
        for nothing in ("N", "", "nan", "inf N", True, float("nan"), [1]):
            self.assertIsNone(quantity.split(nothing))
        self.assertAlmostEqual(quantity.in_si("40 mm", "length"), 0.04)
        for wrong in ("40 N", "x"):
            with self.assertRaises(ValueError):
                quantity.in_si(wrong, "length")


class Sheets(unittest.TestCase):
    """A flat square of 2 x 2 cells from 0 to 2, quarter of a sheet, pulled in at its rim."""

    def setUp(self):
        flat = np.array([[x, y, 0.0] for y in range(3) for x in range(3)], float)
        cells = [(r * 3 + c, r * 3 + c + 1, r * 3 + c + 4, r * 3 + c + 3) for r in range(2) for c in range(2)]
        triangles = np.array([t for a, b, c, d in cells for t in ((a, b, c), (a, c, d))])
        self.results = SimpleNamespace(triangles=triangles, reference=flat, case={"blank": {"symmetry": "quarter"}})
        formed = flat.copy()
        formed[flat[:, 0] == 2, 0] -= 0.3
        formed[flat[:, 1] == 2, 1] -= 0.1
        self.frame = SimpleNamespace(position=formed)

    def test_a_point_finds_its_element_and_nothing_beyond_the_sheet(self):
        values = np.arange(8.0)
        found = sheet.values_at(self.results, self.frame, values, [(0.6, 0.1), (1.69, 0.1), (1.75, 0.1)])
        self.assertEqual(found[:2].tolist(), [0.0, 2.0])
        self.assertTrue(np.isnan(found[2]))
        self.assertEqual(sheet.values_at(self.results, self.frame, values, [(1.75, 0.1)], flat=True)[0], 2.0)

    def test_values_at_nodes_are_interpolated_and_the_upper_layer_counts(self):
        height = self.results.reference[:, 0] * 10.0
        self.assertAlmostEqual(sheet.values_at(self.results, self.frame, height, [(0.25, 0.5)])[0], 2.5)
        self.frame.position[[2, 5, 8]] = self.frame.position[[0, 3, 6]] + [0, 0, 1.0]  # folded over
        self.assertIn(sheet.values_at(self.results, self.frame, np.arange(8.0), [(0.5, 0.2)])[0], (2.0, 3.0))

    def test_draw_in_is_of_the_outline_without_the_mirrors(self):
        found = sheet.draw_in(self.results, self.frame)
        self.assertEqual(len(found), 5)
        self.assertAlmostEqual(found.max(), 300.0)
        self.assertAlmostEqual(found.min(), 100.0)
        self.results.case["blank"]["symmetry"] = "none"
        self.assertEqual(len(sheet.draw_in(self.results, self.frame)), 8)

    def test_many_values_become_one(self):
        values = np.array([-3.0, 1.0, 2.0])
        wanted = {"max": 2.0, "min": -3.0, "mean": 0.0, "largest": -3.0, "spread": 5.0, "last": 2.0, "p50": 1.0}
        self.assertEqual({how: reduced(values, how) for how in wanted}, wanted)
        self.assertEqual(reduced(values, "mean", np.array([0.0, 1.0, 1.0])), 1.5)

    def test_the_excess_over_limits_is_relative(self):
        response = Response("r", "r", "summary", "x", "", low=1.0, high=4.0)
        self.assertEqual([response.excess(v) for v in (0.5, 1.0, 4.0, 6.0)], [0.5, 0.0, 0.0, 0.5])


class Reference(unittest.TestCase):
    def test_the_page_of_keys_is_up_to_date(self):
        self.assertEqual((SOURCE / "docs" / "study_keys.md").read_text(), study_keys.reference(),
                         "PYTHONPATH=tools /usr/bin/python3 -m study.study_keys > docs/study_keys.md")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
