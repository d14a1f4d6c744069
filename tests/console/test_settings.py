# SPDX-License-Identifier: GPL-3.0-or-later
"""test_settings.py PROGRAM: snapshots, differences and what restores them, on the simulated bench and, across runs, on a simulated line."""
import contextlib
import json
import os
import resource
import signal
import sqlite3
import subprocess
import sys
import tempfile

import contract
from contract import CIM, ContractTest, Run

LIVELY = "sim:can/dmc60c:7"
SNAPSHOT = {"snapshot", "device", "serial", "name", "time", "count"}
DIFFERENCE = {"key", "a", "b", "unit", "belongs_to_unit"}


class Snapshots(ContractTest):
    def test_one_is_taken_named_and_listed_by_its_unit(self):
        taken = self.run_one("snapshot", CIM, "--name", "limits for the demo")
        self.assertEqual(set(taken), SNAPSHOT)
        self.assertEqual((taken["device"], taken["name"], taken["count"]), (CIM, "limits for the demo", 55))
        self.assertTrue(taken["serial"])
        rows = self.run_one("snapshots", CIM)["snapshots"]
        self.assertIn(taken, rows)
        self.assertEqual(set(rows[0]), SNAPSHOT)
        self.assertNotIn(taken, self.run_one("snapshots", LIVELY)["snapshots"])
        self.assertIn("limits for the demo", self.run_text("snapshots"))
        self.assertIn(taken, self.run_one("snapshots", "sim:can?bitrate=1000000/dmc60c:5")["snapshots"])
        self.run_one("number", CIM, "10")  # of a bench that ends with it; the unit is remembered
        self.assertIn(taken, self.run_one("snapshots", "sim:can/dmc60c:10")["snapshots"])
        self.assertIn("none is kept of what was seen at sim:can/dmc60c:60", self.run_text("snapshots", "sim:can/dmc60c:60"))

    def test_no_name_moves_the_cursor_of_a_terminal(self):
        for name in ("a\nb", "a\x1b[31m", "a\x7f", "a\x9bK", "a\tb"):
            self.assert_error(2, "snapshot", CIM, "--name", name, says="control character")
            self.assert_error(2, "trials", "--note", "2", name, says="control character")
        for name in ("1", "007", "-3"):
            self.assert_error(2, "snapshot", CIM, "--name", name, says="number of a snapshot")
        self.run_one("snapshot", CIM, "--name", "limits")
        with contextlib.closing(sqlite3.connect(os.path.join(os.environ["XDG_DATA_HOME"], "motorbench", "motorbench.db"))) as book:
            book.execute("UPDATE snapshot SET name = ?", ("evil\n\x1b[31m\x9bK°",))  # of an earlier version
            book.commit()
        listed = self.run_text("snapshots")
        self.assertEqual(listed.count("\n"), 2)
        self.assertIn("evil??[31m?K°", listed)
        self.assertEqual(self.run_one("snapshots")["snapshots"][0]["name"], "evil\n\x1b[31m\x9bK°")

    def test_a_unit_without_a_serial_number_is_this_place(self):
        taken = self.run_one("snapshot", "sim:serial/supermodified:4")
        self.assertIsNone(taken["serial"])
        self.assertEqual(taken["name"], "by hand")
        self.assertIn("this place, not this unit", self.run_text("snapshots"))

    def test_a_unit_in_its_bootloader_has_nothing_to_keep(self):
        run = Run(["snapshot", contract.EMPTY])
        self.assertEqual((run.status, run.out), (1, ""), run.err)


class Saving(ContractTest):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def saved(self, device, **values):
        path = os.path.join(self.folder.name, "saved.json")
        self.run_text("get", device, "--file", path)
        with open(path, encoding="utf-8") as file:
            text = json.load(file)
        for key, value in values.items():
            text["parameters"][key.replace("__", ".")].update(value=value, raw=None)
        with open(path, "w", encoding="utf-8") as file:
            json.dump(text, file)
        return path


class Backup(Saving):
    @contract.long
    def test_what_cannot_be_kept_is_not_overwritten(self):
        path = self.saved(CIM, slot0__p=0.5)
        firmware = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "resources", "firmware", "dmc60c-demo.hex")
        self.run_one("snapshot", CIM)
        nowhere = dict(os.environ, XDG_DATA_HOME=path)

        def full():
            resource.setrlimit(resource.RLIMIT_FSIZE, (8192, 8192))

        for words in (["restore", CIM, path], ["flash", CIM, firmware]):
            for environment, limit in ((nowhere, None), (None, full)):
                done = subprocess.run([contract.PROGRAM, "--json", *words], capture_output=True, text=True, check=False, env=environment, preexec_fn=limit)
                self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
                self.assertIn("nothing was written", json.loads(done.stderr.splitlines()[-1])["error"]["cause"])
        run = Run(["flash", contract.EMPTY, firmware], environment=nowhere)
        self.assertEqual(run.status, 0, run.err + ": a unit in its bootloader has nothing to keep")


