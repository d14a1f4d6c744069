# SPDX-License-Identifier: GPL-3.0-or-later
"""The rules of scripts/lint. Each is a function (path, text, code) that yields (line, level, message); `code` is the
text with comments and literals blanked, so that a rule finds only what is compiled. tests/build/test_lint.py shows
what each rejects."""
import re

from linttext import code_of, functions_of, without_comments

# Names that a rule forbids and we keep, each with its reason.
ALLOWED_NAMES = {
    ("devices/async/task.h", "PromiseBase"),  # the part of a promise that does not depend on its value type
}
DEVICE_TESTS = ("tests/async/", "tests/wire/", "tests/transport/", "tests/model/", "tests/recording/", "tests/tuning/", "tests/settings/", "tests/service/", "tests/families/")


def matches(pattern, text):
    for match in re.finditer(pattern, text):
        yield text.count("\n", 0, match.start()) + 1, match


def is_cpp(path):
    return path.endswith((".h", ".cpp"))


def licence(path, text, _code):
    if not (is_cpp(path) or path.endswith((".py", ".sh", ".cmake", "CMakeLists.txt")) or path.startswith((".ci/", "scripts/"))):
        return
    lines = text.split("\n", 2)
    at = 1 if lines[0].startswith("#!") else 0
    mark = "//" if is_cpp(path) or path.endswith(".c") else "#"
    if len(lines) <= at or lines[at] != f"{mark} SPDX-License-Identifier: GPL-3.0-or-later":
        yield at + 1, "error", "the licence line is missing"


FORBIDDEN_WORD = r"(?:Manager|Helper|Handler|Util|Utils|Base|Impl|Info)(?![a-z])"
TYPE_NAME = re.compile(r"\b(?:class|struct|union|enum(?:\s+class|\s+struct)?|concept|using|namespace)\s+(?:\[\[[^\]]*\]\]\s*)?([A-Za-z_][\w:]*)")


def names(path, _text, code):
    for line, match in matches(TYPE_NAME, code):
        name = match[1].strip(":").split("::")[-1]
        if re.search(FORBIDDEN_WORD, name) and not re.match(r"Q[A-Z]", name) and (path, name) not in ALLOWED_NAMES:
            yield line, "error", f"the name {name} says nothing: name the thing by what it is"
    if path.startswith("app/console/info."):  # one file for each verb
        return
    stem = path.rsplit("/", 1)[-1].split(".")[0]
    if is_cpp(path) and re.search(r"(?:manager|helper|handler|util|impl|info)s?$", stem):
        yield 1, "error", f"the file name {stem} says nothing: name the thing by what it is"


# (folders, files that are the exception, pattern, what is wrong)
FORBIDDEN = [
    (("devices/",), ("devices/transport/qtclock.", "devices/transport/externalprogram."),  # the latter reaps what it killed
     r"\b(?:QTimer|QBasicTimer|QElapsedTimer|QDeadlineTimer|currentDateTime(?:Utc)?|current(?:M?Secs)SinceEpoch|startTimer)\b"
     r"|\b(?:steady|system|high_resolution)_clock\s*::\s*now\b|\b(?:gettimeofday|clock_gettime|nanosleep|u?sleep|msleep)\s*\("
     r"|\bsleep_(?:for|until)\b|\bwaitFor\w*\s*\(",
     "the time comes from the Clock that is handed in"),
    (DEVICE_TESTS, (), r"\b(?:nanosleep|u?sleep|msleep|qSleep|qWait)\s*\(|\bsleep_(?:for|until)\b", "tests run in virtual time"),
    (("devices/", "app/", "widgets/", *DEVICE_TESTS), (), r"\b(?:QEventLoop|processEvents)\b", "no nested event loops"),
    (("widgets/", "app/"), (),
     r"\bQMessageBox\s*::\s*(?:question|warning|information|critical|about)\s*\(|\bQFileDialog\s*::\s*get\w+\s*\("
     r"|\bQInputDialog\s*::\s*get\w+\s*\(|\b\w*(?:[dD]ialog|[bB]ox|[mM]enu)(?:\.|->)exec\s*\(",
     "this runs a nested event loop: open() it and connect to its result"),
    (("tests/widgets/",), ("tests/widgets/gallery", "tests/widgets/plotgallery"), r"\bqWait\s*\(\s*(?!0\s*\))\w",
     "wait for a condition, or for a timer that is due later (tests/support/timers.h)"),
    (("",), (), r"\b(?:SIGNAL|SLOT)\s*\(", "connect to the member function, not to its spelling"),
    (("",), (), r"(?m)^[ \t]*#[ \t]*if[ \t]+0\b", "remove what is switched off"),
    (("devices/",), ("devices/report/",), r"\btr\s*\(",  # whose product is a text for people, with and without a screen
     "no user text below widgets: return a fault, mark table texts for translation"),
    (("devices/", "app/", "widgets/"), ("app/console/commandline.", "devices/recording/expression."),  # CLI11 and muParser throw; it ends there
     r"\bthrow\b|\bcatch\s*\(", "exceptions are not used"),
    (("devices/", "app/", "widgets/"), ("devices/wire/",), r"\bfrom_chars\b|\b(?:strto|sto|ato)(?:d|f|i|l|ll|ul|ull)\s*\(",
     "numbers are read by wire/number.h"),
]


