# SPDX-License-Identifier: GPL-3.0-or-later
"""Serial links, over pseudo terminals: traffic of a line, ports that go away, ends for simulated devices."""
import json
import os
import re
import select
import subprocess
import tempfile
import tty

import contract
from contract import ContractTest


class SerialTest(ContractTest):
    def setUp(self):
        self.ours, theirs = os.openpty()
        tty.setraw(theirs)
        self.path = os.ttyname(theirs)
        os.close(theirs)
        self.addCleanup(self.pull)

    def pull(self):
        if self.ours is not None:
            os.close(self.ours)
            self.ours = None

    def start(self, *arguments):
        process = subprocess.Popen([contract.PROGRAM, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.kill)
        return process

    def feed_until_read(self, process, data):
        """Writes until the program, which opens the port in its own time, prints a line."""
        for _ in range(contract.LIMIT * 20):
            if select.select([process.stdout], [], [], 0.05)[0]:
                return process.stdout.readline() or self.fail(process.stderr.read())
            os.write(self.ours, data)
        self.fail("nothing was printed")

    def test_monitor_prints_bytes_and_decode_reads_them_back(self):
        process = self.start("monitor", "serial:" + self.path)
        line = self.feed_until_read(process, b"\x55\xaa\x00\x0d")
        process.terminate()
        process.communicate(timeout=contract.LIMIT)
        self.assertRegex(line, r"^\(\d{10}\.\d{6}\) " + os.path.basename(self.path) + r" rx (55AA000D)+\n$")
        rows = self.run_json("decode", text=line)
        self.assertEqual("".join(row["data"] for row in rows), re.search(r"rx (\w+)", line).group(1))
        for row in rows:
            self.assertEqual(set(row), {"t", "link", "id", "data", "family", "message", "address", "fields"})
            self.assertIsNone(row["id"])

    def test_a_terminal_that_is_pulled_away_in_mid_traffic_is_reported(self):
        process = self.start("monitor", "serial:" + self.path)
        self.feed_until_read(process, b"\x55")
        self.pull()
        _, err = process.communicate(timeout=contract.LIMIT)
        self.assertEqual(process.returncode, 5, err)
        self.assertRegex(err, r"hung up; start it again\n$")
        self.assertEqual(err.count("\n"), 1, err)

    def test_what_cannot_be_opened_is_named_with_its_remedy(self):
        self.assert_error(5, "monitor", "serial:/dev/ttyNOSUCH9", "--for", "1", says="there is no")
        self.assert_error(5, "monitor", "serial:" + os.path.abspath(__file__), "--for", "1", says="is no serial port")
        self.assert_error(2, "monitor", "serial:" + self.path + "?speed=5", "--for", "1", says="unknown option")
        self.assert_error(2, "monitor", "pty:./tty0", "--for", "1", says="open that terminal as serial:./tty0")

    def test_a_port_in_use_is_named(self):
        process = self.start("monitor", "serial:" + self.path)
        self.feed_until_read(process, b"\x55")
        self.assert_error(5, "monitor", "serial:" + self.path, "--for", "1", says="in use by another program")
        process.terminate()
        process.communicate(timeout=contract.LIMIT)

    def test_bytes_that_do_not_parse_are_bad_input(self):
        self.assert_error(2, "decode", text="(1.5) ttyUSB0 tx 5\n")

    def test_simulate_wants_a_family_of_serial_lines_on_a_terminal(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "tty0")
            self.assert_error(2, "simulate", "--on", "pty:" + path, "dmc60c:5", says="a link of the kind can")
            self.assert_error(2, "simulate", "--on", "pty:" + path + "?baud=fast", "dmc60c:5", says="baud=BITS_PER_SECOND")
            self.assertEqual(os.listdir(folder), [])

    def serial_family(self):
        """A unit of the first family that lives on sim:serial, if this build has one."""
        run = contract.Run(["--json", "scan", "sim:serial"])
        rows = json.loads(run.out)["devices"] if run.status == 0 else []
        return rows[0] if rows else None

    def test_simulated_devices_answer_another_program_through_a_terminal(self):
        row = self.serial_family()
        if not row:
            self.skipTest("no family of this build lives on serial lines")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "tty0")
            os.symlink("/dev/pts/99999", path)
            unit = f"{row['family']}:{row['address']}"
            process = self.start("simulate", "--on", "pty:" + path, unit)
            self.assertEqual(json.loads(process.stdout.readline()), {"ready": True, "links": ["pty:" + path]})
            for baud in (9600, 57600, 115200):
                device = f"serial:{path}?baud={baud}/{unit}"
                self.assertEqual(self.run_one("info", device)["device"], device)
            process.terminate()
            process.communicate(timeout=contract.LIMIT)
            self.assertEqual(process.returncode, 0)
            self.assertEqual(os.listdir(folder), [])
