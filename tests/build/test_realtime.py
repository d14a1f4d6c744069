#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests that look at the computer's clock carry the label `realtime`: docs/testing.md#real-time."""
import pathlib
import re
import unittest

TESTS = pathlib.Path(__file__).resolve().parents[1]
LOOKS = re.compile(r"\bsleep [0-9.]+\b|loop\.clock\(\)\.now\(\)|\bmsleep\(|PaintBudget::Clock::now\(\)")
ASSERTED = re.compile(r"(?:EXPECT|ASSERT)_(?:LT|LE|GT|GE)\([^;]*(?:steady_clock|wall\b|\belapsed\(\))|QVERIFY2?\([^;]*\belapsed\(\)|QCOMPARE\([^;]*\belapsed\(\)")


def sources(folder, pattern):
    return [(path, path.read_text(encoding="utf-8")) for path in sorted((TESTS / folder).glob(pattern))]


class RealTime(unittest.TestCase):
    def test_suites_that_look_at_the_clock_are_among_those_in_real_time(self):
        areas = {found[1]: set(found[2].split()) for found in re.finditer(
            r"area_test\((\w+)[^)]*?REALTIME ([^)]*)\)", (TESTS / "CMakeLists.txt").read_text(encoding="utf-8"))}
        self.assertTrue(areas)
        for area in ("async", "wire", "transport", "model", "recording", "tuning", "report", "settings", "storage", "service", "families"):
            looking = {suite for _, text in sources(area, "test_*.cpp") if LOOKS.search(text)
                       for suite in re.findall(r"(?m)^TEST(?:_F|_P)?\((\w+)", text)}
            with self.subTest(area):
                self.assertEqual(looking, areas.get(area, set()))

    def test_widgets_that_look_at_the_clock_are_among_those_in_real_time(self):
        labelled = re.search(r"set_tests_properties\(([^)]*) PROPERTIES LABELS realtime\)", (TESTS / "widgets/CMakeLists.txt").read_text(encoding="utf-8"))
        looking = {"test_widgets_" + path.stem.removeprefix("tst_") for path, text in sources("widgets", "tst_*.cpp") if LOOKS.search(text)}
        self.assertEqual(looking, set(labelled[1].split()))

    def test_nobody_asserts_how_long_this_computer_took(self):
        found = [str(path.relative_to(TESTS)) for path in sorted(TESTS.rglob("*.cpp")) if "benchmarks" not in path.parts
                 and ASSERTED.search(path.read_text(encoding="utf-8"))]
        self.assertEqual(found, [])


if __name__ == "__main__":
    unittest.main()
