#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The scripts, with stand-ins for what they call: what they say, and how they end."""
import os
import pathlib
import shlex
import shutil
import signal
import subprocess
import tempfile
import threading
import unittest

SCRIPTS = pathlib.Path(__file__).resolve().parents[2] / "scripts"
GOOGLETEST = "[  PASSED  ] 3 tests.\n[  SKIPPED ] 1 test, listed below:\n[  FAILED  ] 2 tests, listed below:\n"
JUNIT = ('<testsuite><testcase name="a" status="run"><system-out>[  PASSED  ] 5 tests.</system-out></testcase>'
         '<testcase name="b" status="{status}">{inside}<system-out>{output}</system-out></testcase></testsuite>')


def terminated(process):
    """What it has printed until it ended. It is told each second: bash overlooks what comes just before it begins to wait."""
    ended = threading.Event()

    def terminate():
        while not ended.wait(1):
            process.terminate()

    process.terminate()
    again = threading.Thread(target=terminate)
    again.start()
    try:
        return process.communicate(timeout=60)[0]
    finally:
        ended.set()
        again.join()


class Place(unittest.TestCase):
    """A folder for each test, with programs that stand in for the real ones."""

    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.root = pathlib.Path(place.name)
        self.bin = self.root / "bin"
        self.bin.mkdir()

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        path.chmod(0o755)
        return path

    def stand_in(self, name, script):
        self.write(f"bin/{name}", "#!/bin/bash\n" + script)

    def command(self, *arguments):
        environment = {**os.environ, "PATH": f"{self.bin}:{os.environ['PATH']}"}
        return {"args": [str(argument) for argument in arguments], "env": environment, "text": True,
                "stdout": subprocess.PIPE, "stderr": subprocess.STDOUT}

    def run_here(self, *arguments):
        done = subprocess.run(**self.command(*arguments), check=False)
        return done.returncode, done.stdout


class InstallPackages(Place):
    def setUp(self):
        super().setUp()
        self.called = self.root / "called"
        self.stand_in("apt-get", f'echo "$*" >>{self.called}\n')
        self.stand_in("id", "echo 0\n")

    def has(self, condition):
        self.stand_in("dpkg-query", f'for name; do :; done\nif {condition}; then echo installed; else exit 1; fi\n')

    def calls(self):
        return self.called.read_text().splitlines() if self.called.exists() else []

    def test_asks_for_nothing_when_nothing_is_missing(self):
        self.has("true")
        self.assertEqual(self.run_here(SCRIPTS / "install-packages", "test"), (0, ""))
        self.assertEqual(self.calls(), [])

    def test_installs_only_what_is_missing_after_a_refresh(self):
        self.has('[ "$name" != ccache ] && [ "$name" != socat ]')
        status, _ = self.run_here(SCRIPTS / "install-packages", "test")
        self.assertEqual(status, 0)
        self.assertEqual([call.split(" -y ")[1] for call in self.calls()], ["update", "install --no-install-recommends ccache socat"])

    def test_the_demo_needs_no_test_packages(self):
        self.has('[ "$name" != socat ]')
        self.assertEqual(self.run_here(SCRIPTS / "install-packages", "demo"), (0, ""))

    def test_without_rights_one_line_gives_the_command(self):
        self.has('[ "$name" != ccache ]')
        self.stand_in("id", "echo 1000\n")
        self.stand_in("sudo", "exit 1\n")
        status, output = self.run_here(SCRIPTS / "install-packages", "demo")
        self.assertEqual((status, len(output.splitlines())), (1, 1))
        self.assertIn("apt-get install -y --no-install-recommends ccache", output)
        self.assertEqual(self.calls(), [])

    def test_without_sudo_the_line_says_as_root(self):
        self.has('[ "$name" != ccache ]')
        self.stand_in("id", "echo 1000\n")
        for name in ("bash", "env", "dirname"):
            (self.bin / name).symlink_to(shutil.which(name))
        command = self.command(SCRIPTS / "install-packages", "demo")
        command["env"]["PATH"] = str(self.bin)
        output = subprocess.run(**command, check=False).stdout
        self.assertEqual(output.splitlines(), ["install-packages: no rights to install; run as root: apt-get update && apt-get install -y --no-install-recommends ccache"])

    def test_a_failing_installation_is_told(self):
        self.has("false")
        self.stand_in("apt-get", "echo no network; exit 100\n")
        status, output = self.run_here(SCRIPTS / "install-packages", "demo")
        self.assertEqual(status, 1)
        self.assertIn("no network", output)
        self.assertIn("could not install: cmake", output)


