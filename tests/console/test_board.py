# SPDX-License-Identifier: GPL-3.0-or-later
"""A board on SPI in another process: QuadQuad2Drv over a socket, its bootloader over a pseudo terminal."""
import glob
import json
import os
import subprocess
import tempfile

import contract
from contract import ContractTest

FIRMWARE = "resources/firmware/dmc60c-demo.hex"  # any Intel HEX: the file names no board


class BoardTest(ContractTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.socket = os.path.join(folder.name, "board")
        self.boot = os.path.join(folder.name, "boot")
        self.device = f"unix:{self.socket}/quadquad2drv:0"

    def simulate(self, options=""):
        process = subprocess.Popen([contract.PROGRAM, "simulate", "--on", "unix:" + self.socket, "quadquad2drv:0" + options],
                                   stdout=subprocess.PIPE, text=True)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait, contract.LIMIT)
        self.addCleanup(process.terminate)
        second = ["pty:" + self.boot] if "boot=" in options else []  # every link that is served
        self.assertEqual(json.loads(process.stdout.readline()), {"ready": True, "links": ["unix:" + self.socket, *second]})
        return process

    def test_scan_names_the_board(self):
        self.simulate()
        rows = self.run_one("scan", "unix:" + self.socket)["devices"]
        self.assertEqual([(row["family"], row["address"], row["firmware"]) for row in rows], [("quadquad2drv", 0, "1.3")])

    def test_a_value_that_can_be_read_is_set_and_verified_and_a_gain_is_not(self):
        self.simulate()
        self.assertEqual(self.run_one("set", self.device, "history.length=8")["verified"], True)
        self.assertEqual(self.run_one("get", self.device, "history.length")["parameters"]["history.length"]["value"], 8)
        mixed = self.run_one("set", self.device, "history.length=9", "ch2.position.p=250")
        self.assertIsNone(mixed["verified"])
        self.assertEqual({key: row["verified"] for key, row in mixed["parameters"].items()}, {"history.length": True, "ch2.position.p": None})

    def test_every_axis_drives_and_stops(self):
        self.simulate()
        for axis in "1234":
            last = self.run_json("drive", self.device, "--mode", "duty", "--target", "0.3", "--axis", axis, "--for", "0.5")[-1]
            self.assertEqual((last["stopped"], last["reason"]), (True, "done"), axis)
            moved = [row for row in self.run_json("watch", self.device, "--channel", f"ch{axis}.position", "--for", "1")[:-1]]
            self.assertGreater(abs(moved[-1]["value"]), 10, axis)

    def test_a_reset_in_an_experiment_names_what_it_took_of_the_other_loops_too(self):
        self.simulate(",fault=reset@5")
        self.run_one("set", self.device, "ch1.position.p=250", "ch1.position.d=300")
        run = contract.Run(["--json", "step", self.device, "--mode", "duty", "--to", "0.2", "--time", "12", "--travel", "1000000", "--duty", "1"])
        self.assertIn(run.status, (4, 5), run.err)  # it is silent while it begins
        self.assertIn("was reset: 2 settings that were written to it are unknown; write them again with 'motorbenchctl restore", run.err)

    def test_watch_streams_up_to_500_times_a_second(self):
        self.simulate()
        rows = self.run_json("watch", self.device, "--channel", "ch1.position", "--rate", "500", "--for", "2")
        summary = rows[-1]["summary"]
        print(f"unix socket: {summary['samples'] / summary['seconds']:.0f} samples a second of 498 asked for, "
              f"{summary['lost']} lost; the wire of a real board would carry 1453")
        self.assertGreater(summary["samples"] + summary["lost"], 0.5 * 498 * summary["seconds"])

    def test_a_board_that_another_program_has_is_busy(self):
        self.simulate()
        with subprocess.Popen([contract.PROGRAM, "watch", self.device], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as watching:
            watching.stdout.readline()
            watching.stdout.readline()
            for options in ([], ["--timeout", "2"]):
                self.assert_error(5, *options, "get", self.device, "ch1.counter", says="is busy")
            self.assert_error(5, "scan", "unix:" + self.socket, says="is busy")
            watching.terminate()
        self.run_one("get", self.device, "ch1.counter")

    def test_a_board_that_goes_away_is_reported(self):
        process = self.simulate()
        with subprocess.Popen([contract.PROGRAM, "watch", self.device], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              text=True) as watching:
            watching.stdout.readline()
            watching.stdout.readline()
            process.kill()
            _, err = watching.communicate(timeout=contract.LIMIT)
        self.assertEqual(watching.returncode, 5, err)
        self.assertIn("closed the connection; start it again", err)

    def reset(self, process):
        """A simulator that starts anew is a board that was reset."""
        process.terminate()
        process.wait(contract.LIMIT)
        return self.simulate()

    def test_what_a_reset_took_is_told_and_written_again(self):
        board = self.simulate()
        self.run_one("set", self.device, "ch1.position.p=250", "ch1.limit.power=0.5", "history.length=8")
        rows = self.run_one("get", self.device)["parameters"]
        self.assertEqual((rows["ch1.position.p"]["value"], rows["ch1.position.p"]["state"]), (250, "assumed"))
        self.assertEqual(self.run_one("restore", self.device), {"changes": []})
        self.assertIn("has lost nothing that was written", self.run_text("restore", self.device))
        self.reset(board)
        run = contract.Run(["--json", "get", self.device])
        self.assertEqual(run.status, 0, run.err)
        self.assertIn("was reset: 3 settings that were written to it are unknown; write them again", run.err)
        row = run.objects()[0]["parameters"]["ch1.position.p"]
        self.assertEqual((row["value"], row["state"]), (None, "unknown"))
        change = {"key": "ch1.position.p", "from": None, "to": 250}
        shown = self.run_one("restore", self.device, "--dry-run")["changes"]
        self.assertEqual(len(shown), 3)
        self.assertIn(dict(change, result="would write"), shown)
        self.assertIn(dict(change, result="written"), self.run_one("restore", self.device)["changes"])
        rows = self.run_one("get", self.device)["parameters"]
        self.assertEqual((rows["ch1.position.p"]["value"], rows["history.length"]["value"]), (250, 8))
        self.assertNotIn("was reset", contract.Run(["--json", "get", self.device]).err)

    def test_a_reset_stays_known_when_the_board_was_driven_before_it_was_written_again(self):
        board = self.simulate()
        self.run_one("set", self.device, "ch1.position.p=250")
        self.reset(board)
        self.run_json("drive", self.device, "--mode", "duty", "--target", "0.1", "--for", "0.3")
        self.assertEqual([row["key"] for row in self.run_one("restore", self.device)["changes"]], ["ch1.position.p"])

    def test_a_file_is_restored_though_nothing_on_the_board_is_persistent(self):
        board = self.simulate()
        self.run_one("set", self.device, "ch3.velocity.p=150", "history.length=9")
        path = os.path.join(os.path.dirname(self.socket), "saved.json")
        self.run_text("get", self.device, "--file", path)
        self.reset(board)
        changes = self.run_one("restore", self.device, path)["changes"]
        self.assertIn({"key": "ch3.velocity.p", "from": None, "to": 150, "result": "written"}, changes)
        self.assertEqual(self.run_one("get", self.device, "history.length")["parameters"]["history.length"]["value"], 9)

    def test_a_damaged_project_file_is_put_aside_and_told(self):
        self.simulate()
        self.run_one("set", self.device, "ch1.position.p=250")
        kept = [path for path in glob.glob(os.path.join(os.environ["XDG_DATA_HOME"], "motorbench/devices/*.json")) if self.holds(path)]
        self.assertEqual(len(kept), 1)
        with open(kept[0], "w", encoding="utf-8") as file:
            file.write("{")
        run = contract.Run(["--json", "get", self.device, "history.length"])
        self.assertEqual(run.status, 0, run.err)
        self.assertIn("is no device profile; it was put aside as", run.err)
        self.assertTrue(os.path.exists(kept[0] + ".damaged"))
        self.assertEqual(contract.Run(["--quiet", "--json", "get", self.device, "history.length"]).err, "")

    def holds(self, path):
        with open(path, encoding="utf-8") as file:
            return json.load(file)["device"] == f"place unix:{self.socket} {self.device.rsplit('/', 1)[1]}"

    def test_readings_are_kept_with_info(self):
        self.simulate()
        self.assertIn("0 (counts/s (safe)); another with --keep", self.run_text("info", self.device))
        kept = self.run_one("info", self.device, "--keep", "velocity_target_shift=12", "--keep", "input_reading=1")
        self.assertEqual((kept["descriptors"]["velocity_target_shift"], kept["descriptors"]["input_reading"]), ("12", "1"))
        self.assertIn("12 (counts/s × 4096)", self.run_text("info", self.device))
        self.assert_error(2, "info", self.device, "--keep", "velocity_target_shift=5")
        self.assertNotIn("velocity_target_shift", self.run_one("info", self.device, "--keep", "velocity_target_shift=")["descriptors"])

    def test_an_update_goes_over_the_bootloaders_terminal(self):
        self.simulate(f",boot=pty:{self.boot},jumper=closed")
        short = self.short_file()
        run = contract.Run(["--json", "flash", self.device, short, "--via", "serial:" + self.boot])
        done = run.objects()[0]
        self.assertEqual((done["result"], done["from"], done["to"], done["verified"]), ("done", "1.3", "1.4", True))
        with open(run.err.split("transcript of the update is in ")[1].split("\n")[0], encoding="utf-8") as file:
            transcript = file.read()
        self.assertTrue("> :" in transcript and "< ok" in transcript and "# done" in transcript, transcript)

    def test_an_update_that_is_cut_is_reported_and_can_be_repeated(self):
        self.simulate(f",boot=pty:{self.boot},jumper=closed,fault=power-page@5")
        short = self.short_file()
        cut = self.run_one("flash", self.device, short, "--via", "serial:" + self.boot, status=1)
        self.assertEqual((cut["result"], cut["from"], cut["pages"], cut["verified"]), ("failed", "1.3", 4, False))
        self.assertIn("4 of", cut["evidence"])
        again = self.run_one("flash", self.device, short, "--via", "serial:" + self.boot)
        self.assertEqual((again["result"], again["to"], again["verified"]), ("done", "1.4", True))

    def test_an_update_without_its_serial_port_is_refused_with_the_remedy(self):
        self.simulate()
        self.assert_error(2, "flash", self.device, self.short_file(), says="add --via serial:")
        self.assert_error(2, "flash", self.device, self.short_file(), "--via", "avrdude:usbasp:usb", says="add --via serial:")

    def test_what_is_not_known_of_the_bootloader_is_a_setting(self):
        self.simulate(f",boot=pty:{self.boot},jumper=closed")
        way = f"serial:{self.boot}?ending=crlf&pause=20&banner=QUADQUAD&failure=oops|error"
        done = self.run_one("flash", self.device, self.short_file(), "--via", way)
        self.assertEqual((done["result"], done["to"]), ("done", "1.4"))
        for wrong in ("ending=x", "pause=-1", "pause=x", "format=7E1"):
            refused = self.run_json("flash", self.device, self.short_file(), "--via", f"serial:{self.boot}?{wrong}", status=2)
            self.assertEqual(refused[0]["result"], "refused", wrong)

    def short_file(self):
        """The first records of the demo firmware and its end."""
        with open(os.path.join(contract.SOURCE, FIRMWARE), encoding="ascii") as source:
            lines = source.read().splitlines()
        path = os.path.join(os.path.dirname(self.socket), "short.hex")
        with open(path, "w", encoding="ascii") as out:
            out.write("\n".join([*lines[:12], ":00000001FF"]) + "\n")
        return path
