# SPDX-License-Identifier: GPL-3.0-or-later
"""A program that is killed in the middle of an experiment, or of the proof of a tuning: the motor, the gains that were tried, and the
notebook.

Beside what a Rounds rig brings: `gain` (its key), `loop` (options of step), `far_enough` (counts), `stores_after` (seconds,
after which it has stored what was written; 0: at once); for a tuning `tuning` (options of tune), `tried` (keys that its proof writes), and
`written`, where gains cannot be read: KEY=VALUE that are written once, so that they can be put back, and `known`, such that its user knows.
"""
import json
import os
import signal
import sqlite3
import subprocess
import tempfile
import time

from bench import PATIENCE, Program
from rows import ROWS
from scenarios import Rounds

RESUMES_NOT = 1.0  # so long the motor is watched
IN_A_PROOF = 0.2  # seconds
ATTEMPTS = 10  # a machine that is busy loses samples, and a guard ends the trial


class KilledCase(Rounds):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.environment = dict(os.environ, XDG_DATA_HOME=folder.name, XDG_RUNTIME_DIR=folder.name)

    def run_control(self, *arguments, status=0):
        done = subprocess.run([self.control, "--json", *arguments], capture_output=True, text=True, env=self.environment,
                              timeout=2 * PATIENCE, stdin=subprocess.DEVNULL, check=False)
        if status is not None:
            self.assertEqual(done.returncode, status, f"{arguments}: {done.stderr}")
        return json.loads((done.stdout.splitlines() or ["null"])[-1]), done.stderr

    def owed(self):
        """Values that the notebook still wants put back for good."""
        book = os.path.join(self.environment["XDG_DATA_HOME"], "motorbench", "motorbench.db")
        with sqlite3.connect(book) as database:
            return database.execute("SELECT count(*) FROM owed").fetchone()[0]

    def gain(self):
        return self.run_control("get", self.rig.device, self.rig.gain)[0]["parameters"][self.rig.gain]["raw"]

    def step(self, *more):
        """What it says on standard error. How the experiment ends is not judged: this machine may be busy."""
        return self.run_control("step", self.rig.device, *self.rig.loop, *more, status=None)[1]

    def assert_owed(self, trial):
        """The next connection asks, and nobody answers; then it is told to, and once is enough."""
        said = self.step()
        self.assertIn(f"trial {trial} did not put back", said, "it asks, and nobody answers")
        self.assertIn("--yes", said)
        said = self.step("--yes")
        self.assertIn(f"is put back, owed by trial {trial}", said)
        self.assertNotIn("put back", self.step(), "once is enough")


class TrialScenarios(KilledCase):
    def try_gain(self, value):
        """A program in the middle of a trial of another gain, the motor far from where it was."""
        for _ in range(ATTEMPTS):
            program = Program(self.control, "--json", "step", self.rig.device, *self.rig.loop, "--profile", "sine", "--time", "60",
                              "--set", f"{self.rig.gain}={value}", "--samples", environment=self.environment)
            self.addCleanup(program.end, signal.SIGKILL)

            def decides(line):  # far away, or over before
                return '"reason"' in line or ('"channel":"position"' in line and abs(json.loads(line)["value"]) > self.rig.far_enough)

            line = program.wait_for(decides)
            if line and '"reason"' not in line and self.rig.motor.is_on():
                return program
            program.end()  # a busy machine: a guard ended it, and its gains are put back
        self.fail(f"it does not go: {program.lines[-5:]}")
        return None

    def value(self):
        return self.run_control("get", self.rig.device, self.rig.gain)[0]["parameters"][self.rig.gain]["value"]

    def test_a_killed_trial_stops_is_kept_as_aborted_and_its_gains_go_back_after_asking(self):
        taken = []
        for _ in self.rounds():
            before, tried = self.gain(), round(self.value() * 0.9, 3)
            program = self.try_gain(tried)
            at = time.time()
            program.send(signal.SIGKILL)
            taken.append(self.off_after(at, self.silence(), "killed in a trial"))
            self.assertTrue(self.rig.motor.stays_off(RESUMES_NOT))
            self.assertNotEqual(self.gain(), before, "nobody has put it back yet")
            row = self.run_control("trials")[0]["trials"][-1]
            self.assertIn("aborted", row["flags"])
            self.assertAlmostEqual(row["gains"][self.rig.gain], tried, 2)
            self.assertFalse(row["simulated"])
            said = self.step()
            self.assertIn(f"trial {row['trial']} did not put back", said, "it asks, and nobody answers")
            self.assertIn("--yes", said)
            self.assertNotEqual(self.gain(), before)
            said = self.step("--yes")
            self.assertIn(f"is put back, owed by trial {row['trial']}", said)
            self.assertEqual(self.gain(), before)
            said = self.step()
            self.assertNotIn("put back", said, "once is enough")
            if self.rig.stores_after:
                self.assertGreaterEqual(self.owed(), 1, "in force, and its flash may still have what was tried")
                time.sleep(self.rig.stores_after)
                self.assertNotIn("put back", self.step())
            self.assertEqual(self.owed(), 0)
        ROWS.add(self.rig.family, "the program is killed in a trial", self.by(), taken, self.silence())


class TuneScenarios(KilledCase):
    """Killed while it proves: what is tried is in the slot that does not run where there are two, else in the only one."""

    def tried(self):
        """As the unit itself has them, whatever this program takes them for; of one that cannot be read, all."""
        if self.rig.written:
            return self.rig.motor.gains()
        rows = self.run_control("get", self.rig.device, *self.rig.tried)[0]["parameters"]
        return {key: row["raw"] for key, row in rows.items()}

    def write_once(self):
        self.run_control("info", self.rig.device, *(word for known in self.rig.known for word in ("--keep", known)))
        self.run_control("set", self.rig.device, *self.rig.written)
        self.assertTrue(self.rig.motor.await_gains({key: int(value) for key, value in (word.split("=") for word in self.rig.written)}))

    def prove(self):
        """A program in the middle of its first proof, the motor on its way."""
        for _ in range(ATTEMPTS):
            program = Program(self.control, "--json", "tune", self.rig.device, *self.rig.tuning, environment=self.environment)
            self.addCleanup(program.end, signal.SIGKILL)
            line = program.wait_for(lambda line: "proving:" in line or '"result"' in line or '"error"' in line, patience=3 * PATIENCE)
            if line and "proving:" in line and self.rig.motor.await_output(True, time.time()):
                time.sleep(IN_A_PROOF)
                if program.is_running():
                    return program
            program.end()  # a busy machine: a guard ended it before it proved anything
        self.fail(f"it proves nothing: {program.lines[-5:]}")
        return None

    def test_a_killed_proof_stops_and_all_that_it_tried_goes_back_after_asking(self):
        taken = []
        for _ in self.rounds():
            if self.rig.written:
                self.write_once()
            before = self.tried()
            program = self.prove()
            at = time.time()
            program.send(signal.SIGKILL)
            taken.append(self.off_after(at, self.silence(), "killed in a proof"))
            self.assertTrue(self.rig.motor.stays_off(RESUMES_NOT))
            left = self.tried()
            for key in self.rig.tried:
                self.assertNotEqual(left[key], before[key], f"{key}: nobody has put it back yet")
            row = self.run_control("trials")[0]["trials"][-1]
            self.assertIn("aborted", row["flags"])
            self.assertGreaterEqual(self.owed(), len(self.rig.tried))
            self.assert_owed(row["trial"])
            self.assertEqual(self.tried(), before)
        ROWS.add(self.rig.family, "the program is killed while it proves gains", self.by(), taken, self.silence())