def forbidden(path, _text, code):
    if not is_cpp(path):
        return
    for folders, exceptions, pattern, why in FORBIDDEN:
        if path.startswith(folders) and not (exceptions and path.startswith(exceptions)):
            for line, match in matches(pattern, code):
                yield line, "error", f"{' '.join(match[0].split())}: {why}"


def operand_end(code, start):
    """Where the operand of a co_await ends: at the end of the statement, or of the parentheses around it."""
    depth = 0
    for at in range(start, len(code)):
        if code[at] == "(":
            depth += 1
        elif code[at] == ")":
            depth -= 1
        if depth < 0 or code[at] == ";" or (code[at] == "," and depth == 0):
            return at
    return len(code)


def operands(path, _text, code):
    if not is_cpp(path):
        return
    for line, match in matches(r"\bco_await\b", code):
        if code[:match.start()].rstrip().endswith("operator"):
            continue
        if re.search(r"[\[{?]", code[match.end():operand_end(code, match.end())]):
            yield line, "error", "name the operand before co_await: GCC 12 destroys some temporaries twice"
        condition = re.search(r"\b(?:if|while|for|switch) \(([^;{}]*)$", code[:match.start()])
        if condition and condition[1].count("(") >= condition[1].count(")") and not re.search(r"[\w>*&] = ", condition[1]):
            yield line, "error", "name what a condition awaits, if (const auto x = co_await f(); x): GCC 12 breaks it"


# A sentence for people is a literal that scripts/translate finds, not glued (devices/async/message.h).
SAYING = ("devices/", "app/", "widgets/")
GLUED = [
    (r'\bMessage::(?:verbatim|label|composed)\(\s*"[^"]*[a-z]{2}[^"]*"', "a sentence is said by say(\"…\"), which has a translation"),
    (r'\bsay\(\s*(?:QT_TRANSLATE_NOOP|std::string\b|\w+\s*\+)', "say() takes a literal: what varies stands in %1 … %9"),
    (r'\bsay\((?:\s*"(?:[^"\\\n]|\\.)*")+\s*\+', "nothing is glued to a literal: what varies stands in %1 … %9"),
    (r'\bfail\(Fault::\w+,\s*"', "a cause is said by say(\"…\"), which has a translation"),
    (r'\benglish\(\)\s*\.\s*(?:r?find\w*|starts_with|ends_with|contains|compare)\b',
     "what a sentence means is not looked for in it: a value beside it tells"),
    (r'\bstatus(?:\(\))?(?:\.|->)title\s*[=!]=|[=!]=\s*(?:\w+(?:\(\))?(?:\.|->))*status(?:\(\))?(?:\.|->)title\b',
     "a title is for people: OperationStatus::kind tells what a job does"),
    (r'\b(?:qt|fromStdString)\([^;"]*?\b\w*[eE]rror(?:\(\))?(?:\.|->)text\(\)',
     "this is English in every language: errorText() of widgets/common/devicetext"),
    (r'\btr\(\s*(?:"(?:[^"\\\n]|\\.)*"\s*)*?"(?:[^"\\\n]|\\.)*\b(?:F\d+|(?:Ctrl|Alt|Meta|Shift)\+(?!C\b)(?:Shift\+)?[A-Z0-9]\w*)\b',
     "people choose their keys: keyShown() or nameKeys() (widgets/common/pagekeys.h) says which one it is"),
]


def sentences(path, text, _code):
    if not is_cpp(path) or not path.startswith(SAYING) or path.startswith("devices/async/message."):
        return
    for pattern, why in GLUED:
        for line, match in matches(pattern, text):
            yield line, "error", f"{' '.join(match[0].split())[:60]}: {why}"


