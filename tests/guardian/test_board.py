# SPDX-License-Identifier: GPL-3.0-or-later
"""A board without watchdog on an SPI socket, simulated by another process, and the program that drives it killed or frozen:
    test_board.py MOTORBENCHCTL WINDOWDRIVER
Every motor stops within 700 ms of the signal (docs/safety.md). All times are of this machine's monotonic clock, that of
the stop is when the simulator's line about it was read. The output of the board is off when none of its four motors is on."""
import json
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import ownhome  # noqa: E402 pylint: disable=wrong-import-position

CONTROL = WINDOW = ""
LIMIT = 0.7
PATIENCE = 60


class Board:
    def __init__(self, test):
        folder = tempfile.TemporaryDirectory()
        test.addCleanup(folder.cleanup)
        self.link = "unix:" + os.path.join(folder.name, "board")
        self.process = subprocess.Popen([CONTROL, "--json", "simulate", "--on", self.link, "quadquad2drv:0"], stdout=subprocess.PIPE,
                                        text=True)
        test.addCleanup(self.process.communicate)
        test.addCleanup(self.process.kill)
        test.assertTrue(json.loads(self.process.stdout.readline())["ready"])
        self.events = []
        threading.Thread(target=self.listen, daemon=True).start()

    def listen(self):
        for line in self.process.stdout:
            self.events.append((time.monotonic(), json.loads(line)["event"]))

    def when(self, what, after=0.0):
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            for at, event in list(self.events):
                if event == what and at >= after:
                    return at
            time.sleep(0.002)
        return None

    def is_on(self):
        return [event for _, event in list(self.events) if event.startswith("output-")][-1:] == ["output-on"]


class Guarded(unittest.TestCase):
    def setUp(self):
        self.board = Board(self)
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def spawn(self, *command):
        environment = dict(os.environ, QT_QPA_PLATFORM="offscreen", XDG_DATA_HOME=self.folder.name,
                           XDG_RUNTIME_DIR=self.folder.name)
        process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        return process

    def ends(self, who, process, number):
        time.sleep(0.5)
        self.assertTrue(self.board.is_on(), "the motors run before the signal")
        at = time.monotonic()
        process.send_signal(number)
        off = self.board.when("output-off", after=at)
        self.assertIsNotNone(off, "the motors go on")
        print(f"SPI, {who}, {signal.Signals(number).name}: all off {1000 * (off - at):.0f} ms after the signal (limit 700)", flush=True)
        self.assertLess(off - at, LIMIT)
        time.sleep(0.5)
        self.assertFalse(self.board.is_on(), "they stay off")
        if number == signal.SIGSTOP:
            process.send_signal(signal.SIGCONT)
            time.sleep(1)
            self.assertFalse(self.board.is_on(), "the thawed program does not drive on")

    def console(self, number):
        drive = self.spawn(CONTROL, "--json", "drive", self.board.link + "/quadquad2drv:0", "--mode", "duty", "--target", "0.3",
                           "--axis", "3", "--for", "600")
        self.assertIsNotNone(self.board.when("output-on"))
        self.ends("console", drive, number)

    def window(self, number):
        window = self.spawn(WINDOW, self.board.link, "quadquad2drv")
        self.assertEqual(window.stdout.readline(), "driving\n", "all four motors turn")
        self.ends("window with four motors", window, number)

    def test_a_killed_console_leaves_no_motor_running(self):
        self.console(signal.SIGKILL)

    def test_a_frozen_console_leaves_no_motor_running(self):
        self.console(signal.SIGSTOP)

    def test_a_killed_window_leaves_none_of_four_motors_running(self):
        self.window(signal.SIGKILL)

    def test_a_frozen_window_leaves_none_of_four_motors_running(self):
        self.window(signal.SIGSTOP)


if __name__ == "__main__":
    CONTROL, WINDOW = (os.path.abspath(path) for path in sys.argv[1:3])
    with ownhome.move_in():
        unittest.main(argv=[sys.argv[0], "-v", *sys.argv[3:]])
