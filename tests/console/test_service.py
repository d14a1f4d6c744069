# SPDX-License-Identifier: GPL-3.0-or-later
"""test_service.py PROGRAM SOURCE: recipes over the simulated bench, their journal, and what goes on after a cut."""
import csv
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile

import contract
from contract import ContractTest, Run

LINE = {"unit", "serial", "device", "result", "step", "from", "to", "parameters", "test", "seconds", "evidence"}
ENTRY = LINE | {"time", "station", "recipe", "note"}
TEST = {"loop": "velocity", "to": 8000, "time": 0.8, "limits": {"travel": 400000, "speed": 40000, "duty": 0.9, "current": 60},
        "accept": {"settle": 1.5}}


class Recipes(ContractTest):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        shutil.copy(os.path.join(contract.SOURCE, "resources/firmware/dmc60c-demo.hex"), self.folder.name)
        self.write("base.json", {"family": "dmc60c", "parameters": {"slot1.d": {"raw": 77}}})

    def write(self, name, content):
        path = os.path.join(self.folder.name, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(content if isinstance(content, str) else json.dumps(content, indent=1))
        return path

    def recipe(self, **parts):
        return self.write("recipe.json", {"recipe": 1, "name": "rev C", "family": "dmc60c", **parts})


class Service(Recipes):
    @contract.long
    def test_every_unit_of_the_bench_has_its_line_and_its_entry(self):
        recipe = self.recipe(firmware={"file": "dmc60c-demo.hex"}, parameters={"file": "base.json"}, number={"first": 20}, test=TEST)
        run = Run(["--json", "service", recipe, "sim:can", "--station", "bench 2"])
        lines = run.objects()
        self.assertEqual(set(lines[-1]), {"summary"})
        self.assertEqual(set(lines[-1]["summary"]), {"passed", "failed", "refused", "seconds"})
        units = lines[:-1]
        self.assertEqual(len(units), 3, run.err)
        for unit in units:
            self.assertEqual(set(unit), LINE)
            self.assertEqual(unit["result"], "passed", unit)
            self.assertEqual((unit["to"], unit["parameters"], unit["step"]), ("1.25", 1, "done"))
            self.assertGreater(unit["test"]["settle"], 0)
        self.assertEqual(run.status, 0, run.err)
        self.assertEqual([unit["device"] for unit in units], [f"sim:can/dmc60c:{n}" for n in (20, 21, 22)])
        self.assertEqual(lines[-1]["summary"]["passed"], 3)
        entries = self.run_one("journal")["entries"]
        self.assertEqual(len(entries), 3)
        for entry, unit in zip(entries, units):
            self.assertEqual(set(entry), ENTRY)
            self.assertEqual({key: entry[key] for key in LINE}, unit)
            self.assertEqual((entry["station"], entry["recipe"], entry["note"]), ("bench 2", "rev C", ""))
        serial = units[1]["serial"]
        self.assertEqual([entry["serial"] for entry in self.run_one("journal", "--serial", serial)["entries"]], [serial])
        self.assertEqual(self.run_one("journal", "--since", "2200-01-01")["entries"], [])
        self.assertEqual(len(self.run_one("journal", "--since", "0")["entries"]), 3)
        table = os.path.join(self.folder.name, "journal.csv")
        self.run_text("journal", "--export", table)
        with open(table, encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["serial"] for row in rows], [unit["serial"] for unit in units])
        self.assertEqual([row["number"] for row in rows], ["20", "21", "22"])
        self.assertTrue(all(row["settle"] and row["image_hash"] for row in rows))
        self.assertIn(serial, self.run_text("journal"))

    def test_a_target_that_no_unit_can_have_is_told_with_its_line_before_anything_is_written(self):
        for loop, to in (("velocity", 1e12), ("current", 1e9), ("position", 1e7)):
            recipe = self.recipe(firmware={"file": "dmc60c-demo.hex"}, test={"loop": loop, "to": to})
            with open(recipe, encoding="utf-8") as file:
                line = 1 + [number for number, text in enumerate(file) if '"to"' in text][0]
            self.assert_error(2, "service", recipe, "sim:can", says=f"line {line}: {loop}")

    def test_what_fails_has_cause_and_status(self):
        strict = dict(TEST, accept={"settle": 0.001})
        run = Run(["--json", "service", self.recipe(number={"first": 20}, test=strict), "sim:can"])
        self.assertEqual(run.status, 1, run.err)
        lines = run.objects()
        results = {line["device"]: line for line in lines[:-1]}
        self.assertEqual(results["sim:can/dmc60c:5"]["result"], "failed")
        self.assertRegex(results["sim:can/dmc60c:5"]["evidence"], r"settle is \d+(\.\d+)? ms, limit 1 ms; .*; preflight: ")
        self.assertEqual(results["sim:can/dmc60c:5"]["step"], "self-test")
        self.assertEqual(results["sim:can/dmc60c:9"]["result"], "refused") # in its bootloader, and no firmware in the recipe
        self.assertEqual((lines[-1]["summary"]["failed"], lines[-1]["summary"]["refused"]), (2, 1))
        last = [line for line in run.err.splitlines() if line.startswith("{")][-1]
        self.assertEqual(set(json.loads(last)["error"]), {"status", "fault", "cause", "remedy"})

    def test_a_served_unit_has_a_card_of_one_page_and_a_label(self):
        self.assert_error(2, "report", "trial:1", "--out", "a.html", "--size", "poster", says="report, card and label")
        self.assert_error(2, "report", "sim:can/dmc60c:7", "--out", self.folder.name + "/a.html", "--size", "label", says="was never served")
        self.run_json("service", self.recipe(parameters={"file": "base.json"}, test=TEST), "sim:can", status=1) # one is in its bootloader
        self.run_json("service", self.recipe(parameters={"file": "base.json"}), "sim:can", status=1)
        device = "sim:can/dmc60c:7"
        for size, width, height in (("card", 210, 297), ("label", 62, 29)):
            with self.subTest(size):
                page, paper = (os.path.join(self.folder.name, size + kind) for kind in (".html", ".pdf"))
                for file in (page, paper):
                    run = Run(["report", device, "--out", file, "--size", size])
                    self.assertEqual(run.status, 0, run.err)
                with open(page, encoding="utf-8") as file:
                    text = file.read()
                for part in ("PASS", "1.2"):
                    self.assertIn(part, text)
                if size == "card":
                    self.assertIn("<svg", text)
                    self.assertIn("Settling", text)
                with open(paper, "rb") as file:
                    pdf = file.read()
                self.assertEqual(pdf.count(b"/Type /Page\n"), 1)
                box = re.search(rb"/MediaBox \[0 0 ([0-9.]+) ([0-9.]+)\]", pdf)
                self.assertAlmostEqual(float(box[1]) / 72 * 25.4, width, delta=0.5)
                self.assertAlmostEqual(float(box[2]) / 72 * 25.4, height, delta=0.5)

    def test_mistakes_are_told_before_anything_is_sent(self):
        self.assert_error(2, "service", "nowhere.json", "sim:can", says="nowhere.json")
        bad = self.write("bad.json", '{"recipe": 1,\n"name": "n",\n"family": "dmc60c",\n"frimware": {}}')
        self.assert_error(2, "service", bad, "sim:can", says="line 4: unknown key 'frimware'")
        good = self.recipe()
        self.assert_error(2, "service", good, "sim:serial")
        self.assert_error(2, "service", good, "sim:can", "--units", "0", says="--units")
        self.assert_error(2, "service", good, "sim:can", "--journal", "mysql://a@b/c", says="postgresql://")
        self.assert_error(2, "service", self.recipe(firmware={"file": "none.hex"}), "sim:can", says="none.hex")
        self.assert_error(2, "service", self.recipe(number={"first": 64}), "sim:can", says="line ")
        self.assert_error(2, "journal", "--since", "yesterday", says="--since")
        self.assert_error(2, "journal", "--export", "journal.txt", says=".csv")

    @contract.long
    def test_resume_goes_on_where_it_was_killed(self):
        recipe = self.recipe(firmware={"file": "dmc60c-demo.hex"}, number={"first": 20})
        first = subprocess.Popen([contract.PROGRAM, "--json", "service", recipe, "sim:can"], stdout=subprocess.PIPE,
                                 stderr=subprocess.DEVNULL, text=True)
        done = json.loads(first.stdout.readline()) # one unit has ended
        first.send_signal(signal.SIGKILL)
        first.wait()
        first.stdout.close()
        self.assertEqual(done["result"], "passed")
        run = Run(["--json", "service", recipe, "sim:can", "--resume"])
        lines = run.objects()
        self.assertEqual(run.status, 0, run.err)
        self.assertEqual(lines[-1]["summary"]["passed"], 3)
        self.assertNotIn(done["serial"], [unit["serial"] for unit in lines[:-1]])
        entries = self.run_one("journal")["entries"]
        self.assertEqual(len(entries), 3)
        self.assertEqual(len({entry["device"] for entry in entries}), 3)

    def test_resume_of_a_recipe_that_was_edited_is_refused_and_writes_nothing(self):
        self.run_json("service", self.recipe(parameters={"file": "base.json"}), "sim:can", status=1) # one is in its bootloader
        edited = self.recipe(parameters={"file": "base.json", "store": True})
        self.assert_error(2, "service", edited, "sim:can", "--resume", says="without --resume")
        self.assertEqual(len(self.run_one("journal")["entries"]), 3)

    def test_an_interrupt_ends_it_and_says_how_to_go_on(self):
        recipe = self.recipe(firmware={"file": "dmc60c-demo.hex"})
        status, out, err = self.cut(1.5, "--json", "service", recipe, "sim:can")
        self.assertEqual(status, 1, err)
        self.assertIn("summary", out.splitlines()[-1])
        self.assertIn("--resume", err)


