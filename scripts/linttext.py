# SPDX-License-Identifier: GPL-3.0-or-later
"""Just enough C++ for scripts/lint: code without comments and literals, and where functions begin and end."""
import re

LITERALS = re.compile(
    r"""//(?:\\\n|[^\n])*"""  # comment to the end of the line
    r"""|/\*.*?\*/"""
    r"""|R"(?P<mark>[^()\s\\]{0,16})\(.*?\)(?P=mark)\""""
    r"""|"(?:\\.|[^"\\\n])*\""""
    r"""|(?<![0-9A-Fa-f])'(?:\\.|[^'\\\n])+'""",  # not the separator in 1'000
    re.DOTALL)


def blank(match):
    text = match[0]
    if text.startswith("/"):
        return re.sub(r"[^\n]", " ", text)
    return text[0] + re.sub(r"[^\n]", " ", text[1:-1]) + text[-1]


def code_of(text):
    """The text with comments and literals blanked; every line keeps its number."""
    return LITERALS.sub(blank, text)


def without_comments(text):
    """The text with comments blanked and literals as they are."""
    return LITERALS.sub(lambda match: blank(match) if match[0].startswith("/") else match[0], text)


CONTAINER = re.compile(r"^(?:export\s+)?(?:inline\s+)?(?:namespace\b|extern\s*\"|(?:template\s*<.*>\s*)?(?:class|struct|union|enum)\b[^()]*$)")
INITIALIZERS = re.compile(r"\)\s*(?:noexcept\s*(?:\([^)]*\)\s*)?)?:(?!:)")
NAME = re.compile(r"([~\w:]+|operator\s*\S+?)\s*\(")


def closing(code, opening):
    """The index of the brace that closes the one at `opening`, or the end."""
    depth = 0
    for match in re.compile(r"[{}]").finditer(code, opening):
        depth += 1 if match[0] == "{" else -1
        if depth == 0:
            return match.start()
    return len(code)


def kind_of(head):
    """What a brace opens after `head`: "container", "function", or "value" (an initializer: the head goes on)."""
    head = " ".join(head.split())
    if CONTAINER.match(head):
        return "container"
    if head.endswith(("=", ",", "(", "return")) or head.count("(") != head.count(")") or "(" not in head:
        return "value"
    if INITIALIZERS.search(head) and re.search(r"[\w>]$", head) and re.search(r"[:,]\s*[\w:<>, ]+$", head):
        return "value"  # a member in a constructor's list
    return "function"


def name_of(head):
    """The function's name, and whether it is a constructor."""
    bare = re.sub(r"^\s*template\s*<[^{}]*?>\s*(?=[\w\[~])", "", " ".join(head.split()))
    match = NAME.search(bare)
    name = match[1] if match else "function"
    if re.fullmatch(r"TEST(_F|_P)?|TYPED_TEST", name):
        return bare[match.start():].rstrip(), False
    parts = name.split("::")
    before = bare[: match.start()].strip() if match else ""
    before = re.sub(r"\b(?:explicit|constexpr|inline|consteval)\b|\[\[.*?\]\]", "", before).strip()
    return name, not before and (len(parts) == 1 or parts[-1] == parts[-2])


def functions_of(code):
    """Yields (line, name, lines of the body, is a constructor) for every function outside other functions."""
    code = re.sub(r"(?m)^[ \t]*#(?:\\\n|[^\n])*", lambda match: re.sub(r"[^\n]", " ", match[0]), code)
    at = start = 0
    token = re.compile(r"[{};]|\b(?:public|private|protected|Q_OBJECT|Q_SIGNALS|signals)\b\s*(?:(?:Q_SLOTS|slots)\s*)?:?")
    while match := token.search(code, at):
        at = match.end()
        if match[0] != "{":
            head = code[start:match.start()]
            inherits = match[0][0] == "p" and not match[0].endswith(":")
            if not inherits and head.count("(") == head.count(")"):
                start = at
            continue
        head = code[start:match.start()]
        kind = kind_of(head)
        if kind == "container":
            start = at
            continue
        end = closing(code, match.start())
        at = end + 1
        if kind == "function":
            line = code.count("\n", 0, match.start()) + 1
            length = max(0, code.count("\n", match.start(), end) - 1)
            name, constructor = name_of(head)
            yield line, name, length, constructor
            start = at
