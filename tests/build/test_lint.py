#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/lint rejects what it says it rejects, where it stands, and leaves its harmless twin alone."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

LINT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "lint"
sys.dont_write_bytecode = True
sys.path.insert(0, str(LINT.parent))
from lintrules import FAMILY_EXAMPLES, FAMILY_NAME  # noqa: E402
from linttext import without_comments  # noqa: E402

LICENCE = "// SPDX-License-Identifier: GPL-3.0-or-later\n"


def body(lines):
    return "{\n" + "    call();\n" * lines + "}\n"


# file, its text after the licence line, line of the finding, words of the finding
BAD = [
    ("devices/model/manager1.h", "class LinkManager {\n};\n", 2, "LinkManager says nothing"),
    ("devices/model/a.h", "struct [[nodiscard]] FrameInfo;\n", 2, "FrameInfo says nothing"),
    ("widgets/common/a.h", "enum class ViewBase { One };\n", 2, "ViewBase says nothing"),
    ("app/a.h", "using PageHandler = int;\n", 2, "PageHandler says nothing"),
    ("app/b.h", "namespace mb::Utils {\n}\n", 2, "Utils says nothing"),
    ("app/pagehelper.h", "int x;\n", 1, "pagehelper says nothing"),
    ("devices/model/time1.cpp", "void f()\n{\n    QTimer timer;\n}\n", 4, "QTimer"),
    ("devices/model/time2.cpp", "auto t = std::chrono::steady_clock::now();\n", 2, "steady_clock::now"),
    ("devices/transport/time3.cpp", "auto t = QDateTime::currentDateTime();\n", 2, "currentDateTime"),
    ("devices/wire/time4.cpp", "void f() { sleep(1); }\n", 2, "sleep("),
    ("devices/wire/time5.cpp", "void f() { usleep (1); }\n", 2, "usleep"),
    ("devices/wire/time6.cpp", "void f() { std::this_thread::sleep_for(t); }\n", 2, "sleep_for"),
    ("devices/transport/time7.cpp", "void f() { port.waitForReadyRead(10); }\n", 2, "waitForReadyRead"),
    ("devices/transport/time8.cpp", "QElapsedTimer t;\n", 2, "QElapsedTimer"),
    ("tests/model/time9.cpp", "void f() { QTest::qWait(10); }\n", 2, "virtual time"),
    ("devices/transport/loop1.cpp", "QEventLoop loop;\n", 2, "no nested event loops"),
    ("widgets/common/loop2.cpp", "void f() { QCoreApplication::processEvents(); }\n", 2, "no nested event loops"),
    ("widgets/common/loop3.cpp", "void f() { dialog.exec(); }\n", 2, "nested event loop"),
    ("app/loop4.cpp", "auto x = QMessageBox::question(this);\n", 2, "nested event loop"),
    ("app/loop5.cpp", "auto x = QFileDialog::getOpenFileName(this);\n", 2, "nested event loop"),
    ("widgets/common/connect.cpp", "void f() { connect(a, SIGNAL(b()), c, SLOT(d())); }\n", 2, "SIGNAL("),
    ("tests/wire/off.cpp", "int a;\n#if 0\nint b;\n#endif\n", 3, "remove what is switched off"),
    ("devices/model/await1.cpp", "    co_await Sleep{clock, 1s};\n", 2, "name the operand"),
    ("devices/model/await2.cpp", "    co_await f([x] {\n        g();\n    });\n", 2, "name the operand"),
    ("tests/model/await3.cpp", "    auto x = co_await (a ? std::move(b)\n         : std::move(c));\n", 2, "name the operand"),
    ("devices/model/text.cpp", 'auto x = QObject::tr("text");\n', 2, "no user text"),
    ("devices/model/said1.cpp", 'auto x = fail(Fault::Timeout, "no answer");\n', 2, "say("),
    ("devices/model/said2.cpp", 'auto x = Message::verbatim("no answer of " + name);\n', 2, "which has a translation"),
    ("devices/model/said3.cpp", 'auto x = say("no answer of " + name);\n', 2, "nothing is glued"),
    ("app/said4.cpp", 'auto x = say(std::string("no answer"));\n', 2, "say() takes a literal"),
    ("app/meant1.cpp", 'bool x = visit.cause.english().find("was not confirmed") != npos;\n', 2, "what a sentence means"),
    ("devices/model/meant2.cpp", "bool x = cause.english().starts_with(usedUp);\n", 2, "what a sentence means"),
    ("widgets/common/meant3.cpp", 'bool x = operation->status.title == "Update firmware";\n', 2, "OperationStatus::kind"),
    ("widgets/common/meant4.cpp", "bool x = experiment.title == job->status.title;\n", 2, "OperationStatus::kind"),
    ("app/meant5.cpp", "bool x = job.operation->status().title != updateTitle();\n", 2, "OperationStatus::kind"),
    ("widgets/common/english1.cpp", "auto x = qt(written.error().text());\n", 2, "errorText()"),
    ("widgets/common/english2.cpp", "auto x = QString::fromStdString(error.text());\n", 2, "errorText()"),
    ("widgets/common/key1.cpp", 'auto x = tr("%1 rows. "\n            "F5 reads them");\n', 2, "keyShown()"),
    ("widgets/common/key2.cpp", 'label->setText(tr("Ctrl+Shift+W writes"));\n', 2, "keyShown()"),
    ("tests/widgets/wait.cpp", "void f() { QTest::qWait(150); }\n", 2, "wait for a condition"),
    ("devices/model/number.cpp", "auto x = std::strtod(text, nullptr);\n", 2, "wire/number.h"),
    ("devices/families/one/number.cpp", "auto x = std::from_chars(a, b, c);\n", 2, "wire/number.h"),
    ("devices/model/throw.cpp", "void f() { throw 1; }\n", 2, "exceptions are not used"),
    ("devices/async/layer1.h", "#include <QString>\n", 2, "no Qt in devices/async/"),
    ("devices/wire/layer2.h", '#include "transport/link.h"\n', 2, "must not know this layer"),
    ("devices/transport/layer3.h", '#include "model/device.h"\n', 2, "must not know this layer"),
    ("devices/model/layer4.h", '#include "families/one/protocol.h"\n', 2, "must not know this layer"),
    ("devices/families/one/layer5.h", '#include "families/other/protocol.h"\n', 2, "must not know this layer"),
    ("devices/families/one/layer6.h", '#include "../other/protocol.h"\n', 2, "from the root of the library"),
    ("devices/families/one/layer7.h", "#include <QtGui/QColor>\n", 2, "nothing of the screen"),
    ("devices/model/layer8.h", "#  include <QWidget>\n", 2, "nothing of the screen"),
    ("widgets/common/layer9.h", '#include "families/one/protocol.h"\n', 2, "must not know this layer"),
    ("widgets/common/layer10.h", '#include "app/engine.h"\n', 2, "must not know this layer"),
    ("app/layer11.cpp", '#include "families/one/protocol.h"\n', 2, "must not know this layer"),
    ("app/console/layer12.cpp", '#include "widgets/common/theme.h"\n', 2, "must not know this layer"),
    ("app/console/layer13.cpp", "#include <QApplication>\n", 2, "nothing of the screen"),
    ("app/guardian/layer14.cpp", "#include <QString>\n", 2, "no Qt in app/guardian/"),
    ("widgets/common/long1.cpp", "void Page::build()\n" + body(61), 3, "Page::build has 61 lines; never more"),
    ("widgets/common/long2.cpp", "Page::Page(int a)\n    : B(a)\n    , m_x{1}\n    , m_y{a}\n" + body(61), 6, "Page::Page has 61 lines"),
    ("tests/wire/long3.cpp", "namespace {\nTEST(Area, SaysWhat)\n" + body(61) + "}\n", 4, "TEST(Area, SaysWhat) has 61 lines"),
    ("devices/model/long4.h", "class A : public B {\npublic:\n    int f() const\n" + body(61) + "};\n", 5, "f has 61 lines"),
    ("devices/model/long5.cpp", "int x;\n" * 500, 1, "never more than 500"),
    ("widgets/common/family1.cpp", "// comment\nauto x = \"dmc60c\";\n", 3, "dmc60c: what is known of a family"),
    ("app/family2.cpp", "using mb::quadquad2drv::axes;\n", 2, "quadquad2drv: what is known of a family"),
    ("devices/model/family3.cpp", 'auto x = "an Abstract DC Drive";\n', 2, "Abstract DC: what is known of a family"),
    ("devices/model/fact1.cpp", 'auto x = say("reset it without the jumper of its bootloader");\n', 2, "jumper: what is known of a family"),
    ("app/fact2.cpp", 'auto x = say("stored, the flash sequence number advanced");\n', 2, "sequence number: what is known of a family"),
    ("widgets/start/fact3.cpp", 'auto x = tr("15 s after its last change the unit stores by itself");\n', 2, "what is known of a family"),
    ("widgets/parameters/fact4.cpp", 'auto x = tr("Its own proof takes up to 20 s.");\n', 2, "what is known of a family"),
    ("app/console/fact5.cpp", 'bool f() { return target == "f1"; }\n', 2, "what is known of a family"),
    ("app/console/fact6.cpp", 'auto x = "a serial link, avrdude:PROGRAMMER:PORT";\n', 2, "avrdude: what is known of a family"),
    ("devices/model/key1.cpp", 'bool f() { return key.ends_with(".divisor"); }\n', 2, "says its Role"),
    ("devices/tuning/key2.cpp", 'bool f() { return key.ends_with("disabled"); }\n', 2, "says its Role"),
    ("devices/tuning/key3.cpp", 'int x;\nbool f() { return name == "p"; }\n', 3, "says its Role"),
    ("devices/tuning/key4.cpp", 'for (const std::string_view name : {"p", "i"}) {\n}\n', 2, "says its Role"),
    ("widgets/control/key5.cpp", 'auto x = findParameter(family.parameters,\n    axisKey(axis, "limit.power"));\n', 2, "says its Role"),
    ("devices/model/condition1.cpp", "void f()\n{\n    if (!co_await g(1))\n        h();\n}\n", 4, "name what a condition awaits"),
    ("devices/model/condition2.cpp", "void f()\n{\n    while (a == 1 && co_await g(1))\n        h();\n}\n", 4, "name what a condition awaits"),
    ("app/key6.cpp", 'constexpr std::string_view key = "current_limit.peak";\n', 2, "says its Role"),
    ("widgets/parameters/key7.cpp", 'bool f() { return key.starts_with("position."); }\n', 2, "says its Role"),
    ("widgets/control/key8.cpp", 'bool f() { return key.endsWith(QLatin1String(".ramp")); }\n', 2, "says its Role"),
    ("widgets/control/key9.cpp", 'auto *x = row("divisor");\n', 2, "says its Role"),
    ("tests/wire/path.cpp", 'auto file = "' + "/" + 'tmp/x";\n', 2, "no path of one machine"),
]