class FullDisk(Saving):
    """What cannot be written on this computer: docs/names.md#exit-statuses."""

    def ended(self, words, **how):
        done = subprocess.run([contract.PROGRAM, "--json", *words], capture_output=True, text=True, check=False, **how)
        return done.returncode, done.stdout

    def test_a_file_that_fails_is_1_whether_or_not_a_unit_was_asked(self):
        step = ["step", CIM, "--mode", "velocity", "--to", "2000", "--time", "0.3"]
        self.run_one(*step)
        trace = os.path.join(self.folder.name, "trace.csv")
        with open(trace, "w", encoding="utf-8") as file:
            file.write(self.run_text("watch", CIM, "--for", "0.2"))
        trial = self.run_one("trials")["trials"][-1]["trial"]
        for words, kind in ((["get", CIM, "--file"], "json"), (step + ["--save"], "json"), (["trials", "--export"], "json"), (["journal", "--export"], "csv"),
                            (["report", CIM, "--out"], "html"), (["report", f"trial:{trial}", "--out"], "html"), (["report", f"trial:{trial}", "--out"], "pdf"), (["plot", trace, "--out"], "png")):
            full = os.path.join(self.folder.name, "full." + kind)
            if not os.path.islink(full):
                os.symlink("/dev/full", full)
            self.assertEqual(self.ended([*words, full])[0], 1, words)
            self.assertEqual(self.ended([*words, "/nonexistent/x." + kind])[0], 2, words)

    def test_a_notebook_that_cannot_be_opened_is_2_and_one_that_fails_is_1(self):
        nowhere = dict(os.environ, XDG_DATA_HOME=self.saved(CIM))
        self.run_one("snapshot", CIM)
        step = ["step", CIM, "--mode", "velocity", "--to", "2000", "--time", "0.3", "--set", "slot0.p=0.2"]
        out = ["--out", os.path.join(self.folder.name, "x.html")]
        for words in (["snapshot", CIM], ["snapshots"], ["trials"], ["journal"], ["report", CIM, *out], ["rename", "sim:can/abstractdc:3", "x"], step, ["tune", CIM, "--loop", "velocity"]):
            self.assertEqual(self.ended(words, env=nowhere), (2, ""), words)

        filling = dict(os.environ, XDG_DATA_HOME=self.folder.name)
        self.assertEqual(self.ended(["trials"], env=filling)[0], 0)
        with contextlib.closing(sqlite3.connect(os.path.join(self.folder.name, "motorbench", "motorbench.db"))) as notebook, notebook:
            for table in ("snapshot", "trial"):  # it is opened, and no row finds room
                notebook.execute(f"CREATE TRIGGER full_{table} BEFORE INSERT ON {table} BEGIN SELECT RAISE(ABORT, 'database or disk is full'); END")
        self.assertEqual(self.ended(["snapshot", CIM], env=filling), (1, ""))
        self.assertEqual(self.ended(step, env=filling), (2, ""), "refused, because nothing could be put back")


class Diff(Saving):
    def differences(self, a, b):
        rows = self.run_one("diff", a, b, status=1)["differences"]
        for row in rows:
            self.assertEqual(set(row), DIFFERENCE)
        return {row["key"]: row for row in rows}

    def test_a_device_is_like_its_own_snapshot_and_file(self):
        taken = self.run_one("snapshot", CIM, "--name", "mine")
        for other in (CIM, "snapshot:mine", f"snapshot:{taken['snapshot']}", self.saved(CIM)):
            self.assertEqual(self.run_one("diff", CIM, other), {"differences": []})

    def test_what_differs_is_listed_with_both_values(self):
        rows = self.differences(CIM, self.saved(CIM, slot0__p=0.5, current_limit__enabled=True))
        self.assertEqual(set(rows), {"slot0.p", "current_limit.enabled"})
        self.assertEqual(rows["slot0.p"]["b"], 0.5)
        self.assertEqual((rows["current_limit.enabled"]["a"], rows["current_limit.enabled"]["b"]), (False, True))

    def test_defaults_and_another_device_are_sides_too(self):
        self.assertEqual(self.differences("defaults", CIM)["slot0.p"]["a"], 0)
        self.assertIn("slot0.p", self.differences(CIM, LIVELY))

    def test_what_belongs_to_one_unit_is_marked(self):
        rows = self.differences("sim:serial/supermodified:4", "sim:serial/supermodified:5")
        self.assertTrue(rows["node.id"]["belongs_to_unit"])
        rows = self.differences(CIM, self.saved(CIM, current__adc_multiplier=0.03))
        self.assertTrue(rows["current.adc_multiplier"]["belongs_to_unit"])

    def test_wrong_words_are_refused(self):
        self.assert_error(2, "diff", "defaults", "defaults")
        self.assert_error(2, "diff", CIM, "snapshot:never taken", says="never taken")
        self.assert_error(2, "diff", "snapshot:", CIM)
        self.assert_error(2, "diff", CIM, "/no/such/file.json")
        self.assert_error(2, "diff", CIM, "sim:serial/supermodified:4", says="different parameters")