class Tally(Place):
    def tally(self, name, text):
        return self.run_here(SCRIPTS / "tally", self.write(name, text))[1].strip()

    def test_counts_the_cases_of_each_kind_of_program(self):
        self.assertEqual(self.tally("a.log", GOOGLETEST + "\nexit status 1\n"), "3 2 1")
        self.assertEqual(self.tally("a.log", "Totals: 7 passed, 1 failed, 2 skipped, 0 blacklisted, 9ms\n\nexit status 1\n"), "7 1 2")
        self.assertEqual(self.tally("a.log", "Ran 9 tests in 0.1s\n\nFAILED (failures=1, errors=2)\n\nexit status 1\n"), "6 3 0")
        self.assertEqual(self.tally("a.log", "Ran 9 tests in 0.1s\n\nOK (skipped=1)\n\nexit status 0\n"), "8 0 1")

    def test_a_crash_is_a_failure_though_no_case_is_named(self):
        self.assertEqual(self.tally("a.log", "[  PASSED  ] 3 tests.\n\nexit status 139\n"), "3 1 0")
        self.assertEqual(self.tally("a.log", "half a li"), "0 1 0")

    def test_an_attempt_that_was_repeated_does_not_count(self):
        self.assertEqual(self.tally("a.log", "| [  FAILED  ] 1 test, listed below:\n[  PASSED  ] 3 tests.\n\nexit status 0\n"), "3 0 0")

    def test_a_program_that_counts_nothing_is_one(self):
        self.assertEqual(self.tally("a.log", "fine\n\nexit status 0\n"), "1 0 0")

    def test_a_program_that_says_that_it_ran_none_is_none(self):
        self.assertEqual(self.tally("a.log", "[==========] 0 tests from 0 test suites ran. (0 ms total)\n[  PASSED  ] 0 tests.\n\nexit status 0\n"), "0 0 0")
        self.assertEqual(self.tally("a.log", "Ran 0 tests in 0.000s\n\nOK\n\nexit status 0\n"), "0 0 0")

    def test_names_the_programs_that_failed(self):
        xml = self.write("a.xml", JUNIT.format(status="fail", inside="<failure/>", output=""))
        log = self.write("asan-model-14.log", "[  PASSED  ] 3 tests.\n\nexit status 1\n")
        fine = self.write("fine.log", "[  PASSED  ] 3 tests.\n\nexit status 0\n")
        self.assertEqual(self.run_here(SCRIPTS / "tally", "--failed", xml, log, fine), (0, "b\nasan-model-14\n"))

    def test_reads_what_ctest_writes(self):
        rows = (("run", "", "[  PASSED  ] 2 tests.", "7 0 0"), ("fail", "<failure/>", "", "5 1 0"),
                ("notrun", '<skipped message="Unable to find executable"/>', "", "5 1 0"),
                ("notrun", '<skipped message="SKIP_RETURN_CODE=77"/>', "", "5 0 1"))
        for status, inside, output, expected in rows:
            with self.subTest(status + inside):
                self.assertEqual(self.tally("a.xml", JUNIT.format(status=status, inside=inside, output=output)), expected)


