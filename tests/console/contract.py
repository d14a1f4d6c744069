# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs motorbenchctl and holds what it says against the contract that every verb has in common."""
import json
import os
import subprocess
import tempfile
import unittest

PROGRAM = ""
SOURCE = ""
LIMIT = 120  # seconds; a program that hangs fails, a slow machine does not

CIM = "sim:can/dmc60c:5"
EMPTY = "sim:can/dmc60c:9"
SCAN_ROW = {"device", "family", "address", "session", "name", "serial", "state", "firmware", "bootloader", "dialect", "detail"}
LINK_ROW = {"link", "kind", "state", "detail"}
FAULTS = "timeout refused bad-reply bad-check link-lost out-of-range unsupported cancelled unsafe usage".split()
SAMPLE = {"t", "channel", "value", "unit"}


# What the programs keep of devices goes with the tests.
DATA = tempfile.TemporaryDirectory()
os.environ["XDG_DATA_HOME"] = DATA.name


class Run:
    """One finished run."""

    def __init__(self, arguments, text=None, environment=None):
        done = subprocess.run([PROGRAM, *arguments], input=text, capture_output=True, text=True, timeout=LIMIT, check=False,
                              env=environment)
        self.arguments = arguments
        self.status, self.out, self.err = done.returncode, done.stdout, done.stderr

    def objects(self):
        return [json.loads(line) for line in self.out.splitlines()]


class ContractTest(unittest.TestCase):
    def run_json(self, *arguments, status=0, text=None):
        """The objects of a run whose standard output is JSON only."""
        run = Run(["--json", *arguments], text)
        self.assertEqual(run.status, status, f"{arguments}: {run.err}")
        return run.objects()

    def run_one(self, *arguments, status=0):
        """The one object of a verb that does not stream."""
        objects = self.run_json(*arguments, status=status)
        self.assertEqual(len(objects), 1, arguments)
        return objects[0]

    def run_text(self, *arguments, status=0):
        run = Run(list(arguments))
        self.assertEqual(run.status, status, f"{arguments}: {run.err}")
        return run.out

    def assert_error(self, status, *arguments, says="", text=None):
        """One line on standard error that names cause and remedy, and nothing on standard output."""
        for options in ([], ["--json"]):
            with self.subTest(arguments=arguments, options=options):
                run = Run([*options, *arguments], text)
                self.assertEqual(run.status, status, run.err)
                self.assertEqual(run.out, "")
                self.assertEqual(run.err.count("\n"), 1, run.err)
                self.assertTrue(run.err.endswith("\n"), run.err)
                line = self.error_of(run, status) if options else run.err
                self.assertIn("; ", line)
                self.assertIn(says, line)

    def error_of(self, run, status):
        """The error that a run with --json ended with, as the line that it is without."""
        told = json.loads(run.err.splitlines()[-1])
        self.assertEqual(set(told), {"error"})
        error = told["error"]
        self.assertEqual(set(error), {"status", "fault", "cause", "remedy"})
        self.assertEqual(error["status"], status)
        self.assertIn(error["fault"], FAULTS)
        self.assertTrue(error["cause"] and error["remedy"], error)
        return f"{error['cause']}; {error['remedy']}"

    def run_until(self, number, *arguments, lines=20):
        """Sends a signal once so many lines came; yields the status, the objects and standard error."""
        with subprocess.Popen([PROGRAM, "--json", *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
            out = [process.stdout.readline() for _ in range(lines)]
            process.send_signal(number)
            rest, err = process.communicate(timeout=LIMIT)
        return process.returncode, [json.loads(line) for line in [*out, *rest.splitlines()] if line.strip()], err
