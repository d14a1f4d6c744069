#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The sentences that the library says: literals of say() and MB_LABEL() (devices/async/message.h).

scripts/messages.py     prints them for lupdate, which knows neither: one QT_TRANSLATE_NOOP a line
"""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[1]
FOLDERS = ("app", "devices", "widgets")
# The console and the guardian speak English only.
ENGLISH = re.compile(r"app/console/|app/guardian/(?!client/)")
LITERAL = r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*'
SAID = re.compile(r"\b(?:say|MB_LABEL)\(\s*(" + LITERAL + ")")


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
