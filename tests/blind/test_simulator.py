#!/usr/bin/env python3
"""Tests of the blind trial's simulator: hand cases of kinematics, tables, instruments and signs; valid files."""

import json
import pathlib
import tempfile
import unittest

import numpy as np

import cases
import effects
import machines
import readings
import states
import tables
from campaign import File

ARCSEC_MM = 4.84813681109536e-6  # mm per mm of lever and arc second
NANOMETRE = 1e-6


def machine(identity, **changes):
    drawn = machines.draw(identity, np.random.default_rng(1))
    text = json.loads(json.dumps(drawn.text))
    for side in ("workpiece_chain", "tool_chain"):
        for joint in text[side]:
            joint["offset_mm"] = changes.get(joint["axis"], [0, 0, 0])
    text["tool"]["tip_mm"] = changes.get("tip", [0, 0, 0])
    return machines.Machine(text)


def at(one, **q):
    run = states.Run(one, [0.0]).hold(**q)
    run.run_index = np.array([1])
    return run


def one_file(instrument, run, channels=(), **head):
    return File("x", instrument, head, [run], {"um": 1.0, "arcsec": 1.0}, channels)


def read(one, instrument, run, adds, channels=(), location=(), **head):
    errors = machines.ErrorState(run.n)
    for component, value, standing in adds:
        errors.add(component, np.full(run.n, float(value)), standing)
    for component, value in location:
        errors.add_location(component, value)
    file = one_file(instrument, run, channels, **head)
    return {name: values[0] for name, values in readings.read(one, file, file.whole, errors).items()}


class Kinematics(unittest.TestCase):
    def tip(self, one, **q):
        arrays = {k: np.array([float(q.get(k, 0.0))]) for k in one.joints}
        return machines.tool_in_work(one, machines.bodies(one, arrays, machines.ErrorState(1)))[1][0]

    def test_table_that_moves_against_the_axis_takes_the_tool_along(self):
        one = machine("generic-3axis", tip=[0, 0, -100])
        np.testing.assert_allclose(self.tip(one, X=10, Y=20, Z=30), [10, 20, -70], atol=NANOMETRE)

    def test_grinder_turns_the_tool_back_about_the_work(self):
        one = machine("b2-k3032", C=[0, 0, 100], X=[5, 0, 300], tip=[-25, 0, 0])
        np.testing.assert_allclose(self.tip(one, X=50, Z=40, C=0), [30, 0, 160], atol=NANOMETRE)
        np.testing.assert_allclose(self.tip(one, X=50, Z=40, C=90), [0, -30, 160], atol=NANOMETRE)

    def test_trunnion_tilts_about_minus_x(self):
        one = machine("trunnion-ac")
        np.testing.assert_allclose(self.tip(one, Y=10, A=90), [0, 0, 10], atol=NANOMETRE)

    def test_rotation_vector_comes_back(self):
        vectors = np.array([[1e-5, -2e-5, 3e-5], [0.3, -0.2, 1.1], [0, 0, 0]])
        np.testing.assert_allclose(machines.rotation_vectors(machines.rotations(vectors)), vectors, atol=1e-14)

    def test_location_turns_the_axis_line(self):
        one = machine("generic-3axis")
        run = at(one, Y=100)   # +Y turned about +Z by 10": the body at -y 100 goes to +x
        moved = read(one, "laser-straightness", run, [], location=[("C0Y", 10.0)], axis="Y", sensitive="X",
                     point_mm=[0, 0, 0])["dev_um"]
        self.assertAlmostEqual(moved, 100 * 10 * ARCSEC_MM * 1000, places=4)


