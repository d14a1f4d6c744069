# SPDX-License-Identifier: GPL-3.0-or-later
"""A class is as large as one responsibility, and stands in files that carry its name. Judges a whole tree; what stands against
it is in scripts/lint-exceptions, each with its reason."""
import collections
import re

from linttext import closing, code_of, kind_of

FUNCTIONS, MEMBERS = 30, 20
FOLDERS = ("app/", "devices/", "widgets/")
LIST = "scripts/lint-exceptions"
# Where a .cpp needs no header of its own name: programs, console verbs, transport backends, the one fixed file of a family.
HEADERLESS = re.compile(r"(?:^|/)main\.cpp$|^app/console/[a-z]+\.cpp$|^devices/transport/backends/|^devices/families/[^/]+/family\.cpp$")

CLASS = re.compile(r"(?<!enum )\b(class|struct)\s+(?:\[\[[^\]]*\]\]\s*)?([\w:]+)\s*(?:final\s*)?(?::(?!:)[^;{(]*)?\{")
LABEL = re.compile(r"\b(?:public|private|protected|Q_SIGNALS|signals)\s*(?:Q_SLOTS|slots)?\s*:(?!:)|\bQ_OBJECT\b")
NO_MEMBER = re.compile(r"^(?:using|friend|typedef|static_assert|enum|class|struct|union|template\s+class|Q_\w+)\b|\bconstexpr\b|=\s*(?:delete|default)$")


def statements(body):
    """What a class declares, without the bodies and the classes inside it: (head, has a body of code)."""
    at = start = 0
    while match := re.compile(r"[{;]").search(body, at):
        head = " ".join(LABEL.sub(" ", body[start:match.start()]).split())
        at = match.end()
        if match[0] == "{":
            at = closing(body, match.start()) + 1
            kind = kind_of(without_arguments(head))
            if kind == "value":
                body = body[:match.start()] + " " * (at - match.start()) + body[at:]
                continue
            if kind == "container":
                at = (body.find(";", at) + 1) or len(body)
            start = at
            if kind == "function":
                yield head, True
            continue
        start = at
        if head:
            yield head, False


def without_arguments(head):
    """The declaration without what stands in < >."""
    before = None
    while before != head:
        before, head = head, re.sub(r"<[^<>]*>", " ", head.replace("->", "  "))
    return head


def size_of(name, body):
    """How many functions (but for constructors, the destructor, what is defaulted) and data members a class declares."""
    functions = members = 0
    for head, is_code in statements(body):
        plain = without_arguments(head)
        special = re.match(rf"(?:(?:explicit|virtual|constexpr|\[\[\w+\]\])\s+)*~?{re.escape(name)}\s*\(", plain)
        if special or (not is_code and NO_MEMBER.search(plain)):
            continue
        if is_code or "(" in plain.split("=")[0]:
            functions += 1
        else:
            members += 1 + re.sub(r"\([^()]*\)", "", plain).count(",")
    return functions, members


def classes(code):
    """Every class, and every struct that has a constructor: the others are data, as long as what they tell."""
    for match in CLASS.finditer(code):
        name, body = match[2].split("::")[-1], code[match.end():closing(code, match.end() - 1)]
        if match[1] == "class" or re.search(rf"(?<![~\w]){re.escape(name)}\s*\(", body):
            yield code.count("\n", 0, match.start()) + 1, name, body


def findings(files):
    """(path, line, what the list of exceptions calls it, message) for everything that stands against the rules."""
    for path in sorted(files):
        if not path.startswith(FOLDERS):
            continue
        if path.endswith(".cpp") and path[:-4] + ".h" not in files and not HEADERLESS.search(path):
            yield path, 1, path, "no header has this name: a file holds what its own header declares"
        if not path.endswith((".h", ".cpp")):
            continue
        for line, name, body in classes(code_of(files[path])):
            functions, members = size_of(name, body)
            if functions > FUNCTIONS or members > MEMBERS:
                yield path, line, f"{path} {name}", (f"{name} has {functions} functions and {members} members; a class has at most "
                                                    f"{FUNCTIONS} and {MEMBERS}: one class for each responsibility")


def exceptions(text):
    """What is listed, by name: the line it stands in. `NAME: reason`, or `PATH NAME: reason`."""
    return {line.partition(":")[0].strip(): number for number, line in enumerate(text.splitlines(), 1)
            if line.strip() and not line.startswith("#")}


def check_tree(files, listed):
    """Yields (path, line, level, message). `files`: text by path. Listed: a warning; anything else: an error."""
    known = exceptions(listed)
    met = collections.Counter()
    for path, line, name, message in findings(files):
        met[name] += 1
        yield path, line, "warning" if name in known else "error", message
    for name, line in known.items():
        if name not in met:
            yield LIST, line, "warning", f"{name} is no exception any more: take it from the list"
    for number, line in enumerate(listed.splitlines(), 1):
        if line.strip() and not line.startswith("#") and not line.partition(":")[2].strip():
            yield LIST, number, "error", "an exception has a reason"
