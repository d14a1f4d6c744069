# SPDX-License-Identifier: GPL-3.0-or-later
"""Verbs that show what is on the wire."""
import os
import tempfile

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


class Traffic(ContractTest):
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
        for line in ("rubbish", "(1.0) can0", "(1.0) can0 02061405", "(1.0) can0 02061405#0", "(x) can0 123#00", "(1.0) can0 123##100", "\0", "x" * 100000):
            self.assert_error(2, "decode", text=LOG + line + "\n", says="line 5")
        self.assert_error(2, "decode", "--dialect", "X", text=LOG)
        self.assertEqual(self.run_json("decode", text=""), [])
        self.assertEqual(len(self.run_json("decode", "--dialect", "LL", text="\n" + LOG.replace("\n", "\r\n"))), 4)

    def test_decode_shows_error_frames_that_no_family_knows(self):
        (frame,) = self.run_json("decode", text="(1.0) can0 20000004#0001000000000000\n")
        self.assertEqual(set(frame), FRAME)
        self.assertEqual((frame["id"], frame["data"], frame["family"], frame["fields"]), (4, "0001000000000000", None, {}))

    def test_monitor_shows_nothing_on_a_silent_link(self):
        self.assertEqual(self.run_text("monitor", "sim:can", "--for", "0.2"), "")
        self.assertEqual(Run(["--json", "monitor", "sim:can", "--for", "0.2"]).status, 0)