class Tables(unittest.TestCase):
    def test_natural_spline_by_hand(self):
        table = tables.Table("EXX", 0.0, 1.0, [0.0, 1.0, 0.0])   # m = (0, -3, 0)
        self.assertAlmostEqual(float(table.at(0.5)), 0.5 + 3 * (0.5 - 0.125) / 6)

    def test_periodic_spline_is_smooth_over_the_seam(self):
        nodes = np.arange(0, 360, 10.0)
        table = tables.Table("ECC", 0.0, 10.0, np.sin(np.radians(nodes)), periodic=True)
        q = np.array([-5.0, 3.0, 355.0, 363.0])
        np.testing.assert_allclose(table.at(q), np.sin(np.radians(q)), atol=1e-5)
        self.assertAlmostEqual(float(table.at(-5.0)), float(table.at(355.0)), places=12)

    def test_end_value_holds_outside(self):
        table = tables.Table("EXX", 0.0, 10.0, [1.0, 2.0, 4.0])
        self.assertEqual(float(table.at(90.0)), 4.0)

    def test_linear(self):
        self.assertEqual(float(tables.Table("EXX", 0, 10, [0, 4], "linear").at(2.5)), 1.0)


class Instruments(unittest.TestCase):
    def test_positive_error_reads_positive_on_the_work_side_too(self):
        one = machine("b2-k3032")
        value = read(one, "laser-linear", at(one, Z=10), [("EZZ", 3.0, False)], axis="Z", point_mm=[0, 0, 0])
        self.assertAlmostEqual(value["dev_um"], 3.0, places=6)

    def test_yaw_with_the_point_at_y(self):
        one = machine("linear-stage")
        value = read(one, "laser-linear", at(one, X=10), [("ECX", 2.0, False)], axis="X", point_mm=[0, 100, 0])
        self.assertAlmostEqual(value["dev_um"], -2.0 * ARCSEC_MM * 100 * 1000, places=5)

    def test_table_error_moves_the_tool_the_other_way(self):
        one = machine("generic-3axis")
        value = read(one, "deviation", at(one), [("EXX", 2.0, False)], ["dev_x_um", "rot_z_arcsec"])
        self.assertAlmostEqual(value["dev_x_um"], -2.0, places=6)

    def test_eccentricity_turns_once_on_the_dial_and_stands_still_in_the_work(self):
        one = machine("rotary-table")
        effect = {"effect": "eccentricity", "joint": "C", "component": "EXC",
                  "parameters": {"amplitude": 5.0, "phase": 0.0, "n": 1}}
        for angle, seen in ((0, 5.0), (60, 2.5), (180, -5.0)):
            run = at(one, C=angle)
            adds = [(c, float(v[0]), s) for c, s, v in effects.contribution(one, effect, run)]
            self.assertAlmostEqual(read(one, "dial", run, adds, axis="C", point_mm=[0, 0, 30], sensitive="X")["dev_um"],
                                   seen, places=6)
            self.assertAlmostEqual(read(one, "deviation", run, adds, ["dev_x_um"])["dev_x_um"], -5.0, places=6)

    def test_wobble_grows_with_height(self):
        one = machine("rotary-table")
        value = read(one, "dial", at(one), [("EBC", 4.0, True)], axis="C", point_mm=[0, 0, 250], sensitive="X")
        self.assertAlmostEqual(value["dev_um"], 4.0 * ARCSEC_MM * 250 * 1000, places=5)

    def test_lead_sees_table_and_spindle(self):
        one = machine("b2-k3032")
        head = {"pitch_mm": 6.0, "starts": 1, "hand": "right"}
        table = read(one, "lead", at(one, X=30, Z=0), [("EZZ", 2.0, False)], **head)
        self.assertAlmostEqual(table["dev_um"], -2.0, places=6)
        spindle = read(one, "lead", at(one, X=30, Z=0), [("ECC", 36.0, False)], **head)
        self.assertAlmostEqual(spindle["dev_um"], 6000.0 * 36 / 1296000, places=5)   # the tool turns back

    def test_ballbar_reads_the_radius(self):
        one = machine("generic-3axis")
        value = read(one, "ballbar", at(one, X=100), [("EXX", -3.0, False)], centre_mm=[0, 0, 0], radius_mm=100)
        self.assertAlmostEqual(value["dr_um"], 3.0, places=6)

    def test_joint_reads_its_own_component_alone(self):
        one = machine("linear-stage")
        value = read(one, "joint", at(one), [("EXX", 1.5, False), ("EYX", 7.0, False), ("ECX", 9.0, False)], axis="X")
        self.assertAlmostEqual(value["dev_um"], 1.5, places=9)