class Test(Place):
    def setUp(self):
        super().setUp()
        for name in ("test", "steps.sh", "tally"):
            self.write(f"scripts/{name}", (SCRIPTS / name).read_text())
            shutil.copymode(SCRIPTS / name, self.root / "scripts" / name)
        self.write("scripts/install-packages", "#!/bin/bash\n")
        self.write("scripts/lint", "#!/bin/bash\n")
        self.program("scripts/package", "[  PASSED  ] 1 test.")
        self.program("tests/socketcan/run", "[  PASSED  ] 2 tests.")
        self.stand_in("cmake", "")
        self.ctest('<testcase status="run"><system-out>[  PASSED  ] 4 tests.</system-out></testcase>')

    def ctest(self, cases, status=0):
        self.stand_in("ctest", 'case "$*" in *"-L realtime"*) cases= ;; *) cases=' + shlex.quote(cases) + ' ;; esac\n'
                      'while [ "$1" != --output-junit ]; do shift; done\n'
                      f'echo "<testsuite>$cases</testsuite>" >"$2"\nexit {status}\n')

    def program(self, name, says, then=""):
        self.write(name, f'#!/bin/bash\necho "{says}"\n{then}\n')

    def sanitized(self, **says):
        """Test programs of every area under both sanitizers: the first share of each has one test, or what is said of the area."""
        self.stand_in("nproc", "echo 1\n")
        one = "[  PASSED  ] $((GTEST_SHARD_INDEX == 0)) tests."
        for area in ("async", "wire", "transport", "model", "families", "tuning"):
            self.program(f"build/asan/bin/test_{area}", says.get(area, one))
        self.program("build/tsan/bin/test_async", one)

    def run_test(self, *options):
        status, output = self.run_here(self.root / "scripts" / "test", *(options or ["--quick"]))
        return status, output.splitlines()

    def closing(self, *options):
        status, lines = self.run_test(*options)
        return status, lines[-1]

    def test_ends_with_the_numbers(self):
        self.assertEqual(self.closing(), (0, "7 passed, 0 failed"))

    def test_counts_the_suite_with_real_can_interfaces(self):
        self.program("tests/socketcan/run", GOOGLETEST, "exit 1")
        self.assertEqual(self.closing(), (1, "8 passed, 2 failed"))

    def test_without_one_of_its_programs_fails(self):
        for name in ("tests/socketcan/run", "scripts/package"):
            with self.subTest(name):
                self.setUp()
                (self.root / name).unlink()
                status, last = self.closing()
                self.assertEqual((status, last.split(", ")[1]), (1, "1 failed"))

    def test_counts_what_the_sanitizers_say_of_each_share(self):
        self.sanitized()
        share = '[  PASSED  ] $((GTEST_SHARD_INDEX + 1)) tests.'
        self.program("build/asan/bin/test_async", share, '[ "$GTEST_TOTAL_SHARDS" = 16 ]')
        self.program("build/tsan/bin/test_async", share, "[ $GTEST_SHARD_INDEX != 1 ] || exit 66")
        self.assertEqual(self.closing(""), (1, "284 passed, 1 failed"))

    def test_an_area_of_which_a_sanitizer_runs_nothing_is_a_failure(self):
        self.sanitized()
        self.assertEqual(self.closing(""), (0, "14 passed, 0 failed"))
        self.sanitized(families="[  PASSED  ] 0 tests.")
        self.assertEqual(self.closing(""), (1, "13 passed, 1 failed"))
        (self.root / "build/asan/bin/test_families").unlink()
        self.assertEqual(self.closing("")[0], 1)

    def test_what_any_program_keeps_in_a_folder_of_its_user_is_a_failure(self):
        for folder, name in (("DATA", "motorbench/motorbench.db"), ("CONFIG", "MotorBench/MotorBench.conf"), ("CACHE", "motorbench/scans/one")):
            keep = f'mkdir -p "$(dirname "$XDG_{folder}_HOME/{name}")" && touch "$XDG_{folder}_HOME/{name}"'
            for program in ("scripts/package", "build/tsan/bin/test_async"):
                with self.subTest(name, program=program):
                    self.setUp()
                    self.sanitized()
                    self.program(program, "[  PASSED  ] $((GTEST_SHARD_INDEX == 0)) tests.", keep)
                    self.assertEqual(self.closing("--quick" if program == "scripts/package" else "")[0], 1)

    def test_what_ran_twice_is_named(self):
        self.stand_in("ctest", 'while [ "$1" != --output-junit ]; do shift; done\n'
                      'echo \'<testsuite><testcase status="run"/></testsuite>\' >"$2"\n'
                      'printf "      Start  1: slow\\n      Start 12: quick\\n      Start  1: slow\\n"\n')
        status, lines = self.run_test()
        self.assertEqual(status, 0)
        self.assertIn("only at the second attempt, if at all: slow", lines)
        self.assertFalse([line for line in lines if line.endswith("all: quick")])

    def test_a_failing_test_is_counted_and_told(self):
        self.ctest('<testcase status="fail"><failure/></testcase>', status=8)
        self.assertEqual(self.closing(), (1, "3 passed, 1 failed"))

    def test_what_failed_is_named_before_the_numbers(self):
        self.sanitized()
        self.write("scripts/lint", "#!/bin/bash\nexit 1\n")
        self.program("build/asan/bin/test_model", "[  PASSED  ] $((GTEST_SHARD_INDEX == 0)) tests.", "[ $GTEST_SHARD_INDEX != 14 ]")
        self.assertEqual(self.run_test("")[1][-3:], ["failed: asan-model-14", "failed: lint", "14 passed, 2 failed"])

    def test_a_failing_stage_does_not_hide_the_others(self):
        self.write("scripts/lint", "#!/bin/bash\nexit 1\n")
        self.assertEqual(self.closing(), (1, "7 passed, 1 failed"))

    def test_a_failing_build_ends_with_the_numbers(self):
        self.stand_in("cmake", "exit 1\n")
        self.assertEqual(self.closing(), (1, "0 passed, 1 failed"))

    def test_without_the_packages_nothing_is_run(self):
        self.write("scripts/install-packages", "#!/bin/bash\nexit 1\n")
        self.assertEqual(self.closing(), (1, "0 passed, 1 failed"))

    def test_tests_that_leave_no_results_are_a_failure(self):
        self.stand_in("ctest", "exit 0\n")
        self.assertEqual(self.closing(), (1, "3 passed, 2 failed"))

    def test_being_stopped_is_told(self):
        started = self.root / "started"
        os.mkfifo(started)
        self.stand_in("cmake", f"echo >{started}\nexec sleep 60\n")
        with subprocess.Popen(**self.command(self.root / "scripts" / "test", "--quick"), start_new_session=True) as process:
            with open(started, encoding="utf-8"):
                os.killpg(process.pid, signal.SIGTERM)
            output, _ = process.communicate()
        self.assertNotEqual(process.returncode, 0)
        self.assertRegex(output, r"ended before everything was run\n0 passed, [12] failed\n$")


