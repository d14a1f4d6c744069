# SPDX-License-Identifier: GPL-3.0-or-later
"""Supermodified nodes behind a pseudo terminal, simulated by another process: everything that a user does with a real one."""
import json
import os
import signal
import subprocess
import tempfile
import threading
import time

import contract
from contract import ContractTest, Run

# Of positions, samples per second, as the wire allows.
WIRE_LIMIT = {("D1", 9600): 53, ("D1", 57600): 320, ("D1", 115200): 640, ("D3", 9600): 43.6, ("D3", 57600): 262, ("D3", 115200): 524}


class Nodes:
    """`motorbenchctl simulate` on a pseudo terminal, and what it tells."""

    def __init__(self, test, *units, baud=None):
        self.folder = tempfile.TemporaryDirectory()
        test.addCleanup(self.folder.cleanup)
        self.path = os.path.join(self.folder.name, "tty0")
        on = "pty:" + self.path + (f"?baud={baud}" if baud else "")
        self.process = subprocess.Popen([contract.PROGRAM, "--json", "simulate", "--on", on, *units],
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        test.addCleanup(self.end)
        test.assertEqual(json.loads(self.process.stdout.readline())["ready"], True)
        self.events = []
        threading.Thread(target=self.listen, daemon=True).start()

    def listen(self):
        for line in self.process.stdout:
            self.events.append((time.monotonic(), json.loads(line)))

    def end(self):
        self.process.kill()
        self.process.communicate()

    def when(self, what, after=0.0, limit=20.0):
        """When it happened, on the monotonic clock; None if it did not."""
        end = time.monotonic() + limit
        while time.monotonic() < end:
            for at, event in list(self.events):
                if event["event"] == what and at >= after:
                    return at
            time.sleep(0.005)
        return None


class SupermodifiedTest(ContractTest):
    def spawn(self, *arguments):
        process = subprocess.Popen([contract.PROGRAM, "--json", *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        return process

    def work(self, baud):
        nodes = Nodes(self, "supermodified:4,dialect=D1", "supermodified:5,dialect=D3", baud=baud)
        link = f"serial:{nodes.path}?baud={baud}"
        rows = self.run_one("scan", link)["devices"]
        self.assertEqual([(row["address"], row["dialect"], row["state"]) for row in rows], [(4, "D1", "online"), (5, "D3", "online")])
        node = f"{link}/supermodified:4"
        read = self.run_one("get", node)["parameters"]
        self.assertEqual(read["profile.velocity"]["value"], 800)
        self.assertNotIn("anti_windup", read)
        written = self.run_one("set", node, "gain.p=1100", "io.direction=3", "--store")
        self.assertIs(written["verified"], True)
        self.assertEqual(self.run_one("get", node, "gain.p")["parameters"]["gain.p"]["value"], 1100)
        self.assertIsNone(self.run_one("set", node, "node.mask=255")["verified"])
        self.assert_error(2, "set", node, "error.level=1")
        drive = self.run_json("drive", node, "--mode", "velocity", "--target", "2000", "--for", "1")
        self.assertEqual((drive[-1]["stopped"], drive[-1]["reason"]), (True, "done"))
        self.assertIsNotNone(nodes.when("output-on"))
        self.assertIsNotNone(nodes.when("output-off"))
        for dialect, device in (("D1", node), ("D3", f"{link}/supermodified:5")):
            lines = self.run_json("watch", device, "--channel", "position", "--rate", "10000", "--for", "2")
            summary = lines[-1]["summary"]
            rate = summary["samples"] / summary["seconds"]
            limit = WIRE_LIMIT[dialect, baud]
            print(f"pty, {dialect} at {baud} baud: {rate:.0f} positions/s, wire limit {limit} ({100 * rate / limit:.0f} %), "
                  f"{summary['lost']} lost", flush=True)
            self.assertGreater(summary["samples"], 0)

    @contract.long
    def test_everything_works_at_9600_baud(self):
        self.work(9600)

    @contract.long
    def test_everything_works_at_57600_baud(self):
        self.work(57600)

    @contract.long
    def test_everything_works_at_115200_baud(self):
        self.work(115200)

    def test_moves_reach_their_targets(self):
        nodes = Nodes(self, "supermodified:4,dialect=D2")
        node = f"serial:{nodes.path}?baud=115200/supermodified:4"
        for mode, more in (("position", []), ("ramp-position", ["--velocity", "2000", "--acceleration", "20000"])):
            lines = self.run_json("drive", node, "--mode", mode, "--target", "2000", *more, "--for", "3")
            positions = [line["value"] for line in lines if line.get("channel") == "position"]
            self.assertAlmostEqual(positions[-1], 2000, delta=60, msg=mode)
        self.assert_error(2, "drive", node, "--mode", "duty", "--target", "0.1", "--for", "1", says="has no mode")
        self.assert_error(2, "drive", node, "--mode", "velocity", "--target", "1e11", "--for", "1")

    def test_driving_one_node_starts_nobody_else(self):
        nodes = Nodes(self, "supermodified:4,mask=240", "supermodified:5")
        link = f"serial:{nodes.path}?baud=57600"
        self.assert_error(4, "drive", f"{link}/supermodified:5", "--mode", "velocity", "--target", "200", "--for", "1", says="node 4")
        self.assertEqual([event["event"] for _, event in nodes.events], [])
        self.assertEqual(self.run_one("info", f"{link}/supermodified:5")["state"], "online")

    def test_a_step_that_overflows_is_refused_before_anything_moves(self):
        nodes = Nodes(self, "supermodified:4")
        node = f"serial:{nodes.path}?baud=57600/supermodified:4"
        for device in (node, "sim:serial/supermodified:4"):
            self.assert_error(2, "drive", device, "--mode", "position", "--target", "3000000", "--for", "1", says="overflows")
        self.assertEqual([event["event"] for _, event in nodes.events], [])

    def test_limits_that_nobody_gives_are_asked_for_before_anything_is_sent(self):
        nodes = Nodes(self, "supermodified:4")
        node = f"serial:{nodes.path}?baud=57600/supermodified:4"
        self.assert_error(2, "step", node, "--mode", "position", "--to", "100", says="give --travel")
        self.assertEqual([event["event"] for _, event in nodes.events], [])

    def test_a_number_that_another_node_has_is_refused_though_nobody_looked_for_it(self):
        nodes = Nodes(self, "supermodified:4", "supermodified:5")
        link = f"serial:{nodes.path}?baud=57600"
        self.assert_error(2, "number", f"{link}/supermodified:4", "5", says="used by another node of this line; choose a free one")
        gain = self.run_one("get", f"{link}/supermodified:4", "gain.p")["parameters"]
        self.assert_error(2, "set", f"{link}/supermodified:4", "gain.p=900", "node.id=5", says="used by another node")
        self.assertEqual(self.run_one("get", f"{link}/supermodified:4", "gain.p")["parameters"], gain)
        self.assertEqual(self.run_one("number", f"{link}/supermodified:4", "6")["new"], 6)

    def test_what_a_profile_stores_and_may_pass_is_said(self):
        nodes = Nodes(self, "supermodified:4")
        node = f"serial:{nodes.path}?baud=57600/supermodified:4"
        first = contract.Run(["--json", "drive", node, "--mode", "ramp-position", "--target", "100", "--velocity", "3000", "--for", "0.6"])
        self.assertEqual(first.status, 0, first.err)
        self.assertIn("profile.velocity becomes 3000, it was 800: the device stores it", first.err)
        self.assertIn("may pass the target", first.err)
        again = contract.Run(["--json", "drive", node, "--mode", "ramp-position", "--target", "100", "--velocity", "3000", "--for", "0.6"])
        self.assertNotIn("stores it", again.err)
        self.assertEqual(self.run_one("get", node, "profile.velocity")["parameters"]["profile.velocity"]["value"], 3000)

    def test_short_runs_one_after_the_other_lock_nobody_up(self):
        nodes = Nodes(self, "supermodified:4,dialect=D1", "supermodified:5,dialect=D2")
        for turn in range(12):
            node = f"serial:{nodes.path}?baud=57600/supermodified:{4 + turn % 2}"
            begin = time.monotonic()
            drive = self.spawn("drive", node, "--mode", "velocity", "--target", "800", "--for", "60")
            self.assertIsNotNone(nodes.when("output-on", after=begin), turn)
            at = time.monotonic()
            drive.send_signal(signal.SIGKILL)
            self.assertIsNotNone(nodes.when("output-off", after=at), turn)
            self.run_one("get", node, "gain.p")
        self.assertEqual([event for _, event in nodes.events if event["event"] in ("crashed", "hung")], [])

    def timed_scan(self, *arguments):
        begin = time.monotonic()
        run = contract.Run(["--json", "scan", *arguments])
        self.assertEqual(run.status, 0, run.err)
        return run.objects()[0]["devices"], time.monotonic() - begin, run.err

    @contract.long
    def test_a_second_run_remembers_who_was_there(self):
        nodes = Nodes(self, "supermodified:4", "supermodified:77,dialect=D3", baud=38400)
        link = f"serial:{nodes.path}"
        first, long, _ = self.timed_scan(link)
        second, short, _ = self.timed_scan(link)
        self.assertEqual([row["address"] for row in first], [4, 77])
        self.assertEqual(second, first)
        print(f"pty, 38400 baud, unknown rate: first scan {long:.1f} s, another run of the program {short:.1f} s", flush=True)
        self.assertLess(short, 0.7 * long)
        begin = time.monotonic()
        self.run_one("get", f"{link}/supermodified:77", "gain.p")
        self.assertLess(time.monotonic() - begin, 0.7 * long)
        [file] = os.listdir(os.path.join(os.environ["XDG_CACHE_HOME"], "motorbench", "scans"))
        with open(os.path.join(os.environ["XDG_CACHE_HOME"], "motorbench", "scans", file), "w", encoding="utf-8") as spoilt:
            spoilt.write("{")
        third, _, err = self.timed_scan(link)
        self.assertEqual(third, first)
        self.assertEqual(err.count("is no list of devices and is ignored"), 1, err)
        nodes.end()
        gone = Nodes(self, "supermodified:77,dialect=D3", baud=38400)
        os.replace(gone.path, nodes.path)  # the same port, with one node less
        self.assertEqual([row["address"] for row in self.timed_scan(link)[0]], [77])

    @contract.long
    def test_everything_can_be_searched_and_cut(self):
        nodes = Nodes(self, "supermodified:4", "supermodified:120", baud=57600)
        link = f"serial:{nodes.path}?baud=57600"
        rows, _, _ = self.timed_scan("--everything", link)
        self.assertEqual([row["address"] for row in rows], [4, 120])
        search = subprocess.Popen([contract.PROGRAM, "scan", "--everything", f"serial:{nodes.path}"], stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, text=True)
        self.addCleanup(search.communicate)
        self.addCleanup(search.kill)
        self.assertIn("Looking for Supermodified nodes", search.stderr.readline())
        search.send_signal(signal.SIGINT)
        search.communicate(timeout=contract.LIMIT)

    def test_the_position_is_zeroed_before_a_drive(self):
        nodes = Nodes(self, "supermodified:4")
        node = f"serial:{nodes.path}?baud=115200/supermodified:4"
        self.run_json("drive", node, "--mode", "position", "--target", "1500", "--for", "2")
        lines = self.run_json("drive", node, "--mode", "position", "--target", "0", "--zero", "--for", "1")
        positions = [line["value"] for line in lines if line.get("channel") == "position"]
        self.assertEqual((lines[-1]["stopped"], lines[-1]["reason"]), (True, "done"))
        self.assertTrue(positions and max(abs(p) for p in positions) < 60, positions)
        self.assert_error(2, "drive", contract.CIM, "--mode", "duty", "--target", "0", "--zero", "--for", "1", says="zeroes its position")
        self.assert_error(2, "drive", node, "--mode", "velocity", "--target", "1", "--ramp", "1", "--for", "1", says="has no ramp")

    def test_moves_are_relative_buffered_and_end_in_a_halt(self):
        node = "sim:serial/supermodified:4"
        positions = lambda *more: [line["value"] for line in self.run_json("drive", node, *more)[:-1] if line["channel"] == "position"]
        self.assertAlmostEqual(positions("--mode", "position", "--target", "300", "--relative", "--for", "1.5")[-1], 300, delta=10)
        self.assertAlmostEqual(positions("--mode", "position", "--target", "-300", "--buffered", "--for", "1.5")[-1], -300, delta=10)
        running = positions("--mode", "velocity", "--target", "500", "--for", "1", "--halt")
        self.assertGreater(running[-1], 300)
        self.assertLess(abs(running[-1] - running[-5]), 5, "it stood before it was switched off")
        self.assertLess(max(map(abs, positions("--halt", "--for", "0.5"))), 5)
        self.assert_error(2, "drive", node, "--mode", "velocity", "--target", "1", "--relative", "--for", "1", says="a distance")
        self.assert_error(2, "drive", node, "--for", "1", says="--mode is missing")

    def test_a_terminal_that_is_pulled_away_during_a_drive_is_reported(self):
        nodes = Nodes(self, "supermodified:4")
        drive = self.spawn("drive", f"serial:{nodes.path}?baud=115200/supermodified:4", "--mode", "velocity", "--target", "1500", "--for", "30")
        self.assertIsNotNone(nodes.when("output-on"))
        nodes.process.kill()
        out, err = drive.communicate(timeout=contract.LIMIT)
        self.assertEqual(drive.returncode, 5, err)
        self.assertIn("the link was lost while the motor was driven", err)
        self.assertIs(json.loads(out.splitlines()[-1])["stopped"], False)

    def dies(self, number):
        nodes = Nodes(self, "supermodified:4")
        drive = self.spawn("drive", f"serial:{nodes.path}?baud=57600/supermodified:4", "--mode", "velocity", "--target", "1500", "--for", "60")
        self.assertIsNotNone(nodes.when("output-on"))
        time.sleep(0.5)
        at = time.monotonic()
        drive.send_signal(number)
        off = nodes.when("output-off", after=at)
        self.assertIsNotNone(off, "the motor goes on")
        print(f"{signal.Signals(number).name}: stopped after {1000 * (off - at):.0f} ms", flush=True)
        self.assertLess(off - at, 0.7)
        if number == signal.SIGSTOP:
            drive.send_signal(signal.SIGCONT)

    def test_a_motor_stops_when_the_program_is_killed(self):
        self.dies(signal.SIGKILL)

    def test_a_motor_stops_when_the_program_is_frozen(self):
        self.dies(signal.SIGSTOP)

    def test_a_new_node_id_is_taken_and_waits_for_the_power_cycle(self):
        nodes = Nodes(self, "supermodified:4")
        answer = self.run_one("number", f"serial:{nodes.path}?baud=57600/supermodified:4", "9")
        self.assertEqual((answer["old"], answer["new"], answer["verified"]), (4, 9, None))
        self.assert_error(2, "identify", f"serial:{nodes.path}?baud=57600/supermodified:4", says="turn its shaft by hand")

    def test_frames_are_named(self):
        text = "(1.0) tty0 tx 55AA040108040028000024\n(1.1) tty0 rx 55AA0104FA0152A9\n"
        rows = self.run_json("decode", text=text)
        self.assertEqual([(row["family"], row["message"], row["address"]) for row in rows],
                         [("supermodified", "absolute move", 4), ("supermodified", "error", 4)])
        self.assertEqual(rows[0]["fields"]["position"], 10240)
        self.assertEqual(rows[1]["fields"]["c1"], 82)

    def test_a_link_that_is_lost_while_a_shaft_is_turned_is_no_stop_for_safety(self):
        nodes = Nodes(self, "supermodified:4", baud=57600)
        identifying = self.spawn("identify", "--yes", f"serial:{nodes.path}?baud=57600/supermodified:4")
        self.assertIsNotNone(nodes.when("output-on"))
        nodes.process.kill()
        out, err = identifying.communicate(timeout=contract.LIMIT)
        self.assertEqual((identifying.returncode, out), (5, ""), err)
        self.assertIn("see that the motor stands before anything else", err)

    def test_what_a_dialect_does_not_have_is_left_out_of_what_is_restored(self):
        with tempfile.TemporaryDirectory() as folder:
            saved = os.path.join(folder, "d3.json")
            self.run_text("get", "sim:serial/supermodified:5", "--file", saved)
            run = Run(["--json", "restore", "sim:serial/supermodified:4", saved, "--dry-run"])
        self.assertEqual(run.status, 0, run.err)
        self.assertNotIn("error.reaction", run.out)
        self.assertIn("error.reaction does not exist in this device's dialect, left out", run.err)

    def test_nothing_is_restored_to_one_whose_dialect_is_not_known(self):
        nodes = Nodes(self, "supermodified:6,level=1")
        node = f"serial:{nodes.path}?baud=57600/supermodified:6"
        with tempfile.TemporaryDirectory() as folder:
            saved = os.path.join(folder, "d1.json")
            self.run_text("get", "sim:serial/supermodified:4", "--file", saved)
            for more in ([], ["--dry-run"]):
                run = Run(["restore", node, saved, *more])
                self.assertNotEqual(run.status, 0, run.out)
                self.assertIn("error level is 1", run.err)
                self.assertNotIn("nothing to change", run.out)

    def test_the_error_reaction_of_d3_is_not_the_error_level_of_d1(self):
        reactions = "02" + "00" * 19
        text = f"(1.0) tty0 tx 55AA04771C0101{0x1C:02X}\n(1.1) tty0 tx 55AA04771C14{reactions}0A\n(1.2) tty0 rx 55AA77047314{reactions}65\n"
        rows = self.run_json("decode", text=text)
        self.assertEqual([row["message"] for row in rows], ["error-reporting level", "error reaction", "get error reaction"])
        self.assertEqual((rows[0]["fields"]["level"], rows[1]["fields"]["r0"], rows[2]["address"]), (1, 2, 4))
