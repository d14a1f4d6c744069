#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/architecture.md#what-became-different says how large the program is now: that is measured here, with the rules of scripts/lint."""
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
import lintcircles  # noqa: E402 pylint: disable=wrong-import-position
import lintclasses  # noqa: E402 pylint: disable=wrong-import-position
import linttext  # noqa: E402 pylint: disable=wrong-import-position

PAGE = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
FOLDERS = ("app", "widgets", "devices")
TOLERANCE = 0.04  # of what every change moves a little: lines and files


def now_of(measure):
    """The last cell of the row of this measure."""
    table = PAGE.split("\n## What became different\n")[1].split("\n## ")[0]
    row = next(line for line in table.splitlines() if line.startswith(f"| {measure} |"))
    return row.rsplit("|", 2)[1].strip()


def numbers(text):
    return [int(found.replace(" ", "")) for found in re.findall(r"\d{1,3}(?: \d{3})+|\d+", text)]


def percentile(values):
    """The 95th, and the most."""
    ordered = sorted(values)
    return [ordered[min(len(ordered) - 1, len(ordered) * 95 // 100)], ordered[-1]]


class Measures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.texts = {path.relative_to(ROOT).as_posix(): path.read_text(encoding="utf-8")
                     for folder in FOLDERS for path in sorted((ROOT / folder).rglob("*")) if path.suffix in (".h", ".cpp")}
        cls.codes = {path: linttext.code_of(text) for path, text in cls.texts.items()}
        cls.sizes = {}  # by class: functions, members
        for path, code in cls.codes.items():
            for _, name, body in lintclasses.classes(code):
                cls.sizes[path, name] = lintclasses.size_of(name, body)
        cls.findings = list(lintclasses.findings(cls.texts))

    def assert_near(self, told, measured):
        self.assertEqual(len(told), len(measured))
        for one, other in zip(told, measured):
            self.assertLessEqual(abs(one - other), TOLERANCE * other, f"the table says {told}, measured was {measured}")

    def test_classes_are_as_large_as_the_table_says(self):
        for at, what in enumerate(("functions", "members")):
            with self.subTest(what):
                measured = percentile([size[at] for size in self.sizes.values()])
                usual, most = numbers(now_of(f"{what} of a class, 95th percentile and most"))
                self.assertEqual(most, measured[1])
                self.assertLessEqual(abs(usual - measured[0]), 1, measured)

    def test_the_largest_classes_of_the_app_are_those_that_the_table_names(self):
        told = re.findall(r"`(\w+)`: (\d+)(?: functions)?, (\d+)", now_of("largest class of `app`"))
        self.assertTrue(told)
        of_app = {name: size for (path, name), size in self.sizes.items() if path.startswith("app/")}
        for name, functions, members in told:
            self.assertEqual((int(functions), int(members)), of_app[name], name)
        most = max(functions for functions, _ in of_app.values()), max(members for _, members in of_app.values())
        self.assertEqual((max(int(row[1]) for row in told), max(int(row[2]) for row in told)), most)

    def test_classes_beyond_the_budget_are_counted(self):
        beyond = sum("functions and" in message for *_, message in self.findings)
        self.assertEqual(numbers(now_of("classes above 30 functions or 20 members")), [beyond])

    def test_sources_without_a_header_are_counted(self):
        without = [path for path, *_, message in self.findings if message.startswith("no header")]
        self.assertEqual(numbers(now_of("`.cpp` without a header of their own name, all folders")), [len(without)])
        self.assertEqual(numbers(now_of("`.cpp` of the engine without a header")), [sum(path.startswith("app/engine/") for path in without)])

    def test_circles_are_counted(self):
        for what, node in (("units", lambda path: path.rsplit(".", 1)[0]), ("folders", lintcircles.folder_of)):
            with self.subTest(what):
                found = lintcircles.circles(lintcircles.graph_of(self.texts, node))
                self.assertEqual(numbers(now_of(f"circles of {what}")), [len(found)])

    def test_pairs_of_files_in_the_model_are_counted(self):
        pairs = sum(path.startswith("devices/model/") and path.endswith(".cpp") and path[:-4] + ".h" in self.texts for path in self.texts)
        self.assert_near(numbers(now_of("pairs of files in `devices/model`"))[:1], [pairs])

    def test_files_and_functions_are_as_long_as_the_table_says(self):
        files = [text.count("\n") for text in self.texts.values()]
        self.assert_near(numbers(now_of("lines of a file, 95th percentile and most")), percentile(files))
        functions = [length for code in self.codes.values() for _, _, length, _ in linttext.functions_of(code)]
        self.assert_near(numbers(now_of("lines of a function, 95th percentile and most")), percentile(functions))

    def test_the_program_has_the_lines_and_files_that_the_table_says(self):
        lines = [sum(text.count("\n") for path, text in self.texts.items() if path.startswith(folder + "/")) for folder in FOLDERS]
        told = now_of("lines of `app`, `widgets`, `devices`").split(" files")[0].replace(" in ", ", ")
        self.assert_near(numbers(told), [*lines, len(self.texts)])


if __name__ == "__main__":
    unittest.main()