ROOTS = ("async", "wire", "place", "files", "telemetry", "transport", "traffic", "simulation", "firmware", "model", "recording", "experiment", "tuning", "report", "settings", "service", "storage", "families", "widgets", "app", "support", "tests")
SCREEN = re.compile(
    r"Qt(?:Gui|Widgets|Svg|PrintSupport|OpenGL)(?:/|$)|qcustomplot|Q(?:GuiApplication|Application|Widget|MainWindow|Dialog|Color|"
    r"Painter|PaintDevice|Pixmap|Image|Icon|Font|Brush|Pen|Action|Window|Palette|Style|Cursor|KeyEvent|MouseEvent|Screen)$",
    re.IGNORECASE)
# folder: (our folders it may include, any Qt)
# What a layer that knows the model may include of what lies below it.
BELOW = ("async", "wire", "files", "telemetry", "transport", "traffic", "simulation", "firmware", "model")
LAYERS = [
    ("devices/async/", ("async",), False),
    ("devices/wire/", ("async", "wire"), False),
    ("devices/place/", ("place",), False),
    ("devices/files/", ("async", "files"), True),
    ("devices/telemetry/", ("async", "telemetry"), False),
    ("devices/transport/", ("async", "wire", "place", "files", "transport"), True),
    ("devices/traffic/", ("async", "wire", "files", "transport", "traffic"), True),
    ("devices/simulation/", ("async", "wire", "files", "transport", "simulation"), True),
    ("devices/firmware/", ("async", "wire", "files", "transport", "firmware"), True),
    ("devices/model/", BELOW, True),
    ("devices/recording/", (*BELOW, "recording"), True),
    ("devices/experiment/", (*BELOW, "experiment"), True),
    ("devices/tuning/", (*BELOW, "experiment", "tuning"), True),
    ("devices/report/", (*BELOW, "experiment", "tuning", "service", "report"), True),
    ("devices/settings/", (*BELOW, "settings"), True),
    ("devices/service/", (*BELOW, "experiment", "tuning", "settings", "service"), True),
    ("devices/storage/", (*BELOW, "experiment", "tuning", "report", "settings", "service", "storage"), True),
    ("devices/families/", BELOW, True),
    ("widgets/", (*BELOW, "recording", "experiment", "tuning", "report", "settings", "service", "widgets"), True),
    ("app/console/", (*BELOW, "experiment", "tuning", "report", "settings", "service", "storage", "app/console", "app/folders", "app/guardian", "app/sleep"), True),
    ("app/guardian/client/", (*BELOW, "app/guardian"), True),
    ("app/sleep/", (*BELOW, "app/sleep"), True),
    ("app/guardian/", ("app/guardian", "place"), False),
    ("app/", (*BELOW, "recording", "experiment", "tuning", "report", "settings", "service", "storage", "widgets", "app"), True),
]


def is_known(include):
    return include.split("/")[0] in ROOTS and "/" in include


def layering(path, text, _code):
    layer = next((row for row in LAYERS if path.startswith(row[0])), None)
    if not is_cpp(path) or not layer:
        return
    folder, allowed, qt = layer
    if folder == "devices/families/":
        allowed = (*allowed, "/".join(path.split("/")[1:3]))
    for line, match in matches(r'(?m)^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"]', text):
        include = match[1]
        if include.startswith(".."):
            yield line, "error", f"{include}: include from the root of the library, not relative to the file"
        elif is_known(include) and not any(include.startswith(f"{own}/") for own in allowed):
            yield line, "error", f"{include}: {folder} must not know this layer"
        elif not qt and re.match(r"Q[A-Z]|Qt[A-Z]|q[a-z]+\.h$", include):
            yield line, "error", f"{include}: no Qt in {folder}"
        elif folder.startswith(("devices/", "app/console/", "app/guardian/")) and SCREEN.match(include):
            yield line, "error", f"{include}: nothing of the screen in {folder}"


# Facts of a family are data of its folder. A name of one elsewhere is a fact that leaked, but for the examples in what people
# are told to type, which must be real.
FAMILY_NAME = re.compile(r"dmc60c|supermodified|abstract ?dc|quad ?quad(?:2drv)?", re.IGNORECASE)
FAMILY_EXAMPLES = {
    "app/console/commandline.cpp",  # "a DEVICE is LINK/FAMILY:ADDRESS, such as sim:can/dmc60c:5", and so in the next
    "app/console/parameters.cpp",
    "app/console/simulate.cpp",
    "devices/model/identity.cpp",
    "devices/simulation/simulator.cpp",
    "widgets/monitor/framefilterterms.cpp",  # the help of the filter's language
}


