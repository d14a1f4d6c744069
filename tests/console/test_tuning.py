# SPDX-License-Identifier: GPL-3.0-or-later
"""test_tuning.py PROGRAM: experiments, the notebook and tuning by itself, on the simulated bench."""
import contextlib
import json
import os
import re
import signal
import sqlite3
import subprocess
import sys
import tempfile

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

    @contract.long
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
        self.assert_error(2, "step", CIM, "--mode", "velocity", "--to", "9e9", says="speed 9000000000 is outside the envelope")

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
        self.run_text("trials", "--note", str(self.number), "")
        self.assertFalse(self.rows()[self.number]["note"], "an empty note takes the note away")
        self.run_text("trials", "--delete", str(self.number))
        self.assertNotIn(self.number, self.rows())

    def test_what_is_wrong_in_a_call_of_trials_changes_nothing(self):
        before = self.run_text("trials")
        number = str(self.number)
        self.assert_error(2, "trials", "--star", number, "--note", "abc", "text", says="--note")
        self.assert_error(2, "trials", "--star", number, "--delete", "0", says="--delete")
        self.assert_error(2, "trials", "sim:can/dmc60c:7", "--delete", number, says="not one of sim:can/dmc60c:7")
        self.assert_error(2, "trials", "--delete", number, "--export", "/nowhere/trials.csv", says="/nowhere")
        self.assertNotEqual(Run(["trials", "--star", number, "--note", "999999", "text"]).status, 0)
        self.assertEqual(self.run_text("trials"), before)

    def test_trials_leave_as_csv_and_json(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("all.csv", "all.json"):
                path = os.path.join(folder, name)
                self.run_text("trials", "--export", path)
                with open(path, encoding="utf-8") as file:
                    self.assertIn("overshoot", file.read())


class Tune(ContractTest):
    @contract.long
    def test_a_proposal_names_model_gains_and_margins_and_writes_nothing(self):
        before = self.run_one("get", LIVELY)
        row = self.run_one("tune", LIVELY, "--loop", "velocity", "--propose")
        self.assertLessEqual(TUNE, row.keys())
        self.assertEqual(row["result"], "proposed")
        for key, gain in row["gains"].items():
            self.assertEqual(gain["from"], before["parameters"][key]["value"])
        self.assertLessEqual({"gain", "tau", "delay", "friction", "unit", "filter", "window"}, row["model"].keys())
        self.assertEqual(row["model"]["filter"], "rolling")
        self.assertAlmostEqual(row["model"]["window"], 0.1, delta=0.01)
        self.assertLess(row["margins"]["ms"], 1.6)
        self.assertIsNone(row["measured"])
        few = [key for key, gain in row["gains"].items() if key.split(".")[1] in "pid" and 0 < abs(gain["raw"]) < 50]
        self.assertEqual(sorted(note.split(" is ")[0] for note in row["notes"]), sorted(["F", *few]))
        self.assertEqual(self.run_one("get", LIVELY), before)
        self.assertLessEqual({"load", "load_error", "forward", "reverse", "noise", "latency"}, row["model"].keys())
        for way in ("forward", "reverse"):
            self.assertAlmostEqual(row["model"][way], row["model"]["gain"], delta=0.03 * row["model"]["gain"])
        self.assertLess(abs(row["model"]["load"]), 0.01)
        self.assertTrue(0 < row["model"]["latency"] < 0.1, row["model"])
        told = [gate for gate in row["quality"] if gate["gate"] == "ramp"]
        self.assertEqual([(gate["passed"], gate["warns"]) for gate in told], [(True, False)], row["quality"])
        self.assertRegex(told[0]["detail"], r"^it lets go at [\d.]+ V forwards and [\d.]+ V backwards")
        self.assertAlmostEqual(row["profile"]["acceleration"], row["profile"]["speed"] / row["model"]["tau"], delta=0.01 * row["profile"]["acceleration"])

    @contract.long
    def test_every_stimulus_is_announced_with_duty_speed_and_travel_and_the_text_tells_both_ways(self):
        run = Run(["tune", CIM, "--loop", "velocity", "--travel", "400000", "--speed", "90000", "--propose"])
        self.assertEqual(run.status, 0, run.err)
        told = re.findall(r"at most ([\d.]+) % duty, ([\d.e+]+) counts/s and ([\d.e+]+) counts from where it stands", run.err)
        self.assertEqual(len(told), run.err.count("pushing with "), run.err)
        self.assertGreaterEqual(len(told), 5)
        for _, speed, travel in told:
            self.assertLessEqual(float(speed), 110000) # the guard of 90000 lets a fifth more pass: 108000, in two digits
            self.assertLessEqual(float(travel), 400000)
        self.assertLess(min(float(travel) for _, _, travel in told[1:]), 400000, "what is expected, not only its limit")
        self.assertNotIn("e-", run.out.split("noise at rest")[1].split("counts")[0], "a position that stands has no noise")
        self.assertIn("pushing with a duty that grows to", run.err)
        for row in ("breakaway forward", "friction reverse", "load one way", "gain forward", "gain reverse", "noise at rest", "order to motion", "profile:", "F is 0"):
            self.assertIn(row, run.out)

    @contract.long
    def test_a_position_loop_without_a_duty_command_is_tuned_by_trying_its_gains(self):
        row = self.run_one("tune", "sim:serial/supermodified:5", "--loop", "position")
        self.assertLessEqual(TUNE, row.keys())
        self.assertEqual(row["result"], "kept", row["evidence"])
        self.assertLessEqual(row["measured"]["overshoot"], 0.05)
        self.assertEqual(set(row["gains"]), {"gain.p", "gain.i", "gain.d"})
        self.assertIn("counts/s per", row["model"]["unit"])

    @contract.long
    def test_a_current_loop_is_tuned(self):
        row = self.run_one("tune", CIM, "--loop", "current")
        self.assertEqual(row["result"], "kept", row["evidence"])
        self.assertNotIn("stored", row["evidence"])
        self.assertEqual(row["model"]["unit"], "A per duty")
        self.assertLessEqual(row["measured"]["overshoot"], 0.05)

    @contract.long
    def test_only_what_is_kept_is_stored_and_only_where_that_is_asked_for(self):
        row = self.run_one("tune", CIM, "--loop", "current", "--store")
        self.assertEqual(row["result"], "kept", row["evidence"])
        self.assertIn("the unit has stored them", row["evidence"])
        run = Run(["--json", "tune", CIM, "--loop", "velocity", "--store", "--travel", "3000"])
        row = json.loads(run.out)
        self.assertEqual((row["result"], run.status), ("refused", 1), run.err)
        self.assertNotIn("stored", row["evidence"])

    def test_what_cannot_be_tuned_is_refused_before_anything_moves(self):
        self.assert_error(2, "tune", "sim:can/abstractdc:3", "--loop", "current")
        for device in ("sim:can/abstractdc:3", "sim:spi/quadquad2drv:0"):  # nobody has written its gains
            run = Run(["--json", "tune", device, "--loop", "velocity"])
            self.assertEqual((run.status, run.out), (2, ""), run.err)
            self.assertIn("cannot be read, so it could not be put back", self.error_of(run, 2))
            self.assertNotIn("pushing", run.err)
        self.assert_error(2, "tune", "sim:serial/supermodified:4", "--loop", "velocity")
        self.assert_error(2, "tune", CIM, "--loop", "sideways")
        self.assert_error(2, "tune", CIM, "--loop", "velocity", "--aim", "reckless")
        self.assert_error(2, "tune", CIM, "--loop", "velocity", "--propose", "--store")
        self.assert_error(2, "tune", CIM, "--loop", "velocity", "--response", "0.1")
        self.assert_error(2, "tune", CIM, "--loop", "velocity", "--response", "0.1", "--damping", "1.71")
        self.assert_error(2, "tune", "sim:can/abstractdc:3", "--loop", "position", "--keep", "--duty", "0.4")

    def test_where_nothing_can_be_saved_nothing_moves(self):
        for path in ("/nonexistent/x", "/"):
            self.assert_error(2, "tune", CIM, "--loop", "velocity", "--propose", "--save", path, says="cannot be written")
            self.assert_error(2, "step", CIM, "--mode", "velocity", "--to", "2000", "--save", path, says="cannot be written")

    def test_what_cannot_be_saved_after_the_motor_has_turned_is_no_wrong_usage(self):
        run = Run(["--json", "step", CIM, "--mode", "velocity", "--to", "2000", "--time", "0.3", "--save", "/dev/full"])
        self.assertEqual(run.status, 1, run.err)
        self.assertIn("disk is full", run.err)


class Owed(ContractTest):
    """Gains that an experiment left on trial, because its program was killed."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.environment = dict(os.environ, XDG_DATA_HOME=self.folder.name)
        self.run_here("step", CIM, "--mode", "velocity", "--to", "2000", "--time", "0.3", "--set", "slot0.p=0.2")
        with contextlib.closing(sqlite3.connect(os.path.join(self.folder.name, "motorbench", "motorbench.db"))) as notebook, notebook:
            notebook.execute("INSERT INTO owed (unit, key, trial, raw, tried, put_back, time) SELECT unit, 'slot0.p', id, 65536, NULL, 0, time FROM trial")

    def run_here(self, *words):
        run = Run(words, environment=self.environment)
        self.assertEqual(run.status, 0, run.err)
        return run

    def test_info_tells_what_an_experiment_left_on_trial(self):
        remedy = f"trial 1 did not put back what it changed; 'motorbenchctl set {CIM} slot0.p=1' does"
        self.assertIn(remedy, self.run_here("info", CIM).out)
        self.assertIn(remedy, self.run_here("--json", "info", CIM).err)

    def test_whoever_reads_drives_or_keeps_what_is_there_is_told_too(self):
        for words in (["get", CIM, "slot0.p"], ["snapshot", CIM, "--name", "x"], ["report", CIM, "--out", os.path.join(self.folder.name, "r.html")],
                      ["drive", CIM, "--mode", "velocity", "--target", "1000", "--for", "0.1"]):
            self.assertIn("trial 1 did not put back what it changed", self.run_here(*words).err, words)

    def test_set_tells_it_before_it_writes_others_of_its_values(self):
        self.assertIn("trial 1 did not put back", self.run_here("set", CIM, "slot0.i=0.001").err)
        self.assertNotIn("put back", self.run_here("set", CIM, "slot0.p=1").err)


class Trouble(ContractTest):
    """What ends a tuning ends it with its word and its status: results of `tune` in docs/tuning.md."""

    def ended(self, status, device, *arguments):
        run = Run(["--json", "tune", device, "--loop", "velocity", *arguments])
        self.assertEqual(run.status, status, run.err)
        row = json.loads(run.out)
        self.assertLessEqual(TUNE, row.keys())
        self.assertTrue(row["evidence"])
        return row, run

    def ended_in_error(self, status, word, device, *arguments):
        row, run = self.ended(status, device, *arguments)
        self.assertEqual(row["result"], "stopped")
        self.assertIn(word, self.error_of(run, status))
        return row

    def test_a_sensor_that_counts_the_other_way_is_stopped_by_its_guard(self):
        row = self.ended_in_error(4, "wrong direction", "sim:can?fault=encoder-reversed/dmc60c:5")
        self.assertTrue(row["stopped"])
        self.assertEqual(row["gains"], {})

    def test_a_motor_that_stalls_is_stopped_by_its_guard(self):
        row = self.ended_in_error(4, "no motion", "sim:can?fault=stall@1/dmc60c:5")
        self.assertTrue(row["stopped"])

    def test_a_unit_that_falls_silent_is_a_lost_link_and_nobody_saw_it_stop(self):
        row = self.ended_in_error(5, "link was lost", "sim:can?fault=silent@700/dmc60c:5")
        self.assertFalse(row["stopped"])

    def test_a_unit_that_loses_its_power_for_a_moment_is_stopped_by_its_guard(self):
        row = self.ended_in_error(4, "restarted", "sim:can?fault=power@900/dmc60c:5")
        self.assertTrue(row["stopped"])

    def test_what_leaves_no_room_to_identify_is_refused_with_status_one_and_no_gain_changes(self):
        row, run = self.ended(1, CIM, "--travel", "3000")
        self.assertEqual((row["result"], row["stopped"], row["gains"]), ("refused", True, {}))
        self.assertIn("room", row["evidence"], run.err)

    def test_a_signal_interrupts_it_and_the_gains_are_as_before(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with subprocess.Popen([contract.PROGRAM, "--json", "tune", CIM, "--loop", "velocity"], stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, text=True) as process:
                for line in process.stderr:
                    if "pushing" in line:
                        break
                process.send_signal(number)
                out, err = process.communicate(timeout=contract.LIMIT)
            row = json.loads(out)
            self.assertEqual(process.returncode, 4, err)
            self.assertEqual((row["result"], row["stopped"], row["gains"]), ("stopped", True, {}))
            self.assertIn("interrupted", err)


class Refused(ContractTest):
    """What ends before anything was sent leaves nothing behind."""

    def test_a_tuning_that_is_refused_at_once_takes_no_snapshot(self):
        for device in ("sim:spi/quadquad2drv:0", "sim:can/abstractdc:3"):
            self.assert_error(2, "tune", device, "--loop", "velocity", says="write the gains of this loop once, or give --keep")
        self.assert_error(2, "step", "sim:spi/quadquad2drv:0", "--mode", "velocity", "--to", "300", "--set", "ch1.velocity.p=10", says="or give --keep")
        self.assertEqual(self.run_one("snapshots"), {"snapshots": []})
        self.assertEqual(self.run_one("trials"), {"trials": []})

    def test_nothing_is_announced_that_the_notebook_then_refuses(self):
        self.run_one("snapshots")
        path = os.path.join(os.environ["XDG_DATA_HOME"], "motorbench", "motorbench.db")
        with contextlib.closing(sqlite3.connect(path)) as database, database:
            database.execute("CREATE TRIGGER full BEFORE INSERT ON snapshot BEGIN SELECT RAISE(ABORT, 'database or disk is full'); END")
        for device, loop in ((CIM, "velocity"), ("sim:serial/supermodified:4", "position")):
            run = Run(["tune", device, "--loop", loop])
            self.assertEqual((run.status, run.out, run.err.count("\n")), (2, "", 1), run.err)

    def test_the_search_for_scales_is_refused_too_where_gains_could_not_be_put_back(self):
        self.assert_error(2, "tune", "sim:spi/quadquad2drv:0", "--loop", "velocity", "--propose", says="could not be put back")

    def test_a_beginning_that_is_not_reached_ends_by_the_guard_of_the_time(self):
        run = Run(["--json", "step", "sim:can/abstractdc:3", "--mode", "position", "--from", "300", "--to", "320"])
        self.assertEqual(run.status, 4, run.err)
        row = run.objects()[-1]
        self.assertEqual((row["reason"], row["stopped"]), ("time", True))
        self.assertIn("aborted", row["flags"])
        self.assertIn("away from where the experiment begins", run.err)

    def test_a_notebook_that_cannot_be_opened_is_one_line_of_what_needs_it(self):
        with tempfile.NamedTemporaryFile() as file:
            environment = dict(os.environ, XDG_DATA_HOME=file.name)
            for call in (["snapshot", CIM], ["snapshots"], ["trials"], ["journal"], ["rename", "sim:serial/supermodified:4", "arm"],
                         ["tune", CIM, "--loop", "velocity"], ["tune", CIM, "--loop", "velocity", "--keep"],
                         ["tune", "sim:serial/supermodified:4", "--loop", "position", "--propose"], ["step", CIM, "--mode", "velocity", "--to", "2000", "--set", "slot0.p=1"],
                         ["restore", CIM, "snapshot:1"], ["diff", CIM, "snapshot:1"], ["report", "trial:1", "--out", file.name + ".html"]):
                for options in ([], ["--json"]):
                    with self.subTest(call=call, options=options):
                        run = Run([*options, *call], environment=environment)
                        self.assertEqual((run.status, run.out), (2, ""), run.err)
                        self.assertEqual(run.err.count("\n"), 1, run.err)
                        self.assertIn(file.name, run.err)
            run = Run(["set", CIM, "slot0.p=1"], environment=environment)
            self.assertEqual(run.status, 0)
            self.assertIn("nothing is kept of this", run.err)

    def test_a_notebook_of_a_newer_version_is_left_alone(self):
        self.run_one("snapshot", CIM)
        path = os.path.join(os.environ["XDG_DATA_HOME"], "motorbench", "motorbench.db")
        with contextlib.closing(sqlite3.connect(path)) as database:
            database.execute("PRAGMA user_version = 99")
        for call in (["snapshot", CIM], ["snapshots"], ["trials"], ["rename", "sim:serial/supermodified:4", "arm"], ["tune", CIM, "--loop", "velocity"]):
            self.assert_error(2, *call, says="newer version")
        with contextlib.closing(sqlite3.connect(path)) as database:
            database.execute("PRAGMA user_version = 8")
            database.execute("DROP TABLE trial")
        self.assert_error(2, "trials", says="move it away")


class StoredGains(ContractTest):
    """Units of the bench but 7 step well with the gains that they store."""

    def overshoot(self, device, mode, target, *more):
        row = self.run_json("step", device, "--mode", mode, "--to", str(target), *more)[-1]
        self.assertEqual(row["reason"], "done")
        self.assertNotIn("did-not-move", row["flags"], (device, mode, target))
        return row["metrics"]["overshoot"]

    @contract.long
    def test_loops_of_a_board_do_not_overshoot(self):
        for axis, speeds in (("1", (500, -1200)), ("2", (700, -800)), ("3", (500, -700)), ("4", (-500, 1000))):
            for speed in speeds:
                self.assertLessEqual(self.overshoot("sim:spi/quadquad2drv:0", "velocity", speed, "--axis", axis), 0.05, (axis, speed))

    @contract.long
    def test_a_drive_whose_gains_nobody_knows_moves_and_does_not_overshoot(self):
        for target in (2000, -3000):
            self.assertLessEqual(self.overshoot("sim:can/abstractdc:5", "velocity", target), 0.05, target)


class Report(ContractTest):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.number = self.run_one("step", LIVELY, "--mode", "velocity", "--to", "20000")["trial"]

    def tearDown(self):
        self.folder.cleanup()

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def html(self, *subjects):
        self.run_text("report", *subjects, "--out", self.path("a.html"))
        with open(self.path("a.html"), encoding="utf-8") as file:
            return file.read()

    def test_a_trial_is_told_with_its_unit_curves_gains_and_history(self):
        text = self.html(f"trial:{self.number}")
        for word in ("DMC60C 7", "Serial number", f"Trial {self.number}, velocity loop", "<svg ", "Overshoot", "slot0.p", "History of the unit", "DEMO"):
            self.assertIn(word, text)

    @contract.long
    def test_a_unit_is_told_with_its_tuning_and_its_parameters_against_their_defaults(self):
        self.run_one("tune", LIVELY, "--loop", "velocity", "--propose")
        text = self.html(LIVELY)
        for word in ("Tuning of the velocity loop", "Proposed, nothing was written", "Lag τ", "Sensitivity peak Ms", "differ from their default",
                     "current_limit.continuous", "Bootloader"):
            self.assertIn(word, text)

    def test_a_pdf_is_made_without_a_screen(self):
        if not os.path.exists(os.path.join(os.path.dirname(contract.PROGRAM), "motorbench")):
            self.skipTest("motorbench is not built")
        environment = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")}
        for subject in (f"trial:{self.number}", LIVELY):
            run = Run(["report", subject, "--out", self.path("a.pdf")], environment=environment)
            self.assertEqual((run.status, run.out, run.err), (0, "", ""), subject)
            with open(self.path("a.pdf"), "rb") as file:
                self.assertTrue(file.read().startswith(b"%PDF-"))
            os.remove(self.path("a.pdf"))

    def test_what_cannot_be_is_refused_with_status_two_and_leaves_nothing(self):
        trial = f"trial:{self.number}"
        self.assert_error(2, "report", trial, says="--out")
        self.assert_error(2, "report", "--out", self.path("a.pdf"), says="device or trials")
        self.assert_error(2, "report", trial, "--out", self.path("a.doc"), says="a.doc")
        for kind in ("pdf", "html"):
            self.assert_error(2, "report", trial, "--out", f"/nonexistent/a.{kind}", says=f"/nonexistent/a.{kind}")
            self.assert_error(2, "report", "trial:4000000", "--out", self.path("a." + kind), says="no trial 4000000")
            self.assert_error(2, "report", "trial:x", "--out", self.path("a." + kind), says="trial")
            self.assert_error(3, "report", "sim:can/dmc60c:44", "--out", self.path("a." + kind))
        self.assert_error(2, "report", trial, LIVELY, "--out", self.path("a.pdf"), says="leave one of them out")
        self.assertEqual(os.listdir(self.folder.name), [])


if __name__ == "__main__":
    contract.PROGRAM = sys.argv[1]
    sys.exit(contract.main(sys.argv[2:]))
