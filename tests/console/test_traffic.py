# SPDX-License-Identifier: GPL-3.0-or-later
"""Verbs that show what is on the wire."""
import json
import os
import signal
import subprocess
import tempfile

import contract
from contract import ContractTest, Run

FRAME = {"t", "link", "id", "data", "family", "message", "address", "fields"}
LOG = """(1436509052.249713) can0 02061405#0040110000000000
(1436509052.250000) can0 123#0102
(1436509053.000001) vcan1 00000240#
(1436509053.000002) can0 7FF#R
"""
ASC = """date Fri Jul 10 10:24:12.249 2015
base hex  timestamps absolute
internal events logged
// version 9.0.0
Begin Triggerblock Fri Jul 10 10:24:12.249 2015
   0.000000 Start of measurement
   0.000713 1  2061405x        Rx   d 8 00 40 11 00 00 00 00 00  Length = 0 BitCount = 0 ID = 33952773x
   0.001000 1  123             Rx   d 2 01 02
   1.001000 2  7FF             Tx   r
End TriggerBlock
"""
RECORDING = """(1436509052.000000) can0 02061405#0040110000000000
(1436509052.000500) can0 02061485#01E240FED4000014
(1436509052.010000) can0 02061405#0020110018008001
(1436509052.015000) can0 02060005#0F00000000000000 T
(1436509052.020000) can0 02061405#0040110000000000
(1436509053.000000) can0 0206F007#341203012060
(1436509053.000200) can0 0206F007#3412000017010901
"""


