# SPDX-License-Identifier: GPL-3.0-or-later
"""Verbs that watch and move motors."""
import json
import signal
import subprocess

import contract
from contract import CIM, EMPTY, SAMPLE, ContractTest, Run

CHANNELS = {"position", "velocity", "current", "duty", "error", "bus_voltage", "temperature", "analog1"}


class Motion(ContractTest):
    def split(self, objects, last):
        """Samples, then one last line with these keys."""
        samples, summary = objects[:-1], objects[-1]
        for sample in samples:
            self.assertEqual(set(sample), SAMPLE)
        self.assertEqual(set(summary), last)
        return samples, summary

    def drive(self, device, *arguments, status=0):
        return self.split(self.run_json("drive", device, *arguments, status=status), {"samples", "stopped", "reason"})

    def test_watch_streams_every_channel_and_sums_up(self):
        samples, last = self.split(self.run_json("watch", CIM, "--for", "1"), {"summary"})
        summary = last["summary"]
        self.assertEqual(set(summary), {"samples", "lost", "seconds"})
        self.assertEqual(summary["samples"], len(samples))
        self.assertLessEqual(CHANNELS, {sample["channel"] for sample in samples})
        for channel in CHANNELS:
            times = [sample["t"] for sample in samples if sample["channel"] == channel]
            self.assertEqual(times, sorted(times))
            self.assertGreaterEqual(times[0], 0)

    def test_watch_prints_only_the_channels_that_are_named(self):
        lines = self.run_text("watch", CIM, "--channel", "position", "--channel", "velocity", "--for", "0.5").splitlines()
        self.assertEqual(lines[0], "t,channel,value,unit")
        self.assertEqual({tuple(line.split(",")[1::2]) for line in lines[1:]}, {("position", "counts"), ("velocity", "counts/s")})

    def test_a_rate_that_does_not_come_is_told(self):
        asked = ["watch", CIM, "--channel", "velocity", "--for", "1", "--rate"]
        self.assertRegex(Run([*asked, "5000"]).err, r"--rate 5000: \d+ samples a second came")
        self.assertNotIn("--rate", Run([*asked, "100"]).err)
        self.assertNotIn("--rate", Run(["watch", CIM, "--channel", "halted", "--for", "1", "--rate", "50"]).err)

    def test_states_are_told_by_info_and_are_channels_of_watch(self):
        states = self.run_one("info", CIM)["states"]
        self.assertEqual((states["halted"], states["limit.forward.switch"], states["limit.current"]), (True, False, False))
        self.assertIn(states["input.encoder.a"], (True, False))
        lines = self.run_json("watch", CIM, "--channel", "halted", "--channel", "input.limit.forward", "--for", "0.3")
        self.assertEqual({line["channel"]: line["value"] for line in lines[:-1]}, {"halted": True, "input.limit.forward": True})
        self.assertEqual(set(lines[0]), SAMPLE)
        self.assertEqual(lines[-1]["summary"]["samples"], 2)
        self.assertIn(CIM + ": halted", Run(["watch", CIM, "--for", "0.2"]).err)

    def test_limit_switches_are_overridden_while_the_set_point_lives(self):
        for option, known in (("--limit-override", True), ("--limit-override=reverse", True), ("--limit-override=left", False)):
            with self.subTest(option=option):
                run = Run(["drive", CIM, "--mode", "duty", "--target", "0.1", "--for", "0.3", option])
                self.assertEqual(run.status, 0 if known else 2, run.err)
                self.assertEqual("which limit switches count" in run.err, known)
        self.assert_error(2, "drive", "sim:can/abstractdc:3", "--mode", "duty", "--target", "0", "--for", "1", "--limit-override", says="limit override")
        for options, says in ((("duty", "--brake"), "brake"), (("duty", "--coast"), "coast"), (("velocity", "--ramp", "1"), "has no ramp"),
                              (("off", "--reverse-motor"), "directions")):
            self.assert_error(2, "drive", "sim:can/abstractdc:3", "--for", "1", "--target", "0", "--mode", *options, says=says)
        self.assert_error(2, "drive", CIM, "--mode", "position", "--target", "0", "--relative", "--for", "1", says="no relative moves")

    def test_watch_raises_the_rate_when_asked(self):
        arguments = ("watch", CIM, "--channel", "velocity", "--for", "1")
        usual, _ = self.split(self.run_json(*arguments), {"summary"})
        fast, _ = self.split(self.run_json(*arguments, "--rate", "100"), {"summary"})
        self.assertGreater(len(fast), 3 * len(usual))

    def test_watch_ends_cleanly_on_a_signal(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            status, objects, err = self.run_until(number, "watch", CIM, "--rate", "100")
            self.assertEqual(status, 0, err)
            self.assertIn("summary", objects[-1])

    def test_watch_ends_quietly_when_its_reader_goes(self):
        with subprocess.Popen([contract.PROGRAM, "watch", CIM, "--for", "60"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
            self.assertEqual(process.stdout.readline(), "t,channel,value,unit\n")
            process.stdout.close()
            self.assertEqual(process.wait(timeout=contract.LIMIT), 0)
            self.assertNotIn("annot", process.stderr.read())

    def test_watch_tells_a_lost_link(self):
        run = Run(["--json", "watch", "sim:can?fault=busoff@1/dmc60c:5", "--for", "60"])
        self.assertEqual((run.status, run.err.count("\n")), (5, 1))
        self.assertIn("summary", run.objects()[-1])

    def test_drive_reaches_the_target_and_stops(self):
        samples, last = self.drive(CIM, "--mode", "velocity", "--target", "20000", "--for", "1.5")
        self.assertEqual((last["stopped"], last["reason"], last["samples"]), (True, "done", len(samples)))
        speeds = [sample["value"] for sample in samples if sample["channel"] == "velocity"]
        self.assertAlmostEqual(max(speeds), 20000, delta=3000)
        duties = [sample["value"] for sample in samples if sample["channel"] == "duty"]
        self.assertEqual(duties[-1], 0)

    def test_drive_goes_backwards(self):
        samples, last = self.drive(CIM, "--mode", "duty", "--target", "-0.25", "--for", "0.5")
        self.assertEqual(last["reason"], "done")
        self.assertAlmostEqual(min(sample["value"] for sample in samples if sample["channel"] == "duty"), -0.25, delta=0.01)

    def test_drive_stops_on_a_signal(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            status, objects, err = self.run_until(number, "drive", CIM, "--mode", "duty", "--target", "0.2", "--for", "60")
            self.assertEqual(status, 0, err)
            self.assertEqual((objects[-1]["stopped"], objects[-1]["reason"]), (True, "interrupted"))

    def test_drive_stops_for_safety(self):
        for fault, status, stopped in (("reset@1.2", 4, True), ("silent@250", 4, False), ("busoff@1.2", 5, False)):
            with self.subTest(fault):
                _, last = self.drive(f"sim:can?fault={fault}/dmc60c:5", "--mode", "duty", "--target", "0.1", "--for", "20", status=status)
                self.assertEqual((last["reason"], last["stopped"]), ("safety", stopped))

    def test_drive_refuses_what_must_not_move(self):
        rows = self.run_one("scan", "sim:can?fault=duplicate")["devices"]
        twin = next(row["device"] for row in rows if row["address"] == 5)
        self.assert_error(4, "drive", twin, "--mode", "duty", "--target", "0.1", "--for", "1")
        _, last = self.drive(twin, "--mode", "off", "--target", "0", "--for", "0.2")
        self.assertEqual((last["stopped"], last["reason"]), (True, "done"), "a stop is never refused")

    def test_a_signal_ends_the_search_for_a_device(self):
        for verb in (["drive", "--mode", "duty", "--target", "0.1", "--for", "1"], ["watch"], ["step", "--mode", "duty", "--to", "0.1"]):
            words = ["--retries", "1000", verb[0], "sim:can/dmc60c:40", *verb[1:]]
            status, out, err = self.cut(1.5, *words)
            self.assertEqual((status, out), (1, ""), err)
            self.assertIn("interrupted before it was done", err)

    def test_a_hang_up_that_nohup_ignores_ends_nothing(self):
        def as_by_nohup():
            signal.signal(signal.SIGHUP, signal.SIG_IGN)

        words = [contract.PROGRAM, "--json", "watch", CIM, "--for", "1.5"]
        with subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, preexec_fn=as_by_nohup) as process:
            process.stdout.readline()
            process.send_signal(signal.SIGHUP)
            out, err = process.communicate(timeout=contract.LIMIT)
        self.assertEqual(process.returncode, 0, err)
        self.assertGreater(json.loads(out.splitlines()[-1])["summary"]["seconds"], 1.4)
