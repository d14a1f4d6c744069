# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs motorbenchctl and holds what it says against the contract that every verb has in common."""
import json
import multiprocessing
import os
import signal
import subprocess
import sys
import time
import unittest

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import ownhome  # noqa: E402 pylint: disable=wrong-import-position
from steady import ATTEMPTS, Lateness, counts  # noqa: E402 pylint: disable=wrong-import-position

PROGRAM = ""
SOURCE = ""
LIMIT = 120  # seconds; a program that hangs fails, a slow machine does not
TOGETHER = 6  # tests at a time: nearly all of their time they wait for motors and flash, which take as long as real ones

CIM = "sim:can/dmc60c:5"
EMPTY = "sim:can/dmc60c:9"
SCAN_ROW = {"device", "family", "address", "session", "name", "serial", "state", "firmware", "bootloader", "dialect", "detail"}
LINK_ROW = {"link", "kind", "state", "detail"}
FAULTS = "timeout refused bad-reply bad-check link-lost out-of-range unsupported cancelled unsafe usage".split()
SAMPLE = {"t", "channel", "value", "unit"}


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

    def cut(self, seconds, *arguments, number=signal.SIGINT):
        """Sends a signal to a run that heeds it and still goes on after so long; yields the status and both outputs."""
        with subprocess.Popen([PROGRAM, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
            try:
                heeds(process, number)
                with self.assertRaises(subprocess.TimeoutExpired):
                    process.wait(timeout=seconds)
                process.send_signal(number)
                out, err = process.communicate(timeout=LIMIT)
            finally:
                process.kill()
        return process.returncode, out, err


def heeds(process, number):
    """Waits until a program that was begun has its own way to end by this signal: before that it would be killed."""
    end = time.monotonic() + LIMIT
    while time.monotonic() < end and process.poll() is None:
        with open(f"/proc/{process.pid}/status", encoding="utf-8") as status:
            heeded = [int(line.split()[1], 16) for line in status if line.startswith(("SigCgt", "SigBlk"))]  # by a handler, or read
        if any(signals >> (number - 1) & 1 for signals in heeded):
            return
        time.sleep(0.02)
    raise AssertionError(f"{process.args}: no handler for {number}, status {process.poll()}")


def long(test):
    """Marks a test of more than ten seconds: it begins before the others, so that nobody waits for it at the end."""
    test.is_long = True
    return test


def every(tests):
    for test in tests:
        if isinstance(test, unittest.TestSuite):
            yield from every(test)
        else:
            yield test


def run_alone(test):
    """In a process of its own, with a memory of its own: its name, what became of it, its output and its seconds. A simulated unit
    answers in real time: one that fails while the machine held everybody up says nothing, and is run again."""
    begin = time.monotonic()
    for left in reversed(range(ATTEMPTS)):
        result = unittest.TestResult()
        with ownhome.move_in(), Lateness() as machine:
            unittest.TestSuite([test]).run(result)
        told = [text for _, text in result.failures + result.errors] + [f"{each}: passes now" for each in result.unexpectedSuccesses]
        if not told or counts(machine.worst, left, "\n".join(told)):
            break
    word = "ERROR" if result.errors else "FAIL" if told else "skipped" if result.skipped else "ok"
    return test.id(), word, "\n".join(told), time.monotonic() - begin


def run_beside(together, tests):
    """So many at a time: what became of each, and its output, by its name."""
    ended = {}
    with multiprocessing.get_context("fork").Pool(together, maxtasksperchild=1) as pool:
        for name, word, text, seconds in pool.imap_unordered(run_alone, tests, chunksize=1):
            print(f"{seconds:7.2f} s  {word:7}  {name}", flush=True)
            ended[name] = word, text
    return ended


def main(names):
    """Runs the tests of the program's own file, or those that are named (Class, Class.test), several at a time; yields the exit status."""
    loader, here = unittest.defaultTestLoader, sys.modules["__main__"]
    tests = list(every(loader.loadTestsFromNames(names, here) if names else loader.loadTestsFromModule(here)))
    tests.sort(key=lambda test: not hasattr(getattr(test, getattr(test, "_testMethodName", ""), None), "is_long"))
    begin, words, told = time.monotonic(), [], []
    ended = run_beside(TOGETHER, tests)
    failed = [test for test in tests if ended[test.id()][1]]
    for name, (word, text) in {**ended, **run_beside(1, failed)}.items():  # what failed, once more with nothing beside it
        words.append(word)
        if text:
            told.append(f"{'=' * 70}\n{word}: {name}\n{'-' * 70}\n{text}")
    print("\n".join(told), f"{'-' * 70}\nRan {len(tests)} tests in {time.monotonic() - begin:.3f}s\n", sep="\n")
    counts = ", ".join(f"{key}={words.count(word)}" for key, word in (("failures", "FAIL"), ("errors", "ERROR"), ("skipped", "skipped")) if word in words)
    print(("FAILED" if told or not tests else "OK") + (f" ({counts})" if counts else ""))
    return 1 if told or not tests else 0
