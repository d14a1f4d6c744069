# SPDX-License-Identifier: GPL-3.0-or-later
"""Programs that run beside a test on real CAN interfaces."""
import os
import signal
import subprocess
import sys
import threading
import time

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import steady  # noqa: E402 pylint: disable=wrong-import-position

ITS_GUARDIAN = 1.0  # s; it keeps the standard error of its program for as long as a stop is owed
PATIENCE = 90.0  # of the whole suite for one step; nothing is expected to take this long


class Lines:
    """The output of a program that keeps running, line by line, and what it complains of, which says whether it was held up."""

    def __init__(self, *command):
        self.lines = []
        self.complaints = []
        self.changed = threading.Condition()
        self.program = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.reader = threading.Thread(target=self.read, daemon=True)
        self.listener = threading.Thread(target=self.listen, daemon=True)
        self.reader.start()
        self.listener.start()

    def listen(self):
        with self.program.stderr as complained:
            for line in complained:
                self.complaints.append(line.rstrip("\n"))
                steady.complaints.append(line)
                print(line, end="", file=sys.stderr, flush=True)

    def read(self):
        for line in self.program.stdout:
            with self.changed:
                self.lines.append(line.rstrip("\n"))
                self.changed.notify_all()
        with self.changed:
            self.lines.append(None)
            self.changed.notify_all()

    def wait(self, fits, since=0):
        """The first line from `since` on that fits."""
        deadline = time.monotonic() + PATIENCE
        with self.changed:
            at = since
            while True:
                while at < len(self.lines):
                    line = self.lines[at]
                    if line is None:
                        self.listener.join(ITS_GUARDIAN)
                        raise AssertionError(f"{self.program.args} ended: {self.lines[-6:-1]} {self.complaints}")
                    if fits(line):
                        return line
                    at += 1
                if not self.changed.wait(deadline - time.monotonic()):
                    raise AssertionError(f"{self.program.args} did not print it in time: {self.lines[-5:]}")

    def stop(self, how=signal.SIGTERM):
        if self.program.poll() is None:
            self.program.send_signal(how)
        return self.stop_at_its_end()

    def stop_at_its_end(self):
        """The status of a program that ends by itself."""
        status = self.program.wait(PATIENCE)
        self.reader.join()
        self.listener.join(ITS_GUARDIAN)
        self.program.stdout.close()
        return status


class SteadyCase(steady.SteadyCase):
    """Test cases whose failures count only where the machine did not hold them, or a program beside them, up."""

    def beside(self, *command):
        """A program that does not outlive the case: its next attempt must find nobody on the bus."""
        program = Lines(*command)
        self.addCleanup(program.stop, signal.SIGKILL)
        return program
