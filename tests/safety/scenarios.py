# SPDX-License-Identifier: GPL-3.0-or-later
"""What must end the motion of a motor, whatever its family and its link. A rig brings both:

    family, address, mode and target of a drive, `device` (the selector), `watchdog` (seconds, or None),
    start() makes the motor, pull() and plug_in() are its cable, first_order_is_stop(since) looks at what came first after it
    was back, and `motor`.

All times are of this machine's real-time clock: the signal's is taken before it is sent, that of the output is the simulator's.
"""
import os
import signal
import subprocess
import sys
import time

from bench import PATIENCE, Program
from rows import ROWS

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import ownhome  # noqa: E402, F401 pylint: disable=wrong-import-position,unused-import
from steady import SteadyCase  # noqa: E402, F401 pylint: disable=wrong-import-position,unused-import

ROUNDS = int(os.environ.get("MOTORBENCH_SAFETY_ROUNDS", "1"))
GUARDIAN = 0.7  # from the signal to the motor off, without a watchdog: 0.5 s of silence, and the way
BACK = 0.1  # from a link that can be opened again to the stop
DRIVES = 4  # that may be held up before one is not
RESUMES = 1.5  # so long an ended motion is watched
# A stall is shorter than what ends a stream, or longer; in between the machine's own lateness decides.
CERTAIN = 0.03


class Rounds:
    control = ""
    window = ""
    rig = None
    who, stopped_for_safety = "the program", 4  # its exit status

    def start_driving(self):
        return Program(self.control, "--json", "drive", self.rig.device, "--mode", self.rig.mode, "--target", self.rig.target, "--for", "600")

    def drive(self):
        """One that runs. A drive that this machine held up before anything was done to it has ended itself, rightly: again."""
        for _ in range(DRIVES):
            since = time.time()
            program = self.start_driving()
            self.addCleanup(program.end, signal.SIGKILL)
            if not self.rig.motor.await_output(True, since):
                self.fail(f"the motor was not started: {program.lines[-5:]}")
            time.sleep(0.4)
            if self.rig.motor.is_on():
                return program
            if not program.wait_for(lambda line: "this program was held up" in line, patience=5):
                break
        self.fail(f"it runs until something happens: {program.lines[-5:]}")
        return None

    def off_after(self, at, limit, message):
        off = self.rig.motor.await_output(False, at, 5)
        self.assertIsNotNone(off, message)
        self.assertLessEqual(off - at, limit, message)
        return off - at

    def stays_off(self, at, message):
        """What came before and after is told where it does not: which order it was that drove on, and when."""
        if not self.rig.motor.stays_off(RESUMES):
            self.fail(f"{message}: {self.rig.account(at - 0.4)}")

    def rounds(self):
        for _ in range(ROUNDS):
            try:
                self.rig.start()
                yield
            finally:
                self.rig.end()

    def by(self):
        return f"its watchdog, {1000 * self.rig.watchdog:.0f} ms" if self.rig.watchdog else "the guardian"

    def ends_with(self, number, what):
        """A signal that may be heard: the motor is off, stays so, and that was seen."""
        taken = []
        for _ in self.rounds():
            program = self.drive()
            at = time.time()
            program.send(number)
            taken.append(self.off_after(at, 0.25, what))
            self.assertEqual(program.process.wait(PATIENCE), 0, f"it was seen: {program.lines[-3:]}")
            self.stays_off(at, "what has ended does not resume")
        ROWS.add(self.rig.family, what, self.who, taken, 0.25)

    def silence(self):
        """A motor that nobody commands any more is off by then."""
        return self.rig.watchdog + 0.02 + CERTAIN if self.rig.watchdog else GUARDIAN


