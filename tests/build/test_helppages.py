#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every page of the help says in each language what the English one says: section by section the same tables, lists, code, links and
numbers. Whoever changes a page in English is told here which page of which language has to follow, and in what."""
import collections
import pathlib
import re
import unittest

DOCS = pathlib.Path(__file__).resolve().parents[2] / "docs"
LANGUAGES = sorted(path.stem.split("_")[1] for path in (DOCS.parent / "translations").glob("motorbench_*.ts"))
PAGES = ["first-hour", "connecting", "tuning", "plots", "service", "recipes", "safety", "files", "troubleshooting",
         "hardware/dmc60c", "hardware/supermodified", "hardware/abstractdc", "hardware/quadquad2drv"]
BLOCK = re.compile(r"^ *```.*?^ *```", re.M | re.S)
NUMBER = re.compile(r"\d(?:[\d.,  \u202f\u00a0]*\d)?")
LINK = re.compile(r"\]\(([^)]*)\)")


def counted(found):
    return collections.Counter(found)


def sections(text):
    """(level, heading, body) of each; code is no heading."""
    hidden = BLOCK.sub(lambda block: re.sub(r"^", "\0", block[0], flags=re.M), text)
    parts = re.split(r"^(#+) (.*)$", hidden, flags=re.M)
    return [(len(parts[at]), parts[at + 1], parts[at + 2].replace("\0", "")) for at in range(1, len(parts), 3)]


def features(body):
    """What must be the same in every language, by its name."""
    prose = BLOCK.sub("", body)
    words = LINK.sub("", prose)
    links = [target.split("://")[-1] if "://" in target else pathlib.PurePosixPath(target.split("#")[0]).name for target in LINK.findall(prose)]
    return {
        "blocks of code": counted(BLOCK.findall(body)),
        "rows of tables": len(re.findall(r"^ *\|", prose, re.M)),
        "items of lists": len(re.findall(r"^ *(?:[*-]|\d+\.) ", prose, re.M)),
        "paragraphs": len([part for part in re.split(r"\n\s*\n", prose.strip()) if part.strip()]),
        "words in code": counted(re.findall(r"`([^`]+)`", prose)),
        "links": counted(links),
        "numbers": counted(re.sub(r"\D", "", number) for number in NUMBER.findall(words)),
    }


def difference(ours, theirs):
    if isinstance(ours, int):
        return f"{ours} in English, {theirs} here"
    return f"only in English {sorted((ours - theirs).elements())}, only here {sorted((theirs - ours).elements())}"


def differences(english, translated):
    """A line for each thing that differs, with the English heading above it."""
    ours, theirs = sections(english), sections(translated)
    if [level for level, _heading, _body in ours] != [level for level, _heading, _body in theirs]:
        return [f"headings differ: {[heading for _level, heading, _body in ours]} in English, {[heading for _level, heading, _body in theirs]} here"]
    found = []
    for (_level, heading, body), (_, _, other) in zip(ours, theirs):
        there = features(other)
        found += [f"\"{heading}\": {name}: {difference(value, there[name])}" for name, value in features(body).items() if value != there[name]]
    return found


def read(path):
    return path.read_text(encoding="utf-8")


class HelpPages(unittest.TestCase):
    def test_every_page_says_the_same_in_every_language(self):
        for language in LANGUAGES:
            if language == "en":
                continue
            for page in PAGES:
                with self.subTest(f"docs/{language}/{page}.md"):
                    path = DOCS / language / f"{page}.md"
                    self.assertTrue(path.exists(), f"{path.relative_to(DOCS.parent)} is missing")
                    found = differences(read(DOCS / f"{page}.md"), read(path))
                    self.assertEqual(found, [], f"docs/{language}/{page}.md does not follow docs/{page}.md:\n" + "\n".join(found))

    def test_every_hardware_page_is_among_them(self):
        hardware = [f"hardware/{path.stem}" for path in sorted((DOCS / "hardware").glob("*.md"))]
        self.assertEqual(hardware, sorted(page for page in PAGES if page.startswith("hardware/")))

    def test_a_page_without_its_english_one_is_refused(self):
        for path in DOCS.glob("[a-z][a-z]/**/*.md"):
            self.assertIn(str(path.relative_to(DOCS / path.relative_to(DOCS).parts[0]).with_suffix("")), PAGES, path)

    def test_a_change_in_english_only_is_named(self):
        english = read(DOCS / "troubleshooting.md")
        self.assertEqual(differences(english, english), [])
        for change, name in ((("60 Ω", "70 Ω"), "numbers"), (("sudo fuser -v", "sudo fuser"), "words in code"),
                             (("(safety.md)", "(files.md)"), "links"), (("| *2 ×* | two units of one number: give one another |\n", ""), "rows of tables"),
                             (("motorbenchctl links", "motorbenchctl scan"), "blocks of code"),
                             (("## The program itself\n", "## The program itself\n\n* one more\n"), "items of lists")):
            self.assertIn(change[0], english)
            found = differences(english.replace(*change), english)
            self.assertTrue(any(name in line for line in found), f"{name}: {found}")
        found = differences(english + "\n## More\n", english)
        self.assertIn("headings differ", found[0])
        self.assertIn("More", found[0])


if __name__ == "__main__":
    unittest.main()
