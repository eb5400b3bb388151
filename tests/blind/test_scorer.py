#!/usr/bin/env python3
"""Tests of the judge and the scorer: answers whose worth is known, exact intervals, and the trial end to end with the
stand-ins that know everything or nothing."""

import json
import pathlib
import tempfile
import unittest

import cases
import figures
import judge
import oracle
import runner
import scorer

HIDDEN = {"effect": "backlash", "joint": "X", "component": "EXX", "parameters": {"width": 3.0},
          "size_parameter": "width", "equivalent_value": 3.0, "sign_free": False, "equivalents": [{"effect": "backlash", "joint": "X"}]}
WAVE = {"effect": "cyclic", "joint": "Z", "component": "EZZ", "size_parameter": "amplitude", "equivalent_value": 2.0,
        "parameters": {"amplitude": 2.0, "period": 10.0, "phase": 30.0}, "sign_free": False,
        "equivalents": [{"effect": "cyclic", "joint": "Z"}]}


def named(effect="backlash", joint="X", confidence=0.95, **parameters):
    stated = {key: {"value": value, "sigma": sigma} for key, (value, sigma) in parameters.items()}
    return {"effect": effect, "joint": joint, "confidence": confidence, "parameters": stated}


def truth(*hidden, separable=True, **more):
    return {"hidden": list(hidden), "separable": separable, **more}


class Names(unittest.TestCase):
    def test_right_wrong_joint_and_unsure(self):
        self.assertTrue(judge.judge_names(truth(HIDDEN), {"effects": [named()]})["exact_set"])
        wrong = judge.judge_names(truth(HIDDEN), {"effects": [named(joint="Z")]})
        self.assertEqual((wrong["missed"], wrong["false_names"]), (["backlash@X"], ["backlash@Z"]))
        self.assertEqual(wrong["sure_false"], 1)
        self.assertEqual(judge.judge_names(truth(HIDDEN), {"effects": [named(confidence=0.4)]})["names"], [])

    def test_one_name_serves_one_effect(self):
        record = judge.judge_names(truth(HIDDEN, dict(HIDDEN)), {"effects": [named()]})
        self.assertEqual(record["named_right"], 1)

    def test_smooth_correction_is_no_name(self):
        self.assertEqual(judge.judge_names(truth(), {"effects": [named("nonparametric")]})["false_names"], [])


class Parameters(unittest.TestCase):
    def test_error_in_sigmas(self):
        self.assertAlmostEqual(judge.parameter_errors(HIDDEN, named(width=(3.4, 0.2)))["width"], 2.0)

    def test_no_sigma_is_none(self):
        one = {"effect": "backlash", "parameters": {"width": {"value": 3}}}
        self.assertIsNone(judge.parameter_errors(HIDDEN, one)["width"])

    def test_negative_amplitude_is_half_a_turn(self):
        one = named("cyclic", "Z", amplitude=(-2.1, 0.1), phase=(-149.0, 1.0), period=(10.0, 0.01))
        errors = judge.parameter_errors(WAVE, one)
        self.assertAlmostEqual(errors["amplitude"], 1.0)
        self.assertAlmostEqual(errors["phase"], 1.0)
        self.assertAlmostEqual(errors["period"], 0.0)

    def test_sign_counts_unless_the_joint_is_reversed(self):
        one = named(width=(-3.0, 0.2))
        self.assertAlmostEqual(judge.parameter_errors(HIDDEN, one)["width"], 30.0)
        self.assertAlmostEqual(judge.parameter_errors({**HIDDEN, "sign_free": True}, one)["width"], 0.0)


class Honesty(unittest.TestCase):
    LOOK = truth(HIDDEN, separable=False, lookalike_group=[{"effect": "backlash", "joint": "X"},
                                                           {"effect": "hysteresis", "joint": "X"}])

    def test_listing_counts_and_claiming_does_not(self):
        other = {"effect": "hysteresis", "joint": "X"}
        listed = {**named(confidence=0.6), "lookalikes": [other]}
        self.assertTrue(judge.lists_lookalike(self.LOOK, {"effects": [listed]}))
        self.assertFalse(judge.lists_lookalike(self.LOOK, {"effects": [{**listed, "confidence": 0.97}]}))
        self.assertFalse(judge.lists_lookalike(self.LOOK, {"effects": [named(confidence=0.6)]}))

    def test_fault_needs_file_and_rows(self):
        fault = {"file": "a.csv", "rows": [10, 20]}
        self.assertTrue(judge.finds_fault(fault, {"data_quality": [{"file": "x/a.csv", "rows": [20, 40]}]}))
        self.assertFalse(judge.finds_fault(fault, {"data_quality": [{"file": "x/a.csv", "rows": [21, 40]}]}))
        self.assertFalse(judge.finds_fault(fault, {"data_quality": [{"file": "b.csv", "rows": [10, 20]}]}))


class Figures(unittest.TestCase):
    def test_exact_interval(self):
        low, high = figures.interval(8, 10)       # tabulated: 0.4439…0.9748
        self.assertAlmostEqual(low, 0.4439, places=4)
        self.assertAlmostEqual(high, 0.9748, places=4)
        self.assertAlmostEqual(figures.interval(0, 300)[1], 1 - 0.025 ** (1 / 300), places=9)

    def test_quantile(self):
        self.assertEqual(figures.quantile([4.0, 1.0, 2.0, 3.0], 0.5), 2.5)
        self.assertIsNone(figures.quantile([], 0.5))

    def test_closed(self):
        self.assertEqual(judge.closed_pct(4.0, 1.0), 75.0)

    def test_squares_take_the_unit_of_the_column(self):
        with tempfile.TemporaryDirectory() as place:
            path = pathlib.Path(place) / "p.csv"
            path.write_text("#x: y\nrun,residual_dev_um,residual_rot_z_arcsec\n1,2.0,\n1,-2,3\n", encoding="utf-8")
            self.assertEqual(judge.squares(path, {"um": 2.0, "arcsec": 1.0}), (11.0, 3))


class EndToEnd(unittest.TestCase):
    def record(self, category, knows):
        seed = next(s for s in range(1, 2000) if cases.category_of(s) == category
                    and not cases.draw(s).options.split_runs)
        with tempfile.TemporaryDirectory() as place:
            cases.write(cases.draw(seed), pathlib.Path(place))
            return runner.trial(oracle.StandIn(knows), pathlib.Path(place))

    def test_who_knows_everything_is_right(self):
        records = [self.record(category, True) for category in ("single", "null", "fault")]
        self.assertTrue(all("failed" not in one and one["exact_set"] for one in records), records)
        self.assertGreater(records[0]["closed_pct"], 60.0)
        self.assertTrue(records[2]["finds_fault"])

    def test_who_knows_nothing_is_not(self):
        record = self.record("single", False)
        self.assertEqual((record["named_right"], record["closed_pct"]), (0, 0.0))
        self.assertIn("0.0 % (0/1;", scorer.markdown([record], "1:2"))

    def test_a_program_that_fails_is_counted_as_such(self):
        with tempfile.TemporaryDirectory() as place:
            cases.write(cases.draw(2), pathlib.Path(place))
            record = runner.trial(pathlib.Path("/nowhere/nineline-cli"), pathlib.Path(place))
        self.assertIn("failed", record)
        json.dumps(record)
        self.assertIn("nowhere", scorer.markdown([record], "2:3"))


if __name__ == "__main__":
    unittest.main()