class Restore(Saving):
    def test_a_snapshot_is_taken_before_values_are_written(self):
        run = Run(["--json", "restore", CIM, self.saved(CIM, slot0__p=0.5)])
        self.assertEqual(run.status, 0, run.err)
        self.assertEqual([row["result"] for row in run.objects()[0]["changes"]], ["written"])
        self.assertIn("before restore", run.err)
        self.assertEqual(self.run_one("snapshots", CIM)["snapshots"][-1]["name"], "before restore")

    def test_the_history_has_what_set_and_restore_wrote(self):
        self.run_one("set", CIM, "slot1.p=0.25")
        self.run_one("restore", CIM, self.saved(CIM, slot1__d=0.5))
        database = sqlite3.connect(os.path.join(os.environ["XDG_DATA_HOME"], "motorbench", "motorbench.db"))
        self.addCleanup(database.close)
        rows = database.execute("SELECT origin, purpose, key, before IS NOT NULL, after, proof FROM change, changed_value "
                                "WHERE change = id ORDER BY id DESC LIMIT 2").fetchall()
        self.assertEqual(rows, [("console", "restore", "slot1.d", 1, 32768, "equal"), ("console", "write", "slot1.p", 1, 16384, "equal")])

    def test_one_that_is_interrupted_says_how_far_it_came(self):
        path = self.saved(CIM, **{f"slot{slot}__{gain}": 0.25 for slot in (0, 1) for gain in "pidf"})
        said = ""
        for attempt in range(60):  # between two of eight writes, whenever that is
            with subprocess.Popen([contract.PROGRAM, "restore", CIM, path], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as run:
                self.assertIn("before restore", run.stderr.readline())
                with contextlib.suppress(subprocess.TimeoutExpired):
                    run.wait(timeout=0.01 * (attempt % 20))
                run.send_signal(signal.SIGINT)
                said = run.stderr.read()
            if "interrupted" in said and "values are written" in said:
                break
        self.assertRegex(said, r"\d of 8 values are written, and the next one may be; 'motorbenchctl get' reads what is in force")

    def test_a_place_is_put_back_only_by_who_says_so(self):
        place = "sim:serial/supermodified:4"
        number = self.run_one("snapshot", place)["snapshot"]
        self.assert_error(2, "restore", place, f"snapshot:{number}", says="this place, not this unit")
        self.assertEqual(self.run_one("restore", place, f"snapshot:{number}", "--yes"), {"changes": []})
        self.assert_error(2, "restore", CIM, self.saved(CIM), "--yes", says="--yes means a snapshot")

    def test_values_of_one_unit_are_asked_for_one_by_one(self):
        path = self.saved(LIVELY, current__adc_multiplier=0.03)
        keys = lambda *more: [row["key"] for row in self.run_one("restore", CIM, path, "--dry-run", *more)["changes"]]
        self.assertNotIn("current.adc_multiplier", keys())
        self.assertIn("current.adc_multiplier", keys("--unit-values", "current.adc_multiplier"))
        self.assert_error(2, "restore", CIM, path, "--unit-values", "no.such.key")


class Tags(ContractTest):
    def test_a_unit_that_stores_no_name_is_called_so_on_this_computer(self):
        place = "sim:serial/supermodified:5"
        self.assertEqual(self.run_one("rename", place, "left arm"), {"device": place, "old": None, "new": "left arm", "verified": True})
        number = self.run_one("snapshot", place)["snapshot"]
        self.assertIn("left arm", self.run_text("snapshots", place))
        self.run_one("rename", "sim:serial/supermodified:4", "left arm")  # it was moved there
        self.assertIn("left arm", self.run_text("snapshots", "sim:serial/supermodified:4"))
        self.assertIsNone(self.run_one("info", place)["name"])  # of two on one line it is one only
        self.assertIn("number 4 of this line was called so", Run(["rename", place, "left arm"]).err)
        self.run_one("rename", "sim:serial/supermodified:4", "another")
        self.assertEqual(self.run_one("restore", place, f"snapshot:{number}"), {"changes": []})
        self.assertEqual(self.run_one("rename", place, "right arm")["old"], "left arm")
        self.assertEqual(self.run_one("info", place)["name"], "right arm")
        self.assertIn("right arm", self.run_text("info", place))
        rows = {row["device"]: row["name"] for row in self.run_one("scan", "sim:serial", "sim:can")["devices"]}
        self.assertEqual((rows[place], rows["sim:serial/supermodified:4"], rows[CIM]), ("right arm", "another", "DMC60C"))
        self.assertIn("right arm", self.run_text("scan", "sim:serial"))

    def test_a_name_has_64_characters_of_any_size_and_no_other_bytes(self):
        place = "sim:serial/supermodified:5"
        self.assertTrue(self.run_one("rename", place, 64 * "\N{SMALL ORANGE DIAMOND}")["verified"])
        self.assert_error(2, "rename", place, 65 * "x", says="this one has 65")
        self.assert_error(2, "rename", place, b"\xff\xfe", says="UTF-8")

    def test_no_notebook_is_begun_to_look_for_a_name(self):
        self.assertIsNone(self.run_one("info", "sim:serial/supermodified:5")["name"])
        self.assertFalse(os.path.exists(os.path.join(os.environ["XDG_DATA_HOME"], "motorbench", "motorbench.db")))


class Line(ContractTest):
    """One unit that keeps its state between runs."""

    def test_a_snapshot_brings_back_in_a_later_run_what_was_there(self):
        with tempfile.TemporaryDirectory() as folder:
            port = os.path.join(folder, "tty")
            bench = subprocess.Popen([contract.PROGRAM, "simulate", "--on", f"pty:{port}", "supermodified:4"],
                                     stdout=subprocess.PIPE, text=True)
            try:
                self.assertTrue(json.loads(bench.stdout.readline())["ready"])
                device = f"serial:{port}?baud=57600/supermodified:4"
                before = self.run_one("get", device, "gain.p")["parameters"]["gain.p"]["value"]
                self.run_one("snapshot", device, "--name", "as it was")
                self.run_one("set", device, f"gain.p={before + 5}")
                self.assertEqual([row["key"] for row in self.run_one("diff", device, "snapshot:as it was", status=1)["differences"]],
                                 ["gain.p"])
                changes = self.run_one("restore", device, "snapshot:as it was", "--yes")["changes"]
                self.assertEqual([(row["key"], row["to"], row["result"]) for row in changes], [("gain.p", before, "written")])
                self.assertEqual(self.run_one("diff", device, "snapshot:as it was"), {"differences": []})
            finally:
                bench.send_signal(signal.SIGINT)
                bench.wait(timeout=30)
                bench.stdout.close()


class Flash(ContractTest):
    """A DMC60C, which stores by itself 15 s after a write, on a bus of its own."""

    def setUp(self):
        self.bus = f"qtcan:virtualcan:tcp://127.0.0.1:{20000 + os.getpid() % 20000}/can0"
        bench = subprocess.Popen([contract.PROGRAM, "simulate", "--on", self.bus, "dmc60c:5"], stdout=subprocess.PIPE, text=True)
        self.addCleanup(bench.stdout.close)
        self.addCleanup(bench.wait, contract.LIMIT)
        self.addCleanup(bench.terminate)
        self.assertTrue(json.loads(bench.stdout.readline())["ready"])
        self.device = self.bus + "/dmc60c:5"

    def gain(self):
        row = self.run_one("get", self.device, "slot0.p")["parameters"]["slot0.p"]
        return row["value"], row["state"]

    @contract.long
    def test_what_an_earlier_call_wrote_is_in_ram_until_it_is_seen_stored(self):
        self.run_one("set", self.device, "slot0.p=0.41")
        self.run_one("set", self.device, "slot0.p=0.42")
        self.assertEqual((round(self.gain()[0], 3), self.gain()[1]), (0.42, "ram"))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.json")
            self.run_text("get", self.device, "--file", path)
            with open(path, encoding="utf-8") as file:
                states = {key: row["state"] for key, row in json.load(file)["parameters"].items()}
        self.assertEqual((states["slot0.p"], states["slot0.i"]), ("ram", "stored"))
        self.assertTrue(self.run_one("set", self.device, "slot0.p=0.42", "--store")["verified"])
        self.assertEqual(self.gain()[1], "stored")

    @contract.long
    def test_what_a_unit_has_after_its_restart_is_stored(self):
        self.run_one("set", self.device, "slot0.p=0.41")
        self.run_one("restart", self.device)
        self.assertEqual((round(self.gain()[0], 3), self.gain()[1]), (0.41, "stored"))


if __name__ == "__main__":
    contract.PROGRAM = sys.argv[1]
    sys.exit(contract.main(sys.argv[2:]))