class Package(Place):
    """scripts/package in a checkout of two files, with stand-ins for all of Debian's tools."""

    def setUp(self):
        super().setUp()
        self.write("scripts/package", (SCRIPTS / "package").read_text())
        self.write("scripts/install-packages", "#!/bin/bash\n")
        self.write("CMakeLists.txt", "project(MotorBench VERSION 1.2.3\n")
        for name in ("dpkg-buildpackage", "lintian", "desktop-file-validate", "appstreamcli", "man"):
            self.stand_in(name, "")
        self.stand_in("dpkg-deb", '[ "$1" != --contents ] || echo - - - - - ./usr/bin/motorbenchctl\n')
        self.stand_in("dpkg-parsechangelog", "echo 1.2.3\n")
        subprocess.run(["git", "init", "--quiet", self.root], check=True)

    def headings(self):
        status, output = self.run_here(self.root / "scripts" / "package")
        return status, [line for line in output.splitlines() if line.startswith("==")]

    def test_a_desktop_entry_that_is_not_valid_is_a_failure(self):
        self.assertIn("== manual pages", self.headings()[1])
        self.stand_in("desktop-file-validate", "exit 1\n")
        self.assertEqual(self.headings(), (1, ["== packages", "== lintian", "== desktop"]))

    def test_without_a_checkout_one_line_says_so(self):
        shutil.rmtree(self.root / ".git")
        status, output = self.run_here(self.root / "scripts" / "package")
        self.assertEqual((status, len(output.splitlines())), (1, 1), output)
        self.assertIn("no git checkout", output)

    def test_a_checkout_of_another_user_is_packed(self):
        command = self.command(self.root / "scripts" / "package")
        command["env"]["GIT_TEST_ASSUME_DIFFERENT_OWNER"] = "1"
        self.assertIn("== packages", subprocess.run(**command, check=False).stdout)
        self.assertTrue((self.root / "build/package/motorbench-1.2.3/CMakeLists.txt").exists())


