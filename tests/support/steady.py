# SPDX-License-Identifier: GPL-3.0-or-later
"""Real time on a machine that others use: a case that fails while the machine held everybody up says nothing, and is run again."""
import functools
import sys
import threading
import time
import unittest

LOOK = 0.005  # s between two looks at the clock
HELD_UP = 0.05  # s; who sleeps and wakes later than that was not served
ATTEMPTS = 15
OWN_WORDS = "this program was held up", "the device is not heard any more"
complaints = []  # of programs that ran beside the present attempt


class Lateness:
    """How late this process itself was served, at worst, while the block ran."""

    def __enter__(self):
        self.worst = 0.0
        self.ended = threading.Event()
        self.watcher = threading.Thread(target=self.watch, daemon=True)
        self.watcher.start()
        return self

    def watch(self):
        while not self.ended.is_set():
            before = time.monotonic()
            time.sleep(LOOK)
            self.worst = max(self.worst, time.monotonic() - before - LOOK)

    def __exit__(self, *_):
        self.ended.set()
        self.watcher.join()


def counts(worst, left, told):
    """Whether a failure says something of the program: nobody was held up so long, or `left` is no more attempts. Who sleeps is served
    before who works, so a program that was held up says so itself, in what was `told`. Else the delay is printed."""
    if left == 0 or (worst < HELD_UP and not any(words in told for words in OWN_WORDS)):
        return True
    print(f"(this machine was held up for {1000 * worst:.0f} ms or more: once more)", file=sys.stderr, end=" ", flush=True)
    return False


def steadily(case):
    @functools.wraps(case)
    def attempts(self):
        for left in reversed(range(ATTEMPTS)):
            complaints.clear()
            with Lateness() as machine:
                try:
                    return case(self)
                except AssertionError:
                    failure = sys.exc_info()[1]
            if counts(machine.worst, left, "\n".join([str(failure), *complaints])):
                raise failure
            self.tearDown()
            self.doCleanups()
            self.setUp()
        return None
    return attempts


class SteadyCase(unittest.TestCase):
    """Test cases whose failures count only where the machine did not hold them up."""

    def __init_subclass__(cls, **options):
        super().__init_subclass__(**options)
        for name in dir(cls):
            case = getattr(cls, name)
            if name.startswith("test_") and callable(case) and not hasattr(case, "__wrapped__"):
                setattr(cls, name, steadily(case))
