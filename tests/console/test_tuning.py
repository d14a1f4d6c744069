# SPDX-License-Identifier: GPL-3.0-or-later
"""test_tuning.py PROGRAM: experiments, the notebook and tuning by itself, on the simulated bench."""
import json
import os
import sys
import tempfile
import unittest

import contract
from contract import CIM, ContractTest, Run

LIVELY = "sim:can/dmc60c:7"
STEP = {"trial", "device", "mode", "axis", "slot", "stimulus", "gains", "metrics", "flags", "reason", "stopped", "samples", "lost"}
TUNE = {"result", "model", "gains", "predicted", "measured", "margins", "quality", "seconds", "trials", "evidence"}


class Step(ContractTest):
    def step(self, device, *arguments):
        row = self.run_one("step", device, *arguments)
        self.assertLessEqual(STEP, row.keys())
        self.assertEqual(row["reason"], "done")
        self.assertTrue(row["stopped"])
        self.assertEqual(row["lost"], 0)
        return row

    def test_unit_seven_overshoots_and_unit_five_does_not(self):
        lively = self.step(LIVELY, "--mode", "velocity", "--to", "60000")
        calm = self.step(CIM, "--mode", "velocity", "--to", "60000")
        self.assertGreater(lively["metrics"]["overshoot"], 0.1)
        self.assertLess(lively["metrics"]["overshoot"], 0.3)
        self.assertLessEqual(calm["metrics"]["overshoot"], 0.06)

    def test_every_family_steps(self):
        for device, mode, to in (("sim:can/abstractdc:3", "velocity", 4000), ("sim:serial/supermodified:4", "position", 400),
                                 ("sim:spi/quadquad2drv:0", "position", 1000)):
            with self.subTest(device=device):
                row = self.step(device, "--mode", mode, "--to", str(to))
                self.assertIsNotNone(row["metrics"]["rise"])

    def test_another_axis_of_a_board_steps_too(self):
        row = self.step("sim:spi/quadquad2drv:0", "--axis", "3", "--mode", "velocity", "--to", "2000")
        self.assertEqual(row["axis"], 3)

    def test_the_same_experiment_gives_the_same_samples(self):
        with tempfile.TemporaryDirectory() as folder:
            kept = []
            for name in ("a.json", "b.json"):
                path = os.path.join(folder, name)
                self.step(CIM, "--mode", "velocity", "--to", "40000", "--save", path)
                with open(path, encoding="utf-8") as file:
                    kept.append(json.load(file))
            for trial in kept:
                trial.pop("trial")
            self.assertEqual(*kept)

    def test_gains_tried_are_put_back(self):
        key = "slot0.p"
        before = self.run_one("get", LIVELY, key)
        self.step(LIVELY, "--mode", "velocity", "--to", "30000", "--set", f"{key}=0.5")
        self.assertEqual(self.run_one("get", LIVELY, key), before)

    def test_what_no_device_could_do_is_refused_with_status_two(self):
        self.assert_error(2, "step", CIM, "--mode", "sideways", "--to", "1")
        self.assert_error(2, "step", CIM, "--mode", "velocity", "--to", "1", "--profile", "zigzag")
        self.assert_error(2, "step", CIM, "--mode", "velocity", "--to", "9e9", says="--speed")

    def test_a_guard_ends_it_with_status_four_and_its_name(self):
        run = Run(["--json", "step", LIVELY, "--mode", "velocity", "--to", "60000", "--speed", "60000", "--set", "slot0.p=3"])
        self.assertEqual(run.status, 4, run.err)
        self.assertTrue(json.loads(run.err.splitlines()[-1])["error"]["cause"])


class Trials(ContractTest):
    def setUp(self):
        self.number = self.run_one("step", CIM, "--mode", "velocity", "--to", "20000")["trial"]

    def rows(self):
        return {row["trial"]: row for row in self.run_one("trials")["trials"]}

    def test_a_trial_is_kept_with_star_and_note_until_it_is_deleted(self):
        self.run_text("trials", "--star", str(self.number))
        self.run_text("trials", "--note", str(self.number), "with the new belt")
        row = self.rows()[self.number]
        self.assertLessEqual(STEP | {"time", "firmware", "unit", "simulated", "star", "note"}, row.keys())
        self.assertTrue(row["star"] and row["simulated"])
        self.assertEqual(row["note"], "with the new belt")
        self.run_text("trials", "--delete", str(self.number))
        self.assertNotIn(self.number, self.rows())

    def test_trials_leave_as_csv_and_json(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("all.csv", "all.json"):
                path = os.path.join(folder, name)
                self.run_text("trials", "--export", path)
                with open(path, encoding="utf-8") as file:
                    self.assertIn("overshoot", file.read())


class Tune(ContractTest):
    def test_a_proposal_names_model_gains_and_margins_and_writes_nothing(self):
        before = self.run_one("get", LIVELY)
        row = self.run_one("tune", LIVELY, "--loop", "velocity", "--propose")
        self.assertLessEqual(TUNE, row.keys())
        self.assertEqual(row["result"], "proposed")
        self.assertLessEqual({"gain", "tau", "delay", "friction", "unit", "filter", "window"}, row["model"].keys())
        self.assertEqual(row["model"]["filter"], "rolling")
        self.assertAlmostEqual(row["model"]["window"], 0.1, delta=0.01)
        self.assertLess(row["margins"]["ms"], 1.6)
        self.assertIsNone(row["measured"])
        self.assertEqual(self.run_one("get", LIVELY), before)

    def test_what_cannot_be_tuned_is_refused_before_anything_moves(self):
        self.assert_error(2, "tune", CIM, "--loop", "sideways")
        self.assert_error(2, "tune", CIM, "--loop", "velocity", "--aim", "reckless")
        self.assert_error(2, "tune", CIM, "--loop", "velocity", "--propose", "--store")
        self.assert_error(2, "tune", CIM, "--loop", "velocity", "--response", "0.1")


if __name__ == "__main__":
    contract.PROGRAM = sys.argv[1]
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]], verbosity=2)
