#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The sentences that the library says: literals of say() and MB_LABEL() (devices/async/message.h); and the words of the drawings in
docs/hardware, which the help shows in the window's language.

scripts/messages.py     prints them for lupdate, which knows none of them: one QT_TRANSLATE_NOOP a line
"""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[1]
FOLDERS = ("app", "devices", "widgets")
# The console and the guardian speak English only.
ENGLISH = re.compile(r"app/console/|app/guardian/(?!client/)")
LITERAL = r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*'
SAID = re.compile(r"\b(?:say|MB_LABEL)\(\s*(" + LITERAL + ")")
LABEL = re.compile(r"<text([^>]*)>([^<]*)</text>")
UNITS = {"Mbit", "bit"}


def is_words(label):
    """Whether there is a word in it: names of parts (DMC60C), of signals (MISO), numbers and units are the same in every language."""
    return any(re.fullmatch(r"[A-Za-z]?[a-z]+", word) and len(word) > 1 and word not in UNITS for word in re.findall(r"\w+", label))


def labels(root=ROOT):
    """Of each drawing (path, attributes, words) of its labels that are words."""
    for path in sorted((root / "docs" / "hardware").glob("*.svg")):
        for attributes, label in LABEL.findall(path.read_text(encoding="utf-8")):
            if is_words(label):
                yield path, attributes, label


def said(text):
    """The marked literals of a source, as they stand there, several pieces joined."""
    return ["".join(re.findall(r'"((?:[^"\\\n]|\\.)*)"', found)) for found in SAID.findall(text)]


def sources(root=ROOT):
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            name = path.relative_to(root).as_posix()
            if path.suffix in (".h", ".cpp") and not ENGLISH.match(name) and name != "devices/async/message.h":
                yield path


if __name__ == "__main__":
    for literal in sorted({literal for path in sources() for literal in said(path.read_text(encoding="utf-8"))}):
        print(f'QT_TRANSLATE_NOOP("table", "{literal}")')
    for label in sorted({label for _path, _attributes, label in labels()}):
        print(f'QT_TRANSLATE_NOOP("drawings", "{label}")')