class Signs(unittest.TestCase):
    """Each effect by hand from the contract's table, at one state."""

    def setUp(self):
        self.machine = machine("linear-stage")
        run = at(self.machine, X=500.0)
        run.s["X"][:], run.v["X"][:], run.a["X"][:], run.d["X"][:] = 1.0, 20.0, 300.0, 10.0
        run.load[:], run.wheel_pass[:], run.feed[:], run.t[:] = 200.0, 4.0, 1500.0, 1800.0
        run.temps = {"screw_X": np.array([25.0]), "head": np.array([24.0]), "front": np.array([23.0]),
                     "back": np.array([21.0])}
        self.run_state = run

    def value(self, name, component="EXX", **parameters):
        effect = {"effect": name, "joint": "X", "component": component, "parameters": parameters}
        (_, _, values), = effects.contribution(self.machine, effect, self.run_state)
        return float(values[0])

    def test_every_formula(self):
        fade = np.exp(-0.5)
        expected = [
            (self.value("scale", k=10.0), 5.0), (self.value("cyclic", amplitude=2.0, period=2000.0, phase=0.0), 2.0),
            (self.value("straightness", "EYX", amplitude=3.0, shape="bow"), 3.0 * (0.25 - 1 / 3)),
            (self.value("straightness", "EYX", amplitude=3.0, shape="s"), 3.0 * (0.125 - 0.3)),
            (self.value("angular", "ECX", amplitude=4.0, shape="linear"), 2.0),
            (self.value("backlash", width=3.0), -1.5), (self.value("windup", k=4.0), -1.0),
            (self.value("lost_motion", kappa=0.01), -1.0),
            (self.value("hysteresis", width=3.0, length=20.0), -1.5 * (1 - 2 * fade)),
            (self.value("reversal_spike", height=3.0, length=20.0), -3.0 * fade),
            (self.value("servo_lag", tau=0.2), -4.0), (self.value("acceleration", k=5.0), 1.5),
            (self.value("thermal_screw", k=10.0, q_fixed=100.0, sensor="screw_X"), 20.0),
            (self.value("thermal_head", k=1.5, tau=900.0, sensor="head"), 6.0),
            (self.value("thermal_tilt", "ECX", k=0.5, sensor="front", sensor_2="back"), 1.0),
            (self.value("drift", rate=2.0), 1.0), (self.value("sag", k=4.0, q_ref=0.0), -1.0),
            (self.value("load_deformation", k=0.01), 2.0), (self.value("wheel_wear", rate=0.5), 2.0),
            (self.value("wheel_deflection", k=2.0), 3.0)]
        for found, wanted in expected:
            self.assertAlmostEqual(found, wanted, places=9)

    def test_play_of_a_joint_against_the_frame_acts_in_its_own_sense(self):
        one = machine("generic-3axis")
        run = at(one, X=100.0)
        effect = {"effect": "backlash", "joint": "X", "component": "EXX", "parameters": {"width": 4.0}}
        (component, standing, values), = effects.contribution(one, effect, run)
        self.assertAlmostEqual(read(one, "laser-linear", run, [(component, values[0], standing)], axis="X",
                                    point_mm=[0, 0, 0])["dev_um"], -2.0, places=6)


