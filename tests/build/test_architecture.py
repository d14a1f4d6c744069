#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/architecture.md names every folder of the program, and none that is not there."""
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")


def part(heading):
    return PAGE.split(f"\n## {heading}\n")[1].split("\n## ")[0]


def folders(*parents):
    return [f"{parent}/{path.name}" for parent in parents for path in sorted((ROOT / parent).iterdir())
            if path.is_dir() and any(path.rglob("*.h"))]


def rows(text):
    """First cell: the whole row."""
    return {row.split("|")[1].strip().strip("`"): row for row in text.splitlines() if row.startswith("| `")}


class Architecture(unittest.TestCase):
    def test_the_picture_has_every_folder_of_the_library(self):
        picture = part("Layers").split("```")[1]
        for folder in folders("devices"):
            with self.subTest(folder):
                self.assertRegex(picture, rf"(?<![\w/]){folder.split('/')[1]}\b")

    def test_the_table_of_layers_has_every_folder_of_the_library(self):
        first = " ".join(row.split("|")[1] for row in part("Layers").splitlines() if row.startswith("|"))
        for folder in folders("devices"):
            with self.subTest(folder):
                self.assertIn(f"`{folder}", first)

    def test_every_folder_has_its_words(self):
        told = rows(part("Where to find what"))
        for folder in folders("devices", "widgets", "app"):
            parent, name = folder.split("/")
            with self.subTest(folder):
                self.assertTrue(folder in told or re.search(rf"`(?:{parent}/)?{name}/?`", told[parent]), "say what is there")

    def test_nothing_is_named_that_is_not_there(self):
        for folder in rows(part("Where to find what")):
            if "/" in folder and " " not in folder:
                with self.subTest(folder):
                    self.assertTrue((ROOT / folder).is_dir())


if __name__ == "__main__":
    unittest.main()
