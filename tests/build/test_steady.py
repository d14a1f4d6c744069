#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""tests/support/steady.py: only a machine, or a program beside a case, that was late gives the case another try."""
import contextlib
import io
import pathlib
import sys
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import steady  # noqa: E402 pylint: disable=wrong-import-position


class Steady(unittest.TestCase):
    def outcome(self, lateness, failures, complaint=""):
        class Machine:
            worst = lateness

            def __enter__(self):
                return self

            def __exit__(self, *_):
                pass

        runs = []

        class Case(steady.SteadyCase):
            def test_it(self):
                runs.append(1)
                if len(runs) <= failures:
                    steady.complaints.append(complaint)
                self.assertGreater(len(runs), failures)

        usual, steady.Lateness = steady.Lateness, Machine
        try:
            with contextlib.redirect_stderr(io.StringIO()):
                result = unittest.TestResult()
                Case("test_it").run(result)
        finally:
            steady.Lateness = usual
        return result.wasSuccessful(), len(runs)

    def test_what_fails_on_a_machine_in_time_has_failed(self):
        self.assertEqual(self.outcome(0.0, 1), (False, 1))

    def test_what_fails_while_the_machine_was_held_up_runs_again(self):
        self.assertEqual(self.outcome(0.2, 2), (True, 3))

    def test_what_fails_beside_a_program_that_was_held_up_runs_again(self):
        self.assertEqual(self.outcome(0.0, 1, steady.OWN_WORDS[0]), (True, 2))

    def test_what_fails_beside_a_program_that_complains_of_something_else_has_failed(self):
        self.assertEqual(self.outcome(0.0, 1, "no such key"), (False, 1))

    def test_what_goes_on_failing_has_failed(self):
        self.assertEqual(self.outcome(0.2, 99), (False, steady.ATTEMPTS))


if __name__ == "__main__":
    unittest.main()