GOOD = [
    ("devices/async/task.h", "class PromiseBase {\n};\nclass Information;\nclass Baseline;\nclass Rebase;\n"),
    ("devices/model/a.cpp", "class QSerialPortInfo;\n// QTimer, sleep(1), #if 0\nauto x = \"QTimer sleep(1) tr(\";\n"),
    ("devices/model/b.cpp", "void f() { co_await Sleep(m_clock, 20ms); }\nVirtualClock clock;\n"),
    ("devices/model/c.cpp", "void f()\n{\n    if (const bool x = co_await g(1); x) {\n        h(a[1]);\n    }\n    if (y)\n        co_await h(2);\n}\n"),
    ("devices/model/d.h", "auto operator co_await() && noexcept { return Awaiter{m_handle}; }\n"),
    ("devices/model/e.cpp", "const char *x = R\"(co_await {)\";\nint y = 1'000'000;\nchar c = '\"'; // it's\n"),
    ("devices/transport/qtclock.cpp", "auto t = std::chrono::steady_clock::now();\n"),
    ("devices/families/one/a.cpp", '#include "families/one/protocol.h"\n#include "model/device.h"\n#include <QString>\n'),
    ("devices/model/h.cpp", "// 104 ms of a DMC60C\nint x;\n"),
    ("devices/families/one/fact.cpp", 'auto x = say("take the jumper out");\n'),
    ("widgets/parameters/fact.cpp", 'auto x = tr("The device should have stored by itself. Its own proof takes up to %1 s."); // 20 s of proof\n'),
    ("devices/families/one/b.cpp", 'auto x = "dmc60c";\n'),
    ("tests/model/family.cpp", 'auto x = "dmc60c";\n'),
    ("devices/families/one/key.cpp", 'bool f() { return key.ends_with(".p") || key == "gain.p"; }\n'),
    ("tests/tuning/key.cpp", 'auto x = findParameter(family.parameters, "slot0.p");\n'),
    ("devices/storage/key.cpp", 'const Numbers n{{"p", &G::p}, {"i", &G::i}}; // ends_with(".p")\nbool f() { return path.ends_with(".csv"); }\n'),
    ("widgets/plots/key.cpp", "bool f() { return text.endsWith(QLatin1Char('0')) || name == \"velocity\"; }\n"),
    ("devices/transport/a.cpp", "#include <QCoreApplication>\n#include <QtCore/QString>\n#include <sys/socket.h>\n"),
    ("widgets/common/a.cpp", 'auto x = tr("text");\n#include <QWidget>\nvoid f() { thread.exec(); }\n'),
    ("tests/widgets/a.cpp", "void f() { QCoreApplication::processEvents(); }\n"),
    ("tests/wire/a.cpp", 'auto file = "a/home/tmp/x";\n'),
    ("devices/model/said.cpp", 'auto x = fail(Fault::Timeout, say("%1 does not answer", name), Message::verbatim(line));\n'),
    ("widgets/common/c.cpp", "auto x = qt(link.text()) + tableText(status.title) + qt(message.english());\nbool y = row.title == other.title;\n"),
    ("app/d.cpp", 'std::fprintf(stderr, "%s\\n", error.text().c_str());\n'),
    ("tests/widgets/b.cpp", "void f() { QTest::qWait(0); QTest::qWaitFor(reached); }\n"),
    ("devices/model/f.cpp", "constexpr Row rows[] = {\n" + "    {1, 2},\n" * 100 + "};\n"),
    ("devices/model/g.cpp", "namespace {\nstruct A {\n" + "    int x;\n" * 100 + "};\n}\nvoid f()\n" + body(40)),
    ("widgets/common/b.cpp", "Page::Page(int a)\n    : m_x{a}\n" + body(25) + "void g()\n" + body(40)),
]