class Soak(Place):
    def test_a_failing_test_with_real_can_interfaces_does_not_hide_the_others(self):
        for name in ("soak", "steps.sh"):
            self.write(f"scripts/{name}", (SCRIPTS / name).read_text())
        self.write("scripts/install-packages", "#!/bin/bash\n")
        self.write("tests/socketcan/run", "#!/bin/bash\nexit 3\n")
        self.stand_in("cmake", "")
        self.stand_in("ctest", "echo the others\n")
        status, output = self.run_here(self.root / "scripts" / "soak", "tests")
        self.assertEqual((status, output.splitlines()[-1]), (3, "the others"))


class Compilers(Place):
    def test_there_are_as_many_as_the_memory_holds_and_at_least_one(self):
        self.stand_in("nproc", "echo 8\n")
        for kilobytes, expected in ((64000000, 8), (5000000, 4), (300000, 1)):
            with self.subTest(kilobytes):
                memory = self.write("meminfo", f"MemTotal: 99000000 kB\nMemAvailable: {kilobytes} kB\n")
                command = self.command("bash", "-c", f"source {shlex.quote(str(SCRIPTS / 'steps.sh'))}; echo $compilers")
                command["env"]["MOTORBENCH_MEMINFO"] = str(memory)
                self.assertEqual(subprocess.run(**command, check=False).stdout, f"{expected}\n")


class Beside(Place):
    """What scripts have in the background. Standard output is a pipe that has an end only when the last of them is gone."""

    def script(self, lines):
        return self.write("script", f"""#!/bin/bash
            set -euo pipefail
            source {shlex.quote(str(SCRIPTS / 'steps.sh'))}
            trap end_beside EXIT
            trap 'exit 143' TERM
            some() {{ echo "$1"; sleep "$2"; return "$3"; }}
            {lines}""")

    def test_the_status_is_that_of_the_last_that_failed(self):
        status, output = self.run_here(self.script("lanes=2; for each in 0 3 0 0 0; do beside some a 0 $each; done; all_beside || echo $?; beside some b 0 0; all_beside"))
        self.assertEqual((status, output), (0, "a\na\na\na\na\n3\nb\n"))

    def test_no_more_run_than_there_are_lanes(self):
        script = self.script("lanes=2; one() { jobs=$(find %s -name 'now.*' | wc -l); echo $jobs; }; " % self.root +
                             "each() { touch $1; one; sleep 0.1; rm $1; }; for n in 1 2 3 4 5 6; do beside each %s/now.$n; done; all_beside" % self.root)
        self.assertLessEqual(set(self.run_here(script)[1].split()), {"1", "2"})

    def test_a_script_that_is_ended_leaves_nothing_behind(self):
        with subprocess.Popen(**self.command(self.script("beside some begun 600 0; all_beside"))) as process:
            self.assertEqual(process.stdout.readline(), "begun\n")
            self.assertEqual(terminated(process), "")
        self.assertEqual(process.returncode, 143)


