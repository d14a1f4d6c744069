# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs every command of the documentation.

What stands in a block ```console is promised to work as it stands, without hardware: its status is 0, or the one that `echo $?`
prints below it. Other commands of our programs (blocks ```sh, indented lines, words in backquotes) may need hardware that is not
here, so they may fail with no device (3), stop (4) or link (5), or go on; wrong usage (2) they are never. A verb alone is asked
for its help. What the administrator
has to do is not done: the shell has to understand it."""
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import unittest

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import consolepage  # noqa: E402 pylint: disable=wrong-import-position
import ownhome  # noqa: E402 pylint: disable=wrong-import-position

PROGRAMS = pathlib.Path()
SOURCE = pathlib.Path()
OURS = re.compile(r"(?:^|[|;&]\s*|\s)(?:\S*/)?(?:motorbenchctl|motorbench)\b")
PLACEHOLDER = re.compile(r"\b[A-Z]{3,}\b|…|\bUNIT\b|\bN\b")  # DEVICE, FILE: not a command as it stands
STRICT_SECONDS = 120
LOOSE_SECONDS = 3
WRONG_USAGE = 2
RECORDING = "".join(f"(1700000000.{20000 * i:06d}) can0 02061405#0040110000000000\n" for i in range(20))  # status frames of a DMC60C


def pages(translated=False):
    """In English; the commands of a translated page are the same (build.helppages)."""
    every = sorted((SOURCE / "docs").rglob("*.md"))
    return [SOURCE / "README.md", *(page for page in every if translated or len(page.relative_to(SOURCE / "docs").parts[0]) != 2)]


def blocks(text):
    """(language, line, lines) of each fenced block; the language of indented text is empty."""
    fence, begun, lines = None, 0, []
    for number, line in enumerate(text.splitlines(), 1):
        opened = re.match(r"```(\w*)", line)
        if opened and fence is None:
            fence, begun, lines = opened[1], number, []
        elif opened:
            yield fence, begun + 1, lines
            fence = None
        elif fence is not None:
            lines.append(line)
        elif line.startswith("    ") and line.strip():
            yield "", number, [line.strip()]


def commands(text):
    """(line, command, strict, expected status)"""
    for language, begun, lines in blocks(text):
        prompted = any(line.startswith("$ ") for line in lines)
        for at, line in enumerate(lines):
            if language not in ("console", "sh", "") or (prompted and not line.startswith("$ ")):
                continue
            command = line.removeprefix("$ ").split("  #")[0].strip()
            if not OURS.search(command) or command.startswith("#"):
                continue
            status = 0
            if re.search(r";\s*echo \$\?$", command):
                following = [row for row in lines[at + 1:] if re.fullmatch(r"\d", row)]
                status = int(following[0]) if following else 0
                command = re.sub(r";\s*echo \$\?$", "", command)
            yield begun + at, command, language == "console", status
    for number, line in enumerate(text.splitlines(), 1):
        for quoted in re.findall(r"`((?:motorbenchctl|motorbench) [^`]+)`", line):
            words = quoted.split()
            yield number, f"{quoted} --help" if len(words) == 2 and not words[1].startswith("-") else quoted, False, 0


class Docs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.home = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.home.name)
        (folder / "resources").symlink_to(SOURCE / "resources")
        cls.environment = {**os.environ, **ownhome.folders(cls.home.name), "PATH": f"{PROGRAMS}:{os.environ['PATH']}", "QT_QPA_PLATFORM": "offscreen", "LC_ALL": "C.UTF-8"}
        (folder / "bus.log").write_text(RECORDING, encoding="ascii")  # for what is done with a recording

    @classmethod
    def tearDownClass(cls):
        cls.home.cleanup()

    def run_command(self, command, seconds):
        """(status, words); status None: it was still running."""
        process = subprocess.Popen(["bash", "-o", "pipefail", "-o", "noclobber", "-c", command], cwd=self.home.name, env=self.environment, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True)
        try:
            words, _ = process.communicate(timeout=seconds)
            return process.returncode, words
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            return None, process.communicate()[0]

    def test_every_command_is_one(self):
        strict = loose = 0
        for page in pages():
            for line, command, promised, status in commands(page.read_text(encoding="utf-8")):
                where = f"{page.relative_to(SOURCE)}:{line}: {command}"
                if "sudo" in command or command.startswith("./") or PLACEHOLDER.search(re.sub(r"'[^']*'|\"[^\"]*\"", "", command)):
                    continue
                with self.subTest(where):
                    ended, words = self.run_command(command, STRICT_SECONDS if promised else LOOSE_SECONDS)
                    if promised:
                        strict += 1
                        self.assertEqual(ended, status, f"{where}\n{words}")
                    else:
                        loose += 1
                        self.assertNotIn(ended, (WRONG_USAGE, 126, 127), f"{where}\n{words}")
        print(f"{strict} commands do what they promise, {loose} more are understood")
        self.assertGreater(strict, 20)

    def test_the_page_of_the_console_is_what_the_program_says(self):
        program, now = PROGRAMS / "motorbenchctl", (SOURCE / "docs" / "console.md").read_text(encoding="utf-8")
        self.assertEqual(now, consolepage.page(program, now), f"tests/docs/consolepage.py {program} docs/console.md writes it anew")
        for verb, example in consolepage.EXAMPLE.findall(now):
            self.assertRegex(example, rf"motorbenchctl {verb}\b")

    def test_the_administrators_commands_are_understood_by_a_shell(self):
        found = 0
        for page in pages():
            for _language, line, lines in blocks(page.read_text(encoding="utf-8")):
                for command in lines:
                    if re.match(r"(?:\$ )?sudo |.*\| sudo ", command):
                        found += 1
                        checked = subprocess.run(["bash", "-n", "-c", command.removeprefix("$ ")], capture_output=True, text=True, check=False)
                        self.assertEqual(checked.returncode, 0, f"{page.name}:{line}: {checked.stderr}")
        self.assertGreater(found, 0)

    def test_every_link_leads_somewhere(self):
        for page in pages(translated=True):
            for target in re.findall(r"\]\(([^)#]+)(?:#[^)]*)?\)", page.read_text(encoding="utf-8")):
                if "://" not in target:
                    self.assertTrue((page.parent / target).exists(), f"{page.relative_to(SOURCE)}: {target}")

    def test_the_drawings_are_those_of_their_script(self):
        checked = subprocess.run([SOURCE / "scripts" / "drawings", "--check"], capture_output=True, text=True, check=False)
        self.assertEqual(checked.returncode, 0, checked.stderr)

    def test_every_picture_is_made_by_a_script(self):
        listed = subprocess.run([SOURCE / "scripts" / "pictures", "--list"], capture_output=True, text=True, check=True).stdout.split()
        self.assertEqual(sorted(listed), sorted(picture.stem for picture in (SOURCE / "docs" / "pictures").glob("*.png")))
        shown = "".join(page.read_text(encoding="utf-8") for page in pages())
        for name in listed:
            self.assertIn(f"pictures/{name}.png", shown)

    def test_the_pages_that_people_are_led_to_are_there(self):
        for name in ("first-hour", "tuning", "service", "safety", "files", "troubleshooting", "hardware/dmc60c", "hardware/supermodified",
                     "hardware/abstractdc", "hardware/quadquad2drv"):
            self.assertTrue((SOURCE / "docs" / f"{name}.md").exists(), name)
            self.assertIn(f"docs/{name}.md", (SOURCE / "README.md").read_text(encoding="utf-8"))


if __name__ == "__main__":
    PROGRAMS, SOURCE = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