class FreezeScenarios(Rounds):
    """What happens to a program that drives a motor, and is killed or frozen."""

    def test_a_killed_program_leaves_no_motor_running(self):
        taken = []
        for _ in self.rounds():
            program = self.drive()
            at = time.time()
            program.send(signal.SIGKILL)
            taken.append(self.off_after(at, self.silence(), "killed"))
            self.stays_off(at, "what has ended does not resume")
            if not self.rig.watchdog:
                self.assertTrue(program.wait_for(lambda line: "motorbench-guardian: stopped " in line), f"confirmed by the device: {program.lines[-3:]}")
        ROWS.add(self.rig.family, f"{self.who} is killed", self.by(), taken, self.silence())

    def frozen(self, seconds):
        taken = []
        late = self.rig.watchdog or 0.25
        for _ in self.rounds():
            program = self.drive()
            at = time.time()
            program.send(signal.SIGSTOP)
            time.sleep(seconds)
            program.send(signal.SIGCONT)
            if seconds < late - CERTAIN:
                time.sleep(0.5)
                self.assertTrue(self.rig.motor.is_on(), "a short stall ends nothing")
                continue
            taken.append(self.off_after(at, max(self.silence(), seconds + 0.1), f"frozen for {seconds} s"))
            self.stays_off(at, "what was thawed does not drive on")
            self.assertEqual(program.process.wait(PATIENCE), self.stopped_for_safety, f"and says that it stopped for safety: {program.lines[-3:]}")
        stopped_by = "nothing needs to" if not taken else self.by() if seconds > 0.5 or self.rig.watchdog else f"{self.who} itself, thawed"
        ROWS.add(self.rig.family, f"{self.who} is frozen for {1000 * seconds:.0f} ms", stopped_by, taken, self.silence() if taken else None)

    def test_a_program_frozen_for_120_ms(self):
        self.frozen(0.12)

    def test_a_program_frozen_for_250_ms_drives_on_or_ends_and_never_resumes(self):
        """Exactly what ends a stream where there is no watchdog: which it is the machine's own lateness decides, once and for all."""
        if self.rig.watchdog:
            self.frozen(0.25)
            return
        taken = []
        for _ in self.rounds():
            program = self.drive()
            at = time.time()
            program.send(signal.SIGSTOP)
            time.sleep(0.25)
            program.send(signal.SIGCONT)
            time.sleep(0.5)
            ended = [when for when, on in self.rig.motor.events() if when >= at and not on]
            if not ended:
                self.assertTrue(self.rig.motor.is_on(), "it was in time: nothing happened")
                self.assertTrue(program.is_running())
                continue
            taken.append(ended[0] - at)
            self.assertLessEqual(taken[-1], GUARDIAN)
            self.stays_off(at, "what has ended does not resume")
            self.assertEqual(program.process.wait(PATIENCE), self.stopped_for_safety, f"and says that it stopped for safety: {program.lines[-3:]}")
        ROWS.add(self.rig.family, f"{self.who} is frozen for 250 ms", f"{self.who} itself, thawed, or nothing needs to", taken, GUARDIAN if taken else None)

    def test_a_program_frozen_for_300_ms_does_not_drive_on(self):
        self.frozen(0.3)

    def test_a_program_frozen_for_2_s_leaves_no_motor_running(self):
        self.frozen(2.0)


class MotionScenarios(FreezeScenarios):
    """What happens to the console while it drives a motor."""

    def test_ctrl_c_stops_the_motor(self):
        self.ends_with(signal.SIGINT, "Ctrl+C")

    def test_output_that_nobody_reads_keeps_neither_the_motion_nor_a_signal_waiting(self):
        taken = []
        for _ in self.rounds():
            since = time.time()
            with subprocess.Popen([self.control, "--json", "drive", self.rig.device, "--mode", self.rig.mode, "--target", self.rig.target,
                                   "--for", "600"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as program:
                self.addCleanup(program.kill)
                self.assertIsNotNone(self.rig.motor.await_output(True, since))
                time.sleep(6)  # a pipe holds 64 KiB
                if not self.rig.motor.is_on():
                    self.fail(f"set-points do not wait for a reader: {program.communicate(timeout=PATIENCE)[1]}")
                at = time.time()
                program.send_signal(signal.SIGTERM)
                taken.append(self.off_after(at, 0.25, "SIGTERM"))
                program.wait(PATIENCE)
        ROWS.add(self.rig.family, "SIGTERM while nobody reads the output", "the program", taken, 0.25)


class WindowScenarios(FreezeScenarios):
    """The same with the window's own engine, window and arming, on no screen."""

    who, stopped_for_safety = "the window", 1  # of tests/socketcan/windowdriver, which then says why

    def start_driving(self):
        link, _, unit = self.rig.device.rpartition("/")
        return Program(self.window, link, unit.split(":")[0], environment={**os.environ, "QT_QPA_PLATFORM": "offscreen"})

    def test_a_window_that_is_told_to_end_stops_the_motor_and_goes_once_that_is_seen(self):
        self.ends_with(signal.SIGTERM, "the window is told to end (SIGTERM)")


class CableScenarios(Rounds):
    """A cable that is pulled in the middle of a motion, and is back."""

    cable = "the cable is pulled"

    def cut(self, fault, after_the_cut):
        """The cable is pulled in the middle of a motion; what is left of the program is up to `after_the_cut`."""
        without_power, back = [], []
        for _ in self.rounds():
            program = self.drive()
            before = time.time()
            self.rig.pull()
            if self.rig.watchdog:
                taken = time.time() - before  # the last set-point went out somewhere in it
                without_power.append(self.off_after(before, self.silence() + taken, "the watchdog"))
            after_the_cut(program)
            time.sleep(1.5)
            self.assertEqual(self.rig.motor.is_on(), not self.rig.watchdog, "without a watchdog nothing can stop it")
            before = time.time()
            at = self.rig.plug_in()  # which takes a while, and the link can be opened before it is over
            if not self.rig.watchdog:
                off = self.rig.motor.await_output(False, before, 5)
                self.assertIsNotNone(off, "the stop that is owed")
                back.append(max(off - at, 0.0))
                self.assertLessEqual(back[-1], BACK + CERTAIN)
                self.assertTrue(self.rig.first_order_is_stop(before), "before anything else")
            self.stays_off(before, "motion does not resume by itself")
        if self.rig.watchdog:
            ROWS.add(self.rig.family, fault, self.by(), without_power, None)  # with the time that the pulling takes
        else:
            ROWS.add(self.rig.family, fault, "nothing: cut its power", [], None)
            ROWS.add(self.rig.family, fault + ", and is back", "the stop that is owed, the first on the line", back, BACK)

    def test_a_pulled_cable(self):
        self.cut(self.cable, lambda program: None)

    def test_a_pulled_cable_and_a_killed_program(self):
        self.cut(self.cable + ", then the program killed", lambda program: program.send(signal.SIGKILL))