# The same without its name: what only one of them has, in a text for people or in a comparison.
FAMILY_FACT = re.compile(
    r"\bjumpers?\b|\bsequence number\b|\bavrdude\b|\bopenocd\b|\bst-?link\b|\breset vector\b|\bEEPROM\b|\bnode ids?\b|\bpage 0\b"
    r"|(?<![%\w])\d+ s\b[^\"]{0,60}\b(?:stores?|stored|proofs?|flash)\b|\b(?:stores?|stored|proofs?|flash)\b[^\"]{0,60}(?<![%\w])\d+ s\b"
    r"|\b\d+ counts a turn\b|\"f[14]\"|\"throttle\"|\b(?:all|the) (?:two|three|four|five) families\b", re.IGNORECASE)


def families(path, text, _code):
    if not is_cpp(path) or not path.startswith(("devices/", "widgets/", "app/")) or path.startswith("devices/families/"):
        return
    if path in FAMILY_EXAMPLES:
        return
    bare = without_comments(text)
    for line, match in (*matches(FAMILY_NAME, bare), *matches(FAMILY_FACT, bare)):
        yield line, "error", f"{match[0]}: what is known of a family is data of its folder (model/family.h)"


# What a parameter is stands in its row as a Role (model/parameter.h), and which one is meant is asked by model/loopparameters. Whoever
# asks for the key of one, or for how it ends, knows one family's names.
GAIN_NAMES = r"(?:[pidf]|divisor|windup|i_zone|(?:nominal|max)_(?:forward|reverse)|allowable_error|ramp|(?:dis|en)abled|scale)"
FILE_ENDINGS = r"(?:csv|pdf|html?|mcap|md|svg|json)"
KEY_NAMES = [
    rf'\b(?:ends_with|endsWith)\(\s*(?:\w+\(\s*)?"(?!\.{FILE_ENDINGS}")\.?[a-z]\w*"',
    r'\bstarts_with\(\s*"[a-z]\w*\."',
    rf'[=!]=\s*(?:std::string_view\()?"\.?{GAIN_NAMES}"',
    r'"p",\s*"[id]"',
    r'"(?:divisor|i_zone|(?:nominal|max)_(?:forward|reverse)|allowable_error)"',
    r'\b(?:findParameter|gainKey)\((?:[^;"()]|\([^"()]*\))*(?:\w+\([^"()]*)?"[^"]*"',
    r'"(?:slot\d|gain|current_limit|limit)\.[a-z_.]+"',
]


def parameter_names(path, text, _code):
    if not is_cpp(path) or not path.startswith(("devices/", "widgets/", "app/")) or path.startswith("devices/families/"):
        return
    for pattern in KEY_NAMES:
        for line, match in matches(pattern, without_comments(text)):
            yield line, "error", f"{' '.join(match[0].split())[:60]}: what a parameter is says its Role, no name (model/loopparameters.h)"


FILE_LINES = (300, 500)
FUNCTION_LINES = (40, 60)
CONSTRUCTOR_LINES = 25


def budgets(path, text, code):
    if not is_cpp(path):
        return
    lines = text.count("\n")
    if lines > FILE_LINES[0]:
        level = "error" if lines > FILE_LINES[1] else "warning"
        yield 1, level, f"{lines} lines; a file has at most {FILE_LINES[0]}, never more than {FILE_LINES[1]}"
    for line, name, length, constructor in functions_of(code):
        if length > FUNCTION_LINES[1]:
            yield line, "error", f"{name} has {length} lines; never more than {FUNCTION_LINES[1]}"
        elif length > FUNCTION_LINES[0]:
            yield line, "warning", f"{name} has {length} lines; a function has at most {FUNCTION_LINES[0]}"
        elif constructor and length > CONSTRUCTOR_LINES:
            yield line, "warning", f"the constructor {name} has {length} lines; compose it of named steps ({CONSTRUCTOR_LINES})"


def absolute_paths(_path, text, _code):
    for line, match in matches(r"(?<![\w./})>*-])/(?:home|tmp|root|work|Users)/\w*", text):
        yield line, "error", f"{match[0]}: no path of one machine"


RULES = (licence, names, forbidden, operands, sentences, layering, families, parameter_names, budgets, absolute_paths)


def check_file(path, text):
    code = code_of(text) if is_cpp(path) else ""
    for rule in RULES:
        yield from rule(path, text, code)
