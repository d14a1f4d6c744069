#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every control that a page of the help names, in *italics* or **bold** and beginning with a capital, is a text of the program."""
import pathlib
import re
import unittest
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = ("first-hour", "connecting", "tuning", "plots", "service", "recipes", "safety", "files", "troubleshooting", "hardware/dmc60c",
         "hardware/supermodified", "hardware/abstractdc", "hardware/quadquad2drv")
NOT_OURS = {"UDP server"}  # of another program
NO_CONTROL = {
    "A real motor", "Without a duty command", "A QuadQuad2Drv whose gain scales are not known", "Current loops",
    "A Supermodified held by much friction", "The simulated bench", "The current loop of an Abstract DC Drive",
    "References", "Notes", "CSV", "MCAP", "Always recording", "Memory", "Drivers are on M1 and M2 only"}  # of what a paragraph begins with
NAME = re.compile(r"(\*{1,2})(?=[A-Z])([^*]+?)(?<=\S)\1")


def names(markdown):
    """What stands in stars; a label that ends with a dot or a colon begins a paragraph and names no control."""
    words = re.sub(r"```.*?```|`[^`\n]*`", "", markdown, flags=re.S)
    words = re.sub(r"^( *)\* ", r"\1- ", words, flags=re.M)
    for _stars, name in NAME.findall(words):
        if name[-1] not in ".:":
            yield re.sub(r"\s+", " ", name)


def shown(source):
    """How a page may call a text: without mnemonic, key, explanation, dots and what takes the place of %1 at its end."""
    text = source.replace("&", "").split("\t")[0]
    return {re.sub(r" ?(?:…|%1)$", "", part) for part in (text, text.split(": ")[0], text.split(" (")[0])}


class Controls(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        sources = [source.text or "" for source in ElementTree.parse(ROOT / "translations/motorbench_de.ts").iter("source")]
        cls.texts = set().union(*map(shown, sources))
        cls.openings = tuple(source[:-2] for source in sources if re.fullmatch(r"[A-Z][^%]+ %1", source))  # Begin like this with every %1

    def is_known(self, name):
        return re.sub(r" ?…$", "", name) in self.texts or name.startswith(self.openings)

    def test_every_control_that_a_page_names_is_there(self):
        found = 0
        for page in PAGES:
            for name in names((ROOT / "docs" / f"{page}.md").read_text(encoding="utf-8")):
                if name not in NOT_OURS | NO_CONTROL:
                    found += 1
                    with self.subTest(page=page, name=name):
                        self.assertTrue(self.is_known(name), f"{page}.md names “{name}”, which the program does not show")
        self.assertGreater(found, 40)

    def test_no_exception_is_left_over(self):
        named = {name for page in PAGES for name in names((ROOT / "docs" / f"{page}.md").read_text(encoding="utf-8"))}
        self.assertEqual(NOT_OURS | NO_CONTROL, {name for name in NOT_OURS | NO_CONTROL if name in named and not self.is_known(name)})

    def test_a_control_that_is_not_there_is_found(self):
        self.assertEqual(list(names("See *Project folder…* or **Gain scales**, not *this*.\n* A `*Thing*`: **Label.**\n")),
                         ["Project folder…", "Gain scales"])
        self.assertFalse(self.is_known("Project folder…") or self.is_known("Gain scales") or self.is_known("Skip"))


if __name__ == "__main__":
    unittest.main()