def complete(files):
    """With the headers that their .cpp files must have."""
    names = {name for name, _ in files}
    headers = {name[:-4] + ".h" for name in names if name.endswith(".cpp") and not name.startswith("tests/")}
    return [*files, *((name, LICENCE) for name in sorted(headers - names))]


def lint(files):
    with tempfile.TemporaryDirectory() as root:
        for name, text in files:
            path = pathlib.Path(root, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        done = subprocess.run([sys.executable, str(LINT), "--rules", "--root", root], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)
    return done.returncode, done.stdout


class Lint(unittest.TestCase):
    def test_every_bad_snippet_is_rejected_where_it_stands(self):
        _, output = lint(complete([(name, LICENCE + text) for name, text, _, _ in BAD]))
        findings = output.splitlines()
        for name, _, line, words in BAD:
            with self.subTest(name):
                found = [finding for finding in findings if finding.startswith(f"{name}:{line}: error: ") and words in finding]
                self.assertTrue(found, [finding for finding in findings if finding.startswith(f"{name}:")])

    def test_what_may_name_a_family_does(self):
        root = LINT.parents[1]
        for path in sorted(FAMILY_EXAMPLES):
            with self.subTest(path):
                self.assertTrue(FAMILY_NAME.search(without_comments((root / path).read_text(encoding="utf-8"))), "it needs no exception any more")

    def test_one_bad_snippet_alone_fails_the_run(self):
        name, text, _, _ = BAD[0]
        status, output = lint([(name, LICENCE + text)])
        self.assertEqual(status, 1, output)

    def test_the_harmless_twins_pass_without_a_word(self):
        files = complete([(name, LICENCE + text) for name, text in GOOD])
        status, output = lint(files)
        self.assertEqual((status, output), (0, f"lint: {len(files)} files, 0 errors, 0 warnings\n"))

    def test_a_missing_licence_line_is_rejected(self):
        for name, text in (("app/a.cpp", "int x;\n"), ("scripts/a", "#!/bin/sh\necho\n"), ("app/CMakeLists.txt", "x()\n")):
            with self.subTest(name):
                status, output = lint([(name, text)])
                self.assertEqual(status, 1, output)
                self.assertIn("the licence line is missing", output)

    def test_a_circle_of_units_or_of_folders_is_rejected_and_a_chain_is_not(self):
        chain = [("devices/model/a.h", LICENCE + '#include "model/b.h"\n'), ("devices/model/b.h", LICENCE + '#include "wire/c.h"\n'),
                 ("devices/wire/c.h", LICENCE + "int x;\n"), ("widgets/one/d.h", LICENCE + '#include "widgets/two/e.h"\n'),
                 ("widgets/two/e.h", LICENCE), ("devices/transport/f.cpp", LICENCE + '#include "transport/backends/g.h"\n'),
                 ("devices/transport/backends/g.h", LICENCE + '#include "transport/h.h"\n'), ("devices/transport/h.h", LICENCE)]
        status, output = lint(complete(chain))
        self.assertEqual(status, 0, output)
        status, output = lint([*chain, ("devices/model/b.cpp", LICENCE + '#include "model/a.h"\n')])
        self.assertEqual(status, 1)
        self.assertIn("error: circle of units: devices/model/a, devices/model/b", output)
        status, output = lint([*chain, ("widgets/two/i.cpp", LICENCE + '#include "widgets/one/d.h"\n')])
        self.assertEqual(status, 1)
        self.assertIn("error: circle of folders: widgets/one, widgets/two", output)

    def test_a_type_is_defined_once_in_the_program(self):
        one = "namespace mb {\nclass Rate final : public QObject {\n    struct Row {\n    };\n};\n}\n"
        two = "namespace mb {\nstruct Rate {\n};\n}\n"
        for other, is_rejected in ((two, True), (two.replace("namespace mb", "namespace mb::wire"), False), (two.replace("Rate", "Row"), False),
                                   ("namespace mb {\nnamespace {\nstruct Rate {\n};\n}\n}\n", False),
                                   ("namespace mb {\nstruct Rate::Row {\n};\nclass Rate;\n}\n", False)):
            with self.subTest(other):
                status, output = lint(complete([("devices/wire/a.h", LICENCE + one), ("widgets/monitor/b.h", LICENCE + other)]))
                self.assertEqual(status, int(is_rejected), output)
                self.assertEqual("widgets/monitor/b.h:3: error: mb::Rate is defined in devices/wire/a.h, too" in output, is_rejected, output)

    def test_half_a_budget_over_warns_and_passes(self):
        files = [("app/a.cpp", LICENCE + "void f()\n" + body(41)), ("app/b.cpp", LICENCE + "A::A()\n" + body(26)),
                 ("app/c.cpp", LICENCE + "int x;\n" * 300)]
        status, output = lint(complete(files))
        self.assertEqual(status, 0, output)
        for name in ("app/a.cpp:3", "app/b.cpp:3", "app/c.cpp:1"):
            self.assertIn(f"{name}: warning: ", output)
        self.assertIn("6 files, 0 errors, 3 warnings", output)

    def test_a_source_file_has_a_header_of_its_own_name(self):
        source = "int x;\n"
        for name, is_rejected in (("widgets/plots/plotstackextras.cpp", True), ("app/console/scan.cpp", False), ("app/main.cpp", False),
                                  ("devices/families/one/family.cpp", False), ("devices/families/one/controllertasks.cpp", True),
                                  ("devices/transport/backends/socketcanlinux.cpp", False), ("tests/wire/test_a.cpp", False)):
            with self.subTest(name):
                status, output = lint([(name, LICENCE + source)])
                self.assertEqual(status, int(is_rejected), output)
                self.assertEqual(f"{name}:1: error: no header has this name" in output, is_rejected, output)

    def test_a_class_has_at_most_thirty_functions_and_twenty_members(self):
        functions = "".join(f"    [[nodiscard]] std::function<void(int)> f{i}(int a = g()) const {{ return m_x; }}\n" for i in range(15)) + \
            "".join(f"    void g{i}(std::map<int, int> &map);\n" for i in range(15))
        members = "".join(f"    std::function<void(int)> m_{i}{{}}; ///< f(x)\n" for i in range(20))
        free = ("    A();\n    explicit A(int x);\n    ~A() override;\n    A(const A &) = delete;\n    A &operator=(const A &) = delete;\n"
                "    using F = void (*)(int);\n    friend class B;\n    static constexpr int most = f(3);\n    struct S {\n        int a, b;\n"
                "        void h();\n    };\n    enum class E { One, Two };\n")
        for more, words in (("", None), ("    void h();\n", "A has 31 functions and 20 members"), ("    int m_x;\n", "A has 30 functions and 21 members"),
                            ("    int a = 1, b;\n", "A has 30 functions and 22 members")):
            with self.subTest(more):
                text = f"class A final : public QObject {{\n    Q_OBJECT\npublic:\n{free}{functions}Q_SIGNALS:\nprivate:\n{members}{more}}};\n"
                status, output = lint([("widgets/common/a.h", LICENCE + text)])
                self.assertEqual(status, int(words is not None), output)
                if words:
                    self.assertIn(f"widgets/common/a.h:2: error: {words}", output)

    def test_a_struct_with_a_constructor_is_a_class_and_plain_data_is_none(self):
        members = "".join(f"    int a{i} = 0;\n" for i in range(21))
        for more, is_rejected in (("", False), ("    A();\n", True), ("    explicit A(int x)\n        : a0(x)\n    {\n    }\n", True)):
            with self.subTest(more):
                status, output = lint([("widgets/common/a.h", LICENCE + f"struct A {{\n{more}{members}}};\n")])
                self.assertEqual(status, int(is_rejected), output)

    def test_what_is_listed_with_its_reason_warns_and_the_list_shrinks(self):
        bad = ("widgets/plots/more.cpp", LICENCE)
        status, output = lint([bad, ("scripts/lint-exceptions", "# the list\n" + bad[0] + ": why\n")])
        self.assertEqual(status, 1, "a list without a licence line")
        listed = "# SPDX-License-Identifier: GPL-3.0-or-later\n"
        status, output = lint([bad, ("scripts/lint-exceptions", listed + bad[0] + ": why\nwidgets/gone.h Gone: why\n")])
        self.assertEqual(status, 0, output)
        self.assertIn("widgets/plots/more.cpp:1: warning: no header has this name", output)
        self.assertIn("scripts/lint-exceptions:3: warning: widgets/gone.h Gone is no exception any more", output)
        status, output = lint([bad, ("scripts/lint-exceptions", listed + bad[0] + ":\n")])
        self.assertEqual(status, 1, output)
        self.assertIn("scripts/lint-exceptions:2: error: an exception has a reason", output)


class Tidy(unittest.TestCase):
    def test_a_file_that_is_not_compiled_by_itself_is_told_not_left_out(self):
        with tempfile.TemporaryDirectory() as place:
            root = pathlib.Path(place).resolve()
            (root / "app").mkdir()
            for name in ("a", "b"):
                (root / "app" / f"{name}.cpp").write_text(LICENCE, encoding="utf-8")
            compiled = {"file": str(root / "app" / "a.cpp"), "directory": str(root), "command": "c++ -c app/a.cpp"}
            (root / "compile_commands.json").write_text(json.dumps([compiled]), encoding="utf-8")
            (root / "clang-tidy").write_text("#!/bin/sh\n", encoding="utf-8")
            (root / "clang-tidy").chmod(0o755)
            done = subprocess.run([LINT, "--root", root, "--tidy", root], env={**os.environ, "PATH": f"{root}:{os.environ['PATH']}"},
                                  text=True, stdout=subprocess.PIPE, check=False)
            self.assertEqual(done.returncode, 1)
            self.assertEqual(done.stdout, f"app/b.cpp: error: not compiled by itself in {root}\ntidy: 1 files, 1 findings\n")


if __name__ == "__main__":
    unittest.main()
