#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""fifty_units.py PROGRAM SOURCE [units=50] [kills=0] [window=DRIVER] [link=LINK] [test=no]: simulated DMC60C, put on one after the other as a
person would, a quarter of them with trouble, served by one command, by the window, or by a command that is killed at random moments and
resumed. Afterwards the counts are as expected, every unit that can answer was reached, and the journal has all of it.
Every unit is a process of its own on a CAN bus of Qt's virtualcan (no kernel is needed), or on link=socketcan:vcan0. Self-tests need a
computer that serves every process within 100 ms, because an experiment ends when its unit was not heard for so long (scripts/soak sees to that
where it may); test=no leaves them out."""
import json
import os
import queue
import random
import shutil
import signal
import sqlite3
import statistics
import subprocess
import sys
import tempfile
import threading
import time

# What is wrong with the unit at a place of fifty, and what becomes of it.
TROUBLE = {
    3: ("power-page", "power cut while a page of firmware is written", "passed"),
    7: (",product=601", "another product", "refused"),
    11: (",fault=encoder-dead@0", "dead encoder", "failed"),
    15: (",fault=encoder-reversed", "encoder counts backwards", "failed"),
    19: (",motor=n20,load=5", "self-test out of limits", "failed"),
    23: (",state=bootloader", "waits in its bootloader", "passed"),
    27: (",session=28673", "same number as the next", "refused"),
    28: (",session=28674", "same number as the one before", "refused"),
    31: (",fault=drop@40,fault=drop@90,fault=corrupt@140", "frames lost and damaged", "passed"),
    35: (",fault=silent@600", "falls silent", "failed"),
    39: (",fault=stall@0", "shaft is blocked", "failed"),
    43: (",fault=delay@60:120", "answers late", "passed"),
}
RECIPE = {
    "recipe": 1, "name": "fifty", "family": "dmc60c", "firmware": {"file": "dmc60c-demo.hex"}, "parameters": {"file": "base.json"},
    "number": {"first": 10},
    "test": {"loop": "velocity", "to": 8000, "time": 0.8, "limits": {"travel": 400000, "speed": 40000, "duty": 0.9, "current": 60},
             "accept": {"settle": 0.9, "sse": 0.05, "friction": [0.01, 1.2], "resistance": [0.02, 0.5], "encoder": True}},
}
MOTION = (11, 15, 19, 39)  # places whose trouble only a self-test finds
PATIENCE = 180  # seconds for one unit
BUS = "qtcan:virtualcan:can0"


class Unit:
    """One unit of the rack: switched on it is a process."""

    def __init__(self, place, moments, tested):
        self.place = place
        self.serial = f"2103340{place:05d}"
        trouble, self.story, self.expected = TROUBLE.get(place, ("", "", "passed"))
        if not tested and place in MOTION:
            self.expected = "passed"
        if trouble == "power-page":
            trouble = f",fault=power-page@{moments.randrange(1, 30)}"
        self.text = f"dmc60c:5,serial={self.serial},firmware=1.23{trouble}"
        self.process = None
        self.reached = False

    def put_on(self, program, link):
        self.process = subprocess.Popen([program, "simulate", "--on", link, self.text], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        assert json.loads(self.process.stdout.readline())["ready"]

    def take_off(self):
        if self.process:
            self.process.terminate()
            self.process.wait()
            self.process.stdout.close()
            self.process = None


class Bench:
    def __init__(self, program, source, options):
        self.program = program
        self.link = options.get("link", BUS)
        self.count = int(options.get("units", 50))
        self.window = options.get("window")
        self.kills = int(options.get("kills", 0))
        self.tested = options.get("test", "yes") != "no"
        self.seed = int.from_bytes(os.urandom(4), "big")
        self.moments = random.Random(self.seed)
        self.units = [Unit(place, self.moments, self.tested) for place in range(self.count)]
        self.folder = tempfile.mkdtemp()
        self.killed = 0
        self.ended = queue.Queue()
        os.environ["XDG_DATA_HOME"] = os.path.join(self.folder, "data")
        shutil.copy(os.path.join(source, "resources/firmware/dmc60c-demo.hex"), self.folder)
        self.write("recipe.json", RECIPE if self.tested else {key: part for key, part in RECIPE.items() if key != "test"})
        self.write("base.json", {"family": "dmc60c", "parameters": {"slot1.d": {"raw": 77}, "current_limit.peak_duration": {"raw": 120}}})
        self.bus = None
        if self.link == BUS:  # whoever opens it first is the bus, and that one stays
            self.bus = subprocess.Popen([program, "monitor", BUS], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            time.sleep(0.5)
        self.service = None

    def write(self, name, content):
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
            json.dump(content, file)

    def begin(self):
        recipe = os.path.join(self.folder, "recipe.json")
        command = [self.program, "--json", "--quiet", "service", recipe, self.link, "--units", str(self.count), "--resume"]
        if self.window:
            command = [self.window, self.link, "serve", recipe, str(self.count)]
        self.errors = open(os.path.join(self.folder, "errors"), "a", encoding="utf-8")
        self.service = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=self.errors, text=True)
        self.hurry()
        threading.Thread(target=self.listen, args=(self.service,), daemon=True).start()

    def hurry(self):
        """Threads of a window choose how urgent they are: where this is run before others, all of them are, too."""
        if not self.window or os.sched_getscheduler(0) != os.SCHED_RR:
            return
        time.sleep(1)
        for thread in os.listdir(f"/proc/{self.service.pid}/task"):
            os.sched_setscheduler(int(thread), os.SCHED_RR, os.sched_param(20))

    def listen(self, service):
        for line in service.stdout:
            if line.startswith("{"):
                self.ended.put(json.loads(line))
        self.ended.put(None)

    def entries(self):
        told = subprocess.run([self.program, "--json", "journal"], capture_output=True, text=True, check=True)
        return json.loads(told.stdout)["entries"]

    def has_ended(self, unit):
        return any(entry["serial"] == unit.serial and entry["result"] != "open" for entry in self.entries())

    def kill(self):
        self.service.send_signal(signal.SIGKILL)
        self.service.wait()
        self.killed += 1
        time.sleep(0.3)
        while self.ended.get() is not None:  # to the end of its output
            pass
        self.begin()

    def wait_for(self, turn):
        """Until every unit of a turn has ended. Kills come at random moments of it, spread over the turns that are left."""
        limit = time.monotonic() + PATIENCE * len(turn)
        left = [unit for unit in turn]
        while left:
            assert time.monotonic() < limit, f"unit {left[0].serial} does not end"
            due = self.killed < self.kills and self.moments.random() < (self.kills - self.killed) / max(1, self.count - turn[0].place)
            try:
                line = self.ended.get(timeout=self.moments.uniform(0.2, 9.0) if due else PATIENCE)
            except queue.Empty:
                if due:
                    self.kill()
                    left = [unit for unit in left if not self.has_ended(unit)]
                continue
            assert line is not None, "the service has ended"
            left = [unit for unit in left if unit.serial != line.get("serial")]

    def reach(self, turn):
        told = subprocess.run([self.program, "--json", "scan", self.link], capture_output=True, text=True, check=True)
        rows = json.loads(told.stdout)["devices"]
        for unit in turn:
            unit.reached = any(row["serial"] == unit.serial for row in rows)

    def turns(self):
        turns = []
        for unit in self.units:
            if unit.place == 28:
                turns[-1].append(unit)  # put on together with the one before
            else:
                turns.append([unit])
        return turns

    def run(self):
        begun = time.monotonic()
        self.begin()
        try:
            for turn in self.turns():
                time.sleep(0.5)  # hands
                for unit in turn:
                    unit.put_on(self.program, self.link)
                self.wait_for(turn)
                self.reach(turn)
                for unit in turn:
                    unit.take_off()
                print(f"{time.monotonic() - begun:7.1f} s  {turn[-1].serial}  {', '.join(unit.story or 'good' for unit in turn)}", flush=True)
            self.service.wait(30)
        finally:
            for unit in self.units:
                unit.take_off()
            for process in (self.service, self.bus):
                if process and process.poll() is None:
                    process.kill()
                    process.wait()
        return self.judge(time.monotonic() - begun)

    def steps(self):
        """Of each visit the steps that begin and end, in their order: (step, time, whether it is the end)."""
        database = sqlite3.connect(os.path.join(os.environ["XDG_DATA_HOME"], "motorbench", "motorbench.db"))
        steps = {}
        for serial, step, at, ended in database.execute(
                "SELECT serial, service_step.step, service_step.time, ended FROM service_step JOIN service_visit ON id = visit ORDER BY visit, place"):
            steps.setdefault(serial, []).append((step, at, ended))
        numbers = [row[0] for row in database.execute("SELECT number FROM service_visit WHERE number IS NOT NULL")]
        database.close()
        return steps, numbers

    def judge(self, seconds):
        entries = {entry["serial"]: entry for entry in self.entries()}
        steps, numbers = self.steps()
        wrong = []
        updates, rests = [], []
        for unit in self.units:
            entry = entries.get(unit.serial)
            result = entry["result"] if entry else "missing"
            if result != unit.expected:
                wrong.append(f"{unit.serial}: {result}, not {unit.expected}: {entry and entry['evidence']}")
            if not unit.reached and unit.place != 35:
                wrong.append(f"{unit.serial} does not answer any more")
            mine = steps.get(unit.serial, [])
            if not mine or not mine[-1][2]:
                wrong.append(f"{unit.serial}: the journal does not tell its end")
            if result == "passed" and [step for step, _, end in mine if end][-3:] != ["number", "proof", "done"]:
                wrong.append(f"{unit.serial}: steps {mine}")
            if result == "passed" and not unit.story and self.killed == 0:
                begin = next(at for step, at, end in mine if step == "firmware" and not end)
                end = next(at for step, at, ended in mine if step == "firmware" and ended)
                updates.append(end - begin)
                rests.append(entry["seconds"] - (end - begin))
        if len(entries) != self.count or len(self.entries()) != self.count:
            wrong.append(f"{len(self.entries())} entries for {self.count} units")
        if len(set(numbers)) != len(numbers):
            wrong.append("a number was given twice")
        print(self.table(entries, numbers, seconds, updates, rests))
        print("\n".join(wrong))
        if wrong:
            with open(os.path.join(self.folder, "errors"), encoding="utf-8") as errors:
                print(errors.read())
        shutil.rmtree(self.folder)
        return 1 if wrong else 0

    def table(self, entries, numbers, seconds, updates, rests):
        results = [entry["result"] for entry in entries.values()]
        by = "the window" if self.window else "one command"
        lines = [f"seed {self.seed}", "", "| | |", "|---|---|",
                 f"| served by | {by}{f', killed {self.killed} times' if self.killed else ''} |",
                 f"| recipe | firmware of 31 pages, 2 parameters{', self-test' if self.tested else ''}, number, proof |",
                 f"| units | {self.count}, {sum(bool(unit.story) for unit in self.units)} of them with trouble |",
                 f"| passed, failed, refused | {', '.join(str(results.count(word)) for word in ('passed', 'failed', 'refused'))} |",
                 f"| reachable afterwards | {sum(unit.reached for unit in self.units)} |",
                 f"| numbers given, twice | {len(numbers)}, {len(numbers) - len(set(numbers))} |",
                 f"| whole time | {seconds:.0f} s |"]
        if updates:
            lines.append(f"| a good unit: update | median {statistics.median(updates):.1f} s, at most {max(updates):.1f} s |")
            lines.append(f"| a good unit: all the rest | median {statistics.median(rests):.1f} s, at most {max(rests):.1f} s (to reach: 25 s) |")
        return "\n".join(lines)


def main():
    program, source = sys.argv[1:3]
    return Bench(program, source, dict(word.split("=", 1) for word in sys.argv[3:])).run()


if __name__ == "__main__":
    sys.exit(main())
