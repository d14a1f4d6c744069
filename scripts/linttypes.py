# SPDX-License-Identifier: GPL-3.0-or-later
"""A type is defined once in the program. Two of one qualified name compile and link, and then what the linker keeps of the one works on
the memory of the other. Judges a whole tree; a namespace without a name has types of its own."""
import collections
import re

from linttext import code_of

FOLDERS = ("app/", "devices/", "widgets/")
TOKEN = re.compile(r"\bnamespace\s*(?P<space>[\w:]*)\s*\{"
                   r"|\b(?:class|struct|union|enum(?:\s+(?:class|struct))?)\s+(?:\[\[[^\]]*\]\]\s*)?(?P<type>\w[\w:]*\w|\w)\s*(?:final\s*)?"
                   r"(?::(?!:)[^;{()]*)?\{"
                   r"|[{}]")


def types_of(text):
    """(line, qualified name) of what is defined in named namespaces, outside classes and functions."""
    code = code_of(text)
    open_scopes = []  # the name of a namespace, None of anything else
    for match in TOKEN.finditer(code):
        if match[0] == "}":
            if open_scopes:
                open_scopes.pop()
        elif match["type"]:
            if all(open_scopes):
                yield code.count("\n", 0, match.start()) + 1, "::".join([*open_scopes, match["type"]])
            open_scopes.append(None)
        elif match["space"] is None:
            open_scopes.append(None)
        else:
            open_scopes.append(match["space"] or None)


def findings(files):
    """(path, line, message) of each type that another file defines, too."""
    places = collections.defaultdict(list)
    for path in sorted(files):
        if path.startswith(FOLDERS) and path.endswith((".h", ".cpp")):
            for line, name in types_of(files[path]):
                places[name].append((path, line))
    for name, found in sorted(places.items()):
        for path, line in found:
            others = sorted({other for other, _ in found} - {path})
            if others:
                yield path, line, f"{name} is defined in {', '.join(others)}, too: a program has one type of a name"