AVRDUDE = """#!/bin/sh
bar() { printf "$1 | " >&2; i=0; while [ $i -lt 50 ]; do printf '#' >&2; i=$((i+1)); done; printf ' | 100%% 0.01s\\n' >&2; }
echo "avrdude: AVR device initialized and ready to accept instructions" >&2
bar Reading
bar Writing
echo "avrdude: 6 bytes of flash written" >&2
bar Reading
echo "avrdude: 6 bytes of flash verified" >&2
echo "avrdude done.  Thank you." >&2
"""
OPENOCD = """#!/bin/sh
echo "Open On-Chip Debugger 0.12.0
[stm32f1x.cpu] halted due to debug-request, current mode: Thread
** Programming Started **
** Programming Finished **
** Verify Started **
** Verified OK **
** Resetting Target **
shutdown command invoked" >&2
"""


class Families(Recipes):
    """Each family with the way in that it has; programs of others are stood in for."""

    def stand_in(self, name, script):
        folder = os.path.join(self.folder.name, "bin")
        os.makedirs(folder, exist_ok=True)
        path = os.path.join(folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(script)
        os.chmod(path, 0o755)
        return {**os.environ, "PATH": folder + ":" + os.environ["PATH"]}

    def simulate(self, *arguments):
        process = subprocess.Popen([contract.PROGRAM, "simulate", *arguments], stdout=subprocess.PIPE, text=True)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait, contract.LIMIT)
        self.addCleanup(process.terminate)
        self.assertTrue(json.loads(process.stdout.readline())["ready"])
        return process

    def passed(self, run, count):
        self.assertEqual(run.status, 0, run.err)
        lines = run.objects()
        self.assertEqual(lines[-1]["summary"]["passed"], count, run.out)
        for unit in lines[:-1]:
            self.assertEqual((unit["result"], unit["step"], unit["serial"]), ("passed", "done", None))
        return lines[:-1]

    def test_without_a_server_entries_wait_here_but_those_of_simulated_units(self):
        server = ("--journal", "postgresql://nobody@%2Fnowhere/none")
        run = Run(["--json", "service", self.recipe(), "sim:can", *server])
        self.assertEqual(run.status, 1, run.err) # the unit in its bootloader is refused
        self.assertEqual(run.objects()[-1]["summary"]["passed"], 2)
        self.assertNotIn("wait on this computer", run.err)
        socket = os.path.join(self.folder.name, "board")
        self.simulate("--on", "unix:" + socket, "quadquad2drv:0")
        run = Run(["--json", "service", self.recipe(family="quadquad2drv"), "unix:" + socket, *server])
        self.passed(run, 1)
        self.assertIn("1 entries wait on this computer", run.err)
        self.assertEqual(len(self.run_one("journal")["entries"]), 4)

    def test_three_supermodified_by_avrdude(self):
        environment = self.stand_in("avrdude", AVRDUDE)
        terminal = os.path.join(self.folder.name, "tty")
        self.simulate("--on", "pty:" + terminal, "supermodified:4", "supermodified:5,dialect=D2", "supermodified:6,dialect=D3")
        self.write("node.hex", ":060000000C942000FFCF6C\n:00000001FF\n")
        self.write("base.json", {"family": "supermodified", "parameters": {"gain.p": {"raw": 77}}})
        recipe = self.recipe(family="supermodified", firmware={"file": "node.hex", "via": "avrdude:arduino:/dev/null"},
                             parameters={"file": "base.json"})
        run = Run(["--json", "service", recipe, f"serial:{terminal}?baud=57600"], environment=environment)
        units = self.passed(run, 3)
        self.assertEqual([unit["parameters"] for unit in units], [1, 1, 1])
        self.assertEqual(len(self.run_one("journal")["entries"]), 3)

    def test_three_abstract_dc_by_openocd(self):
        environment = self.stand_in("openocd", OPENOCD)
        self.write("drive.hex", ":020000040800F2\n:0C0000000050002009000008FEE700BFCF\n:00000001FF\n")
        self.write("base.json", {"family": "abstractdc", "parameters": {"velocity.p": {"raw": 77}}})
        recipe = self.recipe(family="abstractdc", firmware={"file": "drive.hex", "via": "openocd:stlink?target=f1"},
                             parameters={"file": "base.json", "store": True})
        units = self.passed(Run(["--json", "service", recipe, "sim:can"], environment=environment), 3)
        self.assertEqual([unit["device"] for unit in units], [f"sim:can/abstractdc:{n}" for n in (3, 4, 5)])

    def test_three_boards_by_their_bootloader(self):
        socket, boot = (os.path.join(self.folder.name, name) for name in ("board", "boot"))
        with open(os.path.join(contract.SOURCE, "resources/firmware/dmc60c-demo.hex"), encoding="ascii") as whole:
            lines = whole.read().splitlines()
        self.write("board.hex", "\n".join(lines[:12] + [":00000001FF"]) + "\n")
        recipe = self.recipe(family="quadquad2drv", firmware={"file": "board.hex", "via": "serial:" + boot})
        for number in range(1, 4): # one after the other, by the same hand
            board = self.simulate("--on", "unix:" + socket, f"quadquad2drv:0,boot=pty:{boot},jumper=closed")
            unit = self.passed(Run(["--json", "service", recipe, "unix:" + socket]), 1)[0]
            self.assertEqual((unit["from"], unit["to"]), ("1.3", "1.4"))
            board.terminate()
            board.wait(contract.LIMIT)
            self.assertEqual(len(self.run_one("journal")["entries"]), number)


if __name__ == "__main__":
    contract.PROGRAM, contract.SOURCE = sys.argv[1:3]
    contract.LIMIT = 400  # a unit takes as long as its flash does
    sys.exit(contract.main(sys.argv[3:]))
