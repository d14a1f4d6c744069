# SPDX-License-Identifier: GPL-3.0-or-later
"""plot: the console hands a recording to the program with the window and passes on what it says."""
import os
import pathlib
import shutil
import struct
import subprocess
import tempfile

import contract
from contract import CIM, ContractTest, Run


def png_size(path):
    data = path.read_bytes()
    assert data.startswith(b"\x89PNG\r\n\x1a\n")
    return struct.unpack(">II", data[16:24])


class Plot(ContractTest):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name)
        if not (pathlib.Path(contract.PROGRAM).parent / "motorbench").exists():
            self.skipTest("motorbench is not built")

    def tearDown(self):
        self.folder.cleanup()

    def recording(self):
        file = self.path / "watch.csv"
        file.write_text(self.run_text("watch", CIM, "--for", "0.5"), encoding="utf-8")
        return str(file)

    def test_what_watch_printed_becomes_a_picture(self):
        out = self.path / "a.png"
        result = self.run_one("plot", self.recording(), "--out", str(out), "--size", "800x600")
        self.assertEqual(set(result), {"file", "out", "signals", "samples", "lost", "seconds", "complete", "shortened"})
        self.assertGreater(result["samples"], 50)
        self.assertGreater(result["signals"], 3)
        self.assertEqual(png_size(out), (1600, 1200))  # at twice the density

    def test_every_kind_of_picture_in_both_themes(self):
        file = self.recording()
        for kind, start in (("svg", b"<?xml"), ("pdf", b"%PDF-"), ("png", b"\x89PNG")):
            for theme in ("dark", "light"):
                out = self.path / f"{theme}.{kind}"
                self.run_text("plot", file, "--out", str(out), "--theme", theme)
                self.assertTrue(out.read_bytes().startswith(start), kind)

    def test_it_needs_no_display(self):
        environment = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")}
        run = Run(["plot", self.recording(), "--out", str(self.path / "b.png")], environment=environment)
        self.assertEqual(run.status, 0, run.err)
        self.assertIn("0 lost", run.out)

    def test_wrong_calls_are_wrong_usage_and_leave_nothing(self):
        out = self.path / "c.png"
        bad = self.path / "bad.csv"
        bad.write_text("time_s,a\n0,1\n1,x\n", encoding="utf-8")
        self.assert_error(2, "plot", says="file")
        self.assert_error(2, "plot", str(bad), says="--out")
        self.assert_error(2, "plot", str(bad), "--out", str(out), says="line 3")
        self.assertTrue(Run(["plot", str(bad), "--out", str(out)]).err.startswith("motorbenchctl: "))
        self.assert_error(2, "plot", "/nonexistent.mcap", "--out", str(out), says="/nonexistent.mcap")
        self.assert_error(2, "plot", "/dev/null", "--out", str(out))
        self.assert_error(2, "plot", ".", "--out", str(out), says="is a folder")
        self.assert_error(2, "plot", self.recording(), "--out", str(self.path / "c.gif"), says="c.gif")
        self.assert_error(2, "plot", self.recording(), "--out", "/nonexistent/c.png", says="/nonexistent/c.png")
        self.assert_error(2, "plot", self.recording(), "--out", str(out), "--size", "0x0", says="--size")
        self.assert_error(2, "plot", self.recording(), "--out", str(out), "--theme", "pink", says="--theme")
        self.assertFalse(out.exists())

    def test_the_window_program_prints_a_report_and_nothing_else(self):
        program = os.path.join(os.path.dirname(contract.PROGRAM), "motorbench")
        noise, page, out = self.path / "noise.html", self.path / "page.html", self.path / "out.pdf"
        noise.write_bytes(bytes(range(256)) * 800)
        page.write_text("<!DOCTYPE html>\n<html><body>card</body></html>", encoding="utf-8")
        for file, name, status in ((noise, out, 2), (page, self.path / "out.png", 2), (page, out, 0)):
            done = subprocess.run([program, "--report", str(file), "--out", str(name)], capture_output=True, text=True, check=False,
                                  env=dict(os.environ, QT_QPA_PLATFORM="offscreen"))
            self.assertEqual(done.returncode, status, done.stderr)
            self.assertEqual(name.exists(), status == 0)

    def test_alone_it_says_what_is_missing(self):
        lonely = self.path / "motorbenchctl"
        shutil.copy(contract.PROGRAM, lonely)
        done = subprocess.run([lonely, "plot", self.recording(), "--out", "x.png"], capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("motorbench", done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1)