class CanKernel(Place):
    """scripts/in-can-kernel where the running kernel has CAN."""

    def setUp(self):
        super().setUp()
        self.stand_in("modprobe", "")
        self.stand_in("ip", "")
        self.stand_in("unshare", 'while [[ $1 = -* ]]; do shift; done\nexec "$@"\n')
        self.place = self.root / "with a space"
        self.place.mkdir()

    def start(self, *arguments):
        command = self.command(SCRIPTS / "in-can-kernel", *arguments)
        command["env"]["TMPDIR"] = str(self.place)
        return subprocess.Popen(**command)

    def test_folders_may_have_a_space(self):
        with self.start("bash", "-c", 'touch "$TMPDIR/a"; echo "$XDG_DATA_HOME"; exit 7') as process:
            self.assertIn("/with a space/", process.communicate()[0])
        self.assertEqual((process.returncode, list(self.place.iterdir())), (7, []))

    def test_when_it_is_ended_so_is_the_command(self):
        with self.start("bash", "-c", "echo begun; sleep 600") as process:
            self.assertEqual(process.stdout.readline(), "begun\n")
            terminated(process)
        self.assertEqual((process.returncode, list(self.place.iterdir())), (143, []))

    def test_the_command_hears_an_interrupt(self):
        with self.start("python3", "-c", "import signal; print(signal.getsignal(signal.SIGINT) is signal.default_int_handler)") as process:
            self.assertEqual(process.communicate()[0], "True\n")


class Demo(Place):
    def setUp(self):
        super().setUp()
        for name in ("demo", "steps.sh"):
            self.write(f"scripts/{name}", (SCRIPTS / name).read_text())
        self.write("scripts/install-packages", "#!/bin/bash\n")
        self.stand_in("cmake", "")
        self.program('echo "$QT_QPA_PLATFORM $*"; touch "${2:-.}/1.png" "${2:-.}/2.png"')

    def program(self, script):
        self.write("build/release/bin/motorbench", f"#!/bin/bash\n{script}\n")

    def demo(self, *arguments, **displays):
        none = {"DISPLAY": "", "WAYLAND_DISPLAY": "", "QT_QPA_PLATFORM": ""}
        command = self.command(self.root / "scripts" / "demo", *arguments)
        command["env"].update(none, **displays)
        done = subprocess.run(**command, check=False)
        return done.returncode, done.stdout.splitlines()[-1]

    def test_opens_the_window_where_there_is_a_display(self):
        self.assertEqual(self.demo(DISPLAY=":0"), (0, " --demo"))
        self.assertEqual(self.demo(WAYLAND_DISPLAY="wayland-0"), (0, " --demo"))

    def test_without_a_display_says_where_the_pictures_are(self):
        for arguments, folder in (((), self.root / "tour"), ((self.root / "else" / "where",), self.root / "else" / "where")):
            status, last = self.demo(*arguments)
            self.assertEqual(status, 0)
            self.assertTrue(last.endswith(f"2 pictures of its pages: {folder.resolve()}"), last)

    def test_a_tour_without_pictures_is_a_failure(self):
        self.program("exit 0")
        self.assertEqual(self.demo()[0], 1)

    def test_a_failing_build_opens_nothing(self):
        self.stand_in("cmake", "exit 1\n")
        self.program(f"touch {self.root}/opened")
        self.assertEqual(self.demo(DISPLAY=":0")[0], 1)
        self.assertFalse((self.root / "opened").exists())


class Shell(unittest.TestCase):
    def test_every_shell_script_parses_and_can_be_started(self):
        shell = [path for path in [*SCRIPTS.iterdir(), SCRIPTS.parent / ".ci" / "run"]
                 if path.is_file() and path.read_text(encoding="utf-8").startswith("#!/usr/bin/env bash")]
        self.assertGreater(len(shell), 5)
        for path in shell:
            with self.subTest(path.name):
                self.assertTrue(os.access(path, os.X_OK))
                subprocess.run(["bash", "-n", str(path)], check=True)


if __name__ == "__main__":
    unittest.main()