class History(unittest.TestCase):
    def test_pendulum_turns_once_and_counts_from_there(self):
        s, d = states.history(states.pendulum([0.0, 10.0, 30.0]))
        np.testing.assert_array_equal(s, [1, 1, 1, -1, -1])
        np.testing.assert_array_equal(d, [np.inf, np.inf, np.inf, 20.0, 30.0])

    def test_lag_of_a_ramp_is_exact(self):
        t = np.array([0.0, 10.0, 35.0, 100.0])
        exact = 0.2 * (t - 50.0 * (1 - np.exp(-t / 50.0)))
        np.testing.assert_allclose(states.lagged(t, 0.2 * t, 50.0), exact, atol=1e-12)

    def test_circle_stays_on_its_radius_with_the_right_speed(self):
        one = machine("generic-3axis")
        run = states.circle(one, ("X", "Y"), (5, 6), 100.0, 1200.0, 0.0, 400, True, (1, 1))
        np.testing.assert_allclose(np.hypot(run.q["X"] - 5, run.q["Y"] - 6), 100.0)
        np.testing.assert_allclose(np.hypot(run.v["X"], run.v["Y"]), 20.0)
        np.testing.assert_allclose(np.gradient(run.q["X"], run.t)[1:-1], run.v["X"][1:-1], rtol=0, atol=0.02)


class Cases(unittest.TestCase):
    def test_same_seed_same_case_and_all_kinds_occur(self):
        kinds = {cases.category_of(seed) for seed in range(1, 200)}
        self.assertEqual(kinds, set(cases.CATEGORIES))
        first, again = cases.draw(2), cases.draw(2)
        for a, b in zip(first.files, again.files):
            for name in a.readings:
                np.testing.assert_array_equal(a.readings[name], b.readings[name])

    def test_files_follow_the_contract(self):
        seed = next(s for s in range(1, 300) if cases.category_of(s) == "pair")
        with tempfile.TemporaryDirectory() as place:
            case, folder = cases.draw(seed), pathlib.Path(place)
            cases.write(case, folder)
            model = json.loads((folder / "model.json").read_text(encoding="utf-8"))
            self.assertEqual(model["format"], "nineline-model/1")
            for path in sorted(folder.glob("*/*.csv")):
                self.check_file(path, case)

    def check_file(self, path, case):
        lines = path.read_text(encoding="utf-8").splitlines()
        head = [line for line in lines if line.startswith("#")]
        names, rows = lines[len(head)].split(","), lines[len(head) + 1:]
        self.assertEqual(head[0], "#nineline-measurement: 1")
        self.assertTrue(head[2].startswith("#instrument: "))
        self.assertEqual(len(set(names)), len(names))
        for name in names[1:]:
            self.assertRegex(name, r"_(mm|um|deg|arcsec|s|C|mm_min|deg_min|mm_s2|deg_s2|kg|1)$", path)
        for letter, joint in case.machine.joints.items():
            self.assertIn(f"{letter}_{joint.unit}", names)
        for row in rows:
            cells = row.split(",")
            self.assertEqual(len(cells), len(names))
            [float(cell) for cell in cells if cell]

    def test_fresh_campaign_is_the_truth_without_noise(self):
        seed = next(s for s in range(1, 300) if cases.category_of(s) == "single")
        case = cases.draw(seed)
        for file in case.fresh:
            again = cases.true_readings(case, file, case.hidden)
            for name, values in file.readings.items():
                np.testing.assert_array_equal(values, again[name])
        self.assertNotEqual(case.files[0].whole.t.tolist(), case.fresh[0].whole.t.tolist())

    def test_stated_amplitude_is_the_largest_change_in_sigmas(self):
        seed = next(s for s in range(1, 300) if cases.category_of(s) == "single")
        case = cases.draw(seed)
        largest = 0.0
        for file in case.files:
            with_it = cases.true_readings(case, file, case.hidden)
            without = cases.true_readings(case, file, [])
            for name in with_it:
                change = with_it[name] - without[name]
                change = change - change.mean() if file.instrument in readings.HAS_ZERO else change
                largest = max(largest, float(np.max(np.abs(change))) / file.sigma_of(name))
        self.assertAlmostEqual(largest, case.hidden[0]["amplitude_sigma"], delta=0.02 * largest)


if __name__ == "__main__":
    unittest.main()