class Replay(ContractTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.link = "replay:" + self.record("run.log", RECORDING)

    def record(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def test_scan_finds_who_sends_in_a_recording(self):
        devices = self.run_one("scan", self.link)["devices"]
        self.assertEqual([(d["address"], d["state"], d["session"], d["firmware"]) for d in devices],
                         [(5, "online", None, None), (7, "online", 0x1234, "1.23")])
        self.assertEqual(devices[0]["device"], self.link + "/dmc60c:5")
        self.assertEqual(self.run_one("info", self.link + "/dmc60c:7")["bootloader"], "1.9")

    def test_watch_gives_the_samples_with_the_times_of_the_recording_and_ends_with_it(self):
        for options in ("?speed=max", "?speed=20", ""):
            lines = self.run_json("watch", self.link + options + "/dmc60c:5", "--channel", "duty", "--channel", "position")
            self.assertEqual([(line["t"], line["channel"], round(line["value"], 4)) for line in lines[:-1]],
                             [(1436509052.0, "duty", 0.5), (1436509052.0005, "position", 123456), (1436509052.01, "duty", 0.25),
                              (1436509052.02, "duty", 0.5)])
            self.assertEqual(lines[-1]["summary"], {"samples": 4, "lost": 0, "seconds": 1.0})

    def test_monitor_prints_the_recording_as_it_is(self):
        out = self.run_text("monitor", self.link + "?speed=max")
        self.assertEqual([line.split(" ", 1)[0] + " " + line.split(" ")[2] for line in out.splitlines()],
                         [line.split(" ", 1)[0] + " " + line.split(" ")[2] for line in RECORDING.splitlines()])

    def test_asc_recordings_are_replayed_too(self):
        rows = self.run_json("watch", "replay:" + self.record("run.asc", ASC) + "?speed=max/dmc60c:5", "--channel", "duty")
        self.assertEqual(rows[0]["value"], 16384 / 32767)
        self.assertAlmostEqual(rows[0]["t"], 1436523852.249713, places=6)

    def test_a_recording_is_neither_driven_nor_written(self):
        device = self.link + "/dmc60c:5"
        self.assert_error(2, "drive", device, "--mode", "duty", "--target", "0.1", "--for", "1", says="is a recording")
        self.assert_error(2, "set", device, "slot0.p=1", says="is a recording")
        recipe = self.record("ok.json", '{"recipe": 1, "name": "a", "family": "dmc60c"}')
        firmware = f"{contract.SOURCE}/resources/firmware/dmc60c-demo.hex"
        for words in (["restart", device], ["flash", device, firmware], ["service", recipe, self.link]):
            self.assert_error(2, *words, says="is a recording")
        self.assert_error(3, "watch", self.link + "/dmc60c:9", says="no dmc60c sends as number 9")

    def test_what_cannot_be_replayed_is_told_in_one_line(self):
        self.assert_error(5, "scan", "replay:" + self.folder + "/none.log", says="no such file")
        self.assert_error(2, "scan", "replay:" + self.folder, says="is not a file")
        self.assert_error(2, "scan", "replay:" + self.record("bad.log", RECORDING + "rubbish\nmore\n"), says="bad.log: line 8 is not")
        self.assert_error(2, "monitor", "replay:" + self.record("empty.log", ""), says="no frame")
        self.assert_error(2, "scan", self.link + "?speed=fast", says="speed=fast")
        self.assert_error(2, "scan", self.link + "?rate=1", says="no option 'rate'")
        self.assertEqual(len(self.run_one("scan", "replay:" + self.record("cut.log", RECORDING + "(14365"))["devices"]), 2)


class Traffic(ContractTest):
    def test_a_signal_ends_the_wait_for_who_writes_into_a_pipe(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "pipe")
            os.mkfifo(path)
            for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
                process = subprocess.Popen([contract.PROGRAM, "decode", path], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
                self.addCleanup(process.communicate)
                self.addCleanup(process.kill)
                contract.heeds(process, number)
                with self.assertRaises(subprocess.TimeoutExpired):
                    process.wait(timeout=1)
                process.send_signal(number)
                self.assertEqual(process.wait(timeout=contract.LIMIT), 1)
            with subprocess.Popen([contract.PROGRAM, "--json", "decode", path], stdout=subprocess.PIPE, text=True) as process:
                with open(path, "w", encoding="utf-8") as pipe:
                    pipe.write("(1.5) can0 000#\n")
                out, _ = process.communicate(timeout=contract.LIMIT)
            self.assertEqual((process.returncode, json.loads(out)["t"]), (0, 1.5))

    def test_decode_waits_for_its_reader_and_loses_nothing(self):
        lines = 60000  # 38 MB of JSON
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "long.log")
            with open(path, "w", encoding="utf-8") as file:
                file.writelines(f"({i}.0) can0 02061405#000011007800{i:04X}\n" for i in range(lines))
            for file in (path, "-"):
                with open(path, "rb") as source, subprocess.Popen([contract.PROGRAM, "--json", "decode", file], stdin=source,
                                                                  stdout=subprocess.PIPE) as process:
                    self.addCleanup(process.kill)
                    read = [line for line in process.stdout]
                self.assertEqual((process.returncode, len(read), json.loads(read[-1])["t"]), (0, lines, lines - 1))

    def test_a_signal_ends_the_decoding_of_a_file_whose_reader_waits(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "long.log")
            with open(path, "w", encoding="utf-8") as file:
                file.write(LOG * 2000)
            with subprocess.Popen([contract.PROGRAM, "--json", "decode", path], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
                self.addCleanup(process.kill)
                json.loads(process.stdout.readline())
                process.send_signal(signal.SIGINT)
                _, told = process.communicate(timeout=contract.LIMIT)
            self.assertEqual(process.returncode, 1)
            self.assertIn("interrupted", told)

    def test_decode_names_messages_and_fields(self):
        frames = self.run_json("decode", text=LOG)
        self.assertEqual(len(frames), 4)
        for frame in frames:
            self.assertEqual(set(frame), FRAME)
        status, unknown, enumerate_, remote = frames
        self.assertEqual((status["family"], status["address"], status["id"], status["link"]), ("dmc60c", 5, 0x02061405, "can0"))
        self.assertAlmostEqual(status["t"], 1436509052.249713, places=6)
        self.assertEqual(status["data"], "0040110000000000")
        self.assertTrue(status["message"] and status["fields"])
        for value in status["fields"].values():
            self.assertIsInstance(value, (int, float))
        self.assertEqual((unknown["family"], unknown["message"], unknown["address"], unknown["fields"]), (None, None, None, {}))
        self.assertEqual(enumerate_["family"], "dmc60c")
        self.assertEqual((remote["id"], remote["data"]), (0x7FF, ""))

    def test_decode_reads_a_file_as_it_reads_standard_input(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "can.log")
            with open(path, "w", encoding="utf-8") as file:
                file.write(LOG)
            self.assertEqual(self.run_json("decode", path), self.run_json("decode", text=LOG))
            self.assertEqual(len(self.run_text("decode", path).splitlines()), 4)
            with open(path, "a", encoding="utf-8") as file:
                file.write("rubbish")
            self.assert_error(2, "decode", path, says="line 5")
        self.assert_error(2, "decode", "/nonexistent/file")

    def decoded(self, text):
        """What is told beside the rows, by a file and by standard input, and what a replay of it tells."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "can.log")
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
            runs = Run(["--json", "decode", path]), Run(["--json", "decode"], text), Run(["--json", "scan", "replay:" + path])
        self.assertEqual([run.status for run in runs], [0, 0, 0], [run.err for run in runs])
        told = {run.err.rsplit(": ", 1)[-1].rstrip("\n") for run in runs}
        self.assertEqual(len(told), 1, told)
        self.assertEqual(runs[0].out, runs[1].out)
        return len(runs[0].objects()), told.pop()

    def test_what_a_recording_loses_at_its_end_and_frames_of_can_fd_are_told_and_lose_no_good_line(self):
        self.assertEqual(self.decoded(LOG), (4, ""))
        fd = "(1436509052.250000) can0 123##311223344\n"
        self.assertEqual(self.decoded(fd + LOG), (4, "1 CAN FD frame is left out, because only classic CAN is read"))
        self.assertEqual(self.decoded(LOG + fd + fd + "(14365"), (4, "2 CAN FD frames are left out, because only classic CAN is read; "
                                                                    "the last line is cut off, and left out"))
        for cut in ("(14365", "(1436509053.000001) vca", "(1436509053.000001) can0 12", "(1436509053.000001) can0 123#0"):
            self.assertEqual(self.decoded(LOG + cut), (4, "the last line is cut off, and left out"))
        self.assertEqual(self.decoded(LOG + "(1436509053.000001) can0 123#01"), (5, "the last line has no end, so its frame may be cut short"))
        run = Run(["decode"], "(1.0) tty0 rx 0102\n(1.1) tty0 tx 03")
        self.assertIn("may be cut short", run.err)

    def test_decode_reads_a_pipe_that_is_named_as_it_comes(self):
        reads, writes = os.pipe()
        with os.fdopen(writes, "w") as pipe:
            pipe.write(LOG)
        try:
            done = subprocess.run([contract.PROGRAM, "--json", "decode", f"/dev/fd/{reads}"], pass_fds=[reads], capture_output=True,
                                  text=True, timeout=contract.LIMIT, check=False)
        finally:
            os.close(reads)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual([json.loads(line) for line in done.stdout.splitlines()], self.run_json("decode", text=LOG))

    def test_decode_reads_vector_asc_logs_too(self):
        status, unknown, remote = self.run_json("decode", text=ASC)
        self.assertEqual((status["family"], status["address"], status["message"]), ("dmc60c", 5, "STSGENERAL"))
        self.assertAlmostEqual(status["t"], 1436523852.249713, places=6)
        self.assertEqual(status["fields"], self.run_json("decode", text=LOG)[0]["fields"])
        self.assertEqual((unknown["id"], unknown["data"], unknown["link"]), (0x123, "0102", "ch1"))
        self.assertEqual((remote["id"], remote["link"]), (0x7FF, "ch2"))
        self.assert_error(2, "decode", text=ASC + "1.0 1 123 Rx d 8 00\n", says="line 11")
        self.assert_error(2, "decode", text="LOGG\0\0\n", says="BLF")

    def test_decode_names_the_line_that_it_does_not_understand(self):
        for line in ("rubbish", "(1.0) can0", "(1.0) can0 02061405", "(1.0) can0 02061405#0", "(x) can0 123#00", "(1.0) can0 123##10", "\0", "x" * 100000):
            self.assert_error(2, "decode", text=LOG + line + "\n", says="line 5")
        self.assert_error(2, "decode", "--dialect", "X", text=LOG)
        self.assertEqual(self.run_json("decode", text=""), [])
        self.assertEqual(len(self.run_json("decode", "--dialect", "LL", text="\n" + LOG.replace("\n", "\r\n"))), 4)

    def test_decode_prints_every_byte_of_an_spi_log_once_and_reads_replies_by_their_questions(self):
        log = ("(1.000000) spidev0 rx 0000\n"
               "(1.000100) spidev0 tx 020401F9\n"
               "(1.000200) spidev0 rx 02080100010301F0\n"
               "(1.000300) spidev0 tx 02050B04EA\n"
               "(1.000400) spidev0 rx 02090B0001000000E9\n")
        lines = self.run_json("decode", text=log)
        self.assertEqual("".join(line["data"] for line in lines), "".join(line.split()[-1] for line in log.splitlines()))
        self.assertEqual([(line["family"], line["message"]) for line in lines],
                         [(None, None)] + 2 * [("quadquad2drv", "get version")] + 2 * [("quadquad2drv", "get position")])
        self.assertEqual(lines[-1]["fields"], {"rc": 0, "position_3": 1})

    def test_decode_prints_bytes_in_which_no_family_finds_anything_once(self):
        lines = self.run_json("decode", text="(1.0) tty0 rx 0102\n(1.1) tty0 tx 0304\n")
        self.assertEqual([(line["data"], line["family"]) for line in lines], [("0102", None), ("0304", None)])

    def test_decode_shows_error_frames_that_no_family_knows(self):
        (frame,) = self.run_json("decode", text="(1.0) can0 20000004#0001000000000000\n")
        self.assertEqual(set(frame), FRAME)
        self.assertEqual((frame["id"], frame["data"], frame["family"], frame["fields"]), (4, "0001000000000000", None, {}))

    def test_monitor_shows_nothing_on_a_silent_link(self):
        self.assertEqual(self.run_text("monitor", "sim:can", "--for", "0.2"), "")
        self.assertEqual(Run(["--json", "monitor", "sim:can", "--for", "0.2"]).status, 0)
