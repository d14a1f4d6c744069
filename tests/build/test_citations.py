#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What comments cite is in the tree: a page, and in it a heading or an anchor of that name; and nothing else is cited."""
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ("app", "devices", "widgets", "tests")
CITED = re.compile(r"(?<![\w/.])((?:docs/\w[\w-]*|(?:\w+/)?README)\.md)#([\w-]+)")
PAGE = re.compile(r"(?<![\w/.])(docs/[\w/-]+\.md|(?:\w+/)?README\.md)(?!\w)")
ELSEWHERE = re.compile(r"\bproduct\.md|\bpeers\.md|(?<!docs/)\btuning\.md [0-9]|\btraps? [0-9]|protocol reference|\bsections? [0-9]"
                       r"|\b(?:product|tuning|architecture) [0-9]\."
                       r"|(?://|\*|#).*?(?<![\w/])(?!README)[\w-]+\.md, [a-z]", re.IGNORECASE)
# "/// 2.1", "///< 1.4: why", "// Frame, 1.1", "in this order (6)": a section of a page that is not named.
NUMBERED = re.compile(r"(?m)//[/!<]*[ ]*(?:[1-9]\.\d{1,2}(?!\d)(?:, [\d.]+)*(?: and \d)?(?=[ ]*(?:[:,]|$))|[1-9](?:, [\d.]+)*[ ]*$"
                      r"|[A-Z][\w ]*, [1-9](?:\.\d{1,2})?(?=\.?$|;|\. [A-Z`])|[^\n]*\([1-9](?:\.\d{1,2})?\)\.?$)")
NAMED = re.compile(r'docs/[\w/-]+\.md,\s*(?:///?\s*)?(?:"\w|[A-Z]\w+[).])')


def slug(heading):
    """As a forge makes it of a heading."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def anchors(page):
    text = page.read_text(encoding="utf-8")
    return set(re.findall(r'<a id="([\w-]+)"></a>', text)) | {slug(found) for found in re.findall(r"(?m)^#+ (.*)$", text)}


def page_of(source, cited):
    """README.md is that of the family whose folder the source is in, FAMILY/README.md that of the family."""
    if cited.startswith("docs/"):
        return ROOT / cited
    if cited == "README.md":
        return source.parent / cited
    return ROOT / "devices/families" / cited


class Citations(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.sources = [(path, path.read_text(encoding="utf-8")) for folder in FOLDERS for path in sorted((ROOT / folder).rglob("*"))
                       if path.suffix in (".h", ".cpp", ".py") and path != pathlib.Path(__file__).resolve()]

    def test_every_place_that_is_cited_exists(self):
        known, cited, lost = {}, 0, []
        for path, text in self.sources:
            for page, anchor in CITED.findall(text):
                cited += 1
                file = page_of(path, page)
                if file not in known:
                    known[file] = anchors(file) if file.exists() else set()
                if anchor not in known[file]:
                    lost.append(f"{path.relative_to(ROOT)}: {page}#{anchor}")
        self.assertGreater(cited, 100)
        self.assertEqual(lost, [])

    def test_every_page_that_is_cited_exists(self):
        lost = [f"{path.relative_to(ROOT)}: {page}" for path, text in self.sources for page in PAGE.findall(text)
                if not page_of(path, page).exists() and not (ROOT / page).exists()]
        self.assertEqual(lost, [])

    def test_a_part_of_a_page_is_cited_by_its_anchor(self):
        found = [f"{path.relative_to(ROOT)}: {cited}" for path, text in self.sources for cited in NAMED.findall(text)]
        self.assertEqual(found, [])

    def test_nothing_is_cited_that_a_reader_does_not_have(self):
        found = [f"{path.relative_to(ROOT)}:{text.count(chr(10), 0, match.start()) + 1}: {match[0]}"
                 for path, text in self.sources for pattern in ((ELSEWHERE,) if path.suffix == ".py" else (ELSEWHERE, NUMBERED))
                 for match in pattern.finditer(text)]
        self.assertEqual(found, [])

    def test_the_number_of_a_section_without_its_page_is_found(self):
        for cited in ("/// 2.1", "int a; ///< 1.4: why", "// Frame, 1.1", "/// CANCTRL0, 2.11. More", "/// In this order (6).", "/// 2, 2.4"):
            with self.subTest(cited):
                self.assertRegex(cited, NUMBERED)
        for plain in ("/// 0: none", "double kept = 4.0; ///< 1.5 times", "/// 1, 2 or 5 of each", "/// A page of A4 at 96 dpi", "/// D1, D2: later"):
            with self.subTest(plain):
                self.assertNotRegex(plain, NUMBERED)

    def test_an_anchor_stands_once_in_its_page(self):
        for page in [*sorted((ROOT / "docs").glob("*.md")), *sorted((ROOT / "devices/families").glob("*/README.md"))]:
            ids = re.findall(r'<a id="([\w-]+)"></a>', page.read_text(encoding="utf-8"))
            with self.subTest(page.name):
                self.assertEqual(len(ids), len(set(ids)))


if __name__ == "__main__":
    unittest.main()
