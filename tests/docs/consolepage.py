#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/console.md: what the console program says of its verbs and their options, with an example of each that stands in the page itself.
    consolepage.py PROGRAM PAGE    writes the page anew"""
import pathlib
import re
import subprocess
import sys

GLOBAL = ("-h,--help", "--json", "--quiet", "--timeout", "--retries")
ROW = re.compile(r"^  (\S.*?)(?:  +(.*))?$")
EXAMPLE = re.compile(r"^## (\S+)$.*?^```sh\n(.*?)^```$", re.M | re.S)


def said(program, *words):
    return subprocess.run([program, "help", *words], capture_output=True, text=True, check=True).stdout


def verbs(program):
    """(verb, what it does), and what stands below the list of them."""
    listed, below = said(program).split("Verbs:\n", 1)[1].split("\n\n", 1)
    return [tuple(line.split(None, 1)) for line in listed.splitlines()], below.strip()


def rows(text):
    """(as it is written, needed, what it is) of each argument; what every verb takes is left out."""
    for line in re.sub(r"\n {20,}", "  ", text.split("\n\n", 1)[1]).splitlines():
        row = ROW.match(line)
        if not row or row[1].split()[0] in GLOBAL:
            continue
        words = row[1].replace("{both}", "").split()
        name = words[0] if words[0].startswith("-") else words[0].upper()
        value = " …" if "TEXT" in words and words[0].startswith("-") else ""
        yield name + value, "REQUIRED" in words, row[2] or ""


def section(program, verb, about, example):
    table = [f"| {'needed' if needed else ''} | `{name}` | {what.replace('|', chr(92) + '|')} |" for name, needed, what in rows(said(program, verb))]
    head = ["", "| | argument | what it is |", "|---|---|---|", *table] if table else []
    return "\n".join([f"## {verb}", "", f"{about}.", *head, "", "```sh", example.rstrip("\n") or f"motorbenchctl {verb}", "```", ""])


def page(program, now):
    """`now`: the page as it is, for its beginning and its examples."""
    examples = dict(EXAMPLE.findall(now))
    listed, below = verbs(program)
    begin = now.split("```\n", 1)[0]
    return "\n".join([f"{begin}```", below, "```", "", *(section(program, verb, about, examples.get(verb, "")) for verb, about in listed)])


if __name__ == "__main__":
    target = pathlib.Path(sys.argv[2])
    target.write_text(page(sys.argv[1], target.read_text(encoding="utf-8")), encoding="utf-8")
