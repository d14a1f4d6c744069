# SPDX-License-Identifier: GPL-3.0-or-later
"""Full disks, pipes that nobody reads, paths that somebody else uses, files that are none."""
import array
import fcntl
import json
import os
import resource
import select
import signal
import stat
import subprocess
import tempfile
import termios
import threading
import time

import contract
from contract import CIM, EMPTY, ContractTest, Run

SMALL = 4096  # of a pipe; the kernel's least


def filled(pipe, enough):
    """Waits until so many bytes wait in a pipe."""
    count = array.array("i", [0])
    while count[0] < enough:
        select.select([pipe], [], [], contract.LIMIT)
        fcntl.ioctl(pipe, termios.FIONREAD, count)


def contents(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def last_note(process):
    """The line about the samples; what the device told of itself comes before it."""
    line = process.stderr.readline()
    while line and "samples" not in line:
        line = process.stderr.readline()
    return line


class Hostile(ContractTest):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name, text=None):
        path = os.path.join(self.folder.name, name)
        if text is not None:
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
        return path

    def start(self, *arguments, json_too=False):
        """A program whose standard output is a small pipe; nobody reads it yet."""
        process = subprocess.Popen([contract.PROGRAM, *(["--json"] if json_too else []), *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        fcntl.fcntl(process.stdout, fcntl.F_SETPIPE_SZ, SMALL)
        return process

    def test_a_motor_is_driven_to_its_end_though_nobody_reads_the_samples(self):
        process = self.start("drive", CIM, "--mode", "duty", "--target", "0.2", "--for", "2")
        filled(process.stdout, SMALL - 512)
        self.assertRegex(last_note(process), r"\d+ samples, stopped, done")
        out, err = process.communicate(timeout=contract.LIMIT)
        self.assertEqual((process.returncode, err), (0, ""))
        self.assertGreater(len(out), 2 * SMALL)
        self.assertTrue(out.startswith("t,channel,value,unit\n") and out.endswith("\n"))

    def test_a_signal_ends_what_nobody_reads(self):
        for number in (signal.SIGTERM, signal.SIGINT):
            process = self.start("watch", CIM, "--rate", "100")
            filled(process.stdout, SMALL - 512)
            process.send_signal(number)
            self.assertIn(process.wait(timeout=contract.LIMIT), (0, 1))

    def test_output_that_was_not_read_to_its_end_is_no_success(self):
        process = self.start("parameters", "dmc60c")  # more than the pipe holds, at once
        filled(process.stdout, SMALL)
        process.terminate()
        self.assertEqual(process.wait(timeout=contract.LIMIT), 1)
        self.assertIn("standard output was not read", process.stderr.read())

    def test_a_motor_stops_on_a_signal_though_nobody_reads_the_samples(self):
        process = self.start("drive", CIM, "--mode", "duty", "--target", "0.2", "--for", "60")
        filled(process.stdout, SMALL - 512)
        process.send_signal(signal.SIGTERM)
        self.assertRegex(last_note(process), r"\d+ samples, stopped, interrupted")
        process.communicate(timeout=contract.LIMIT)

    def test_a_closed_standard_output_is_told_and_its_number_is_nobody_elses(self):
        data = self.path("data")
        os.mkdir(data)
        for call in (["get", CIM], ["--json", "snapshot", CIM], ["trials"], ["parameters", "dmc60c"], ["help"], ["watch", CIM, "--for", "0.2"]):
            with self.subTest(call=call):
                done = subprocess.run([contract.PROGRAM, *call], stderr=subprocess.PIPE, text=True, check=False, preexec_fn=lambda: os.close(1),
                                      env=dict(os.environ, XDG_DATA_HOME=data), timeout=contract.LIMIT)
                self.assertEqual(done.returncode, 1, done.stderr)
                self.assertIn("standard output cannot be written: Bad file descriptor", done.stderr)
        self.assertEqual(len(Run(["--json", "snapshots"], environment=dict(os.environ, XDG_DATA_HOME=data)).objects()[0]["snapshots"]), 1)

    def test_a_data_folder_that_is_not_absolute_counts_as_not_set(self):
        home = self.path("home")
        os.mkdir(home)
        environment = dict(os.environ, HOME=home, XDG_DATA_HOME="here", XDG_CACHE_HOME="here", XDG_CONFIG_HOME="here")
        done = subprocess.run([contract.PROGRAM, "snapshot", CIM], capture_output=True, text=True, check=False, cwd=self.folder.name, env=environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(os.listdir(self.folder.name), ["home"])
        self.assertTrue(os.path.exists(os.path.join(home, ".local", "share", "motorbench", "motorbench.db")))

    def test_an_old_backup_survives_a_full_disk(self):
        path = self.path("backup.json", "precious")

        def small():
            resource.setrlimit(resource.RLIMIT_FSIZE, (1024, 1024))

        done = subprocess.run([contract.PROGRAM, "get", CIM, "--file", path], capture_output=True, text=True, check=False, preexec_fn=small)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertNotIn("saved", done.stderr)
        self.assertIn("greatest size", done.stderr)
        with open(path, encoding="utf-8") as file:
            self.assertEqual(file.read(), "precious")
        self.assertEqual(os.listdir(self.folder.name), ["backup.json"])

    def test_a_disk_that_is_full_at_once_is_told(self):
        run = Run(["get", CIM, "slot0.p", "--file", "/dev/full"])
        self.assertEqual((run.status, run.out), (1, ""))
        self.assertIn("the disk is full", run.err)

    def test_special_files_are_written_to_and_stay(self):
        self.run_text("get", CIM, "slot0.p", "--file", "/dev/null")
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/null").st_mode))
        pipe = self.path("pipe")
        os.mkfifo(pipe)
        heard = []
        reader = threading.Thread(target=lambda: heard.append(contents(pipe)))
        reader.start()
        with open(pipe, "w", encoding="utf-8"):  # the reader is there
            self.run_text("get", CIM, "slot0.p", "--file", pipe)
        reader.join()
        self.assertIn("slot0.p", json.loads(heard[0])["parameters"])

    def test_a_file_named_minus_is_standard_output(self):
        text = self.run_text("get", CIM, "slot0.p", "--file", "-")
        self.assertIn("slot0.p", json.loads(text)["parameters"])
        self.assertFalse(os.path.exists("-"))

    def test_help_that_cannot_be_written_is_no_success(self):
        for words in (["--help"], ["--version"], ["scan", "--help"], ["help"], ["completion", "bash"]):
            with open("/dev/full", "w", encoding="utf-8") as full:
                done = subprocess.run([contract.PROGRAM, *words], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
            self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), words)

    def test_files_that_are_none_are_refused_at_once(self):
        pipe = self.path("pipe")
        os.mkfifo(pipe)
        for name in (pipe, "/dev/zero", self.folder.name):
            self.assert_error(2, "restore", CIM, name, says=name)
            self.assert_error(2, "flash", CIM, name, says=name)
        self.assert_error(2, "plot", "/dev/zero", "--out", self.path("a.png"), says="/dev/zero")

    def test_plot_listens_to_signals(self):
        pipe = self.path("pipe.csv")
        os.mkfifo(pipe)
        for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT):
            before = signal.signal(signal.SIGINT, signal.SIG_IGN)  # as a script's `plot … &` finds it
            process = self.start("plot", pipe, "--out", self.path("a.png"), json_too=True)
            signal.signal(signal.SIGINT, before)
            with open(pipe, "w", encoding="utf-8"):  # it has begun to read
                process.send_signal(number)
                out, err = process.communicate(timeout=contract.LIMIT)
            self.assertEqual((process.returncode, out, err.count("\n")), (1, "", 1), err)
            self.assertEqual(json.loads(err)["error"]["fault"], "cancelled")

    def test_a_good_link_is_shown_though_another_fails(self):
        run = Run(["--json", "scan", "sim:can", "socketcan:nosuchcan0"])
        self.assertEqual(run.status, 5, run.err)
        self.error_of(run, 5)
        (found,) = run.objects()
        self.assertIn(CIM, [row["device"] for row in found["devices"]])
        self.assertIn("socketcan:nosuchcan0", [row["link"] for row in found["links"]])

    def test_a_path_that_is_served_is_not_stolen(self):
        for link, device in ((f"pty:{self.path('tty')}", "supermodified:4"), (f"unix:{self.path('board')}", "quadquad2drv:0")):
            first = subprocess.Popen([contract.PROGRAM, "simulate", "--on", link, device], stdout=subprocess.PIPE, text=True)
            try:
                self.assertIn("ready", first.stdout.readline())
                self.assert_error(5, "simulate", "--on", link, device, "--for", "1", says="served")
            finally:
                first.kill()
                first.communicate()
            again = Run(["simulate", "--on", link, device, "--for", "0.1"])
            self.assertEqual(again.status, 0, f"what a killed one left is replaced: {again.err}")

    def test_a_socket_carries_one_board(self):
        link = f"unix:{self.path('board')}"
        self.assert_error(2, "simulate", "--on", link, "quadquad2drv:0", "quadquad2drv:0", says="one board")
        self.assert_error(2, "simulate", "--on", link, "quadquad2drv:0", "--on", link, "quadquad2drv:0", says="one board")

    def test_an_edited_value_beside_its_raw_value_is_not_overlooked(self):
        path = self.path("saved.json")
        self.run_text("get", CIM, "slot0.p", "--file", path)
        with open(path, encoding="utf-8") as file:
            saved = json.load(file)
        for edit in ({"value": 1.5}, {"raw": "abc"}, {"value": "abc"}):
            row = dict(saved["parameters"]["slot0.p"], **edit)
            self.path("saved.json", json.dumps(dict(saved, parameters={"slot0.p": row})))
            self.assert_error(2, "restore", CIM, path, says="slot0.p")

    def test_what_belongs_to_another_unit_is_left_out_unless_asked_for(self):
        path = self.path("saved.json")
        self.run_text("get", "sim:can/dmc60c:7", "current.adc_multiplier", "slot0.p", "--file", path)
        with open(path, encoding="utf-8") as file:
            saved = json.load(file)
        saved["serial"] = "of another unit"
        saved["parameters"]["current.adc_multiplier"] = {"raw": 2100}
        self.path("saved.json", json.dumps(saved))
        run = Run(["--json", "restore", CIM, path, "--dry-run"])
        self.assertEqual(run.status, 0, run.err)
        self.assertNotIn("current.adc_multiplier", [row["key"] for row in run.objects()[0]["changes"]])
        self.assertIn("of another unit", run.err)
        self.assertIn("current.adc_multiplier belongs", run.err)
        asked = self.run_one("restore", CIM, path, "--dry-run", "--unit-values", "current.adc_multiplier")
        self.assertIn("current.adc_multiplier", [row["key"] for row in asked["changes"]])

    def test_bash_completes_from_the_tables_of_the_program(self):
        script = self.run_text("completion", "bash")

        def words(line):
            text = script + 'COMP_LINE=$1 COMP_POINT=${#1}\nCOMP_WORDBREAKS=" "\n_motorbenchctl\nprintf "%s\\n" "${COMPREPLY[@]}"\n'
            done = subprocess.run(["bash", "-c", text, "bash", line], capture_output=True, text=True, check=True)
            self.assertEqual(done.stderr, "")
            return done.stdout.split()

        self.assertEqual(words("motorbenchctl sca"), ["scan"])
        self.assertEqual(words("motorbenchctl --timeout 2 comp"), ["completion"])
        self.assertEqual(words("motorbenchctl parameters d"), ["dmc60c"])
        self.assertIn("slot0.p", words(f"motorbenchctl get {CIM} slot0."))
        self.assertIn("velocity", words(f"motorbenchctl drive {CIM} --mode "))
        self.assertEqual(words("motorbenchctl set --sto"), ["--store"])
        self.assertEqual(words(f"motorbenchctl tune {CIM} --loop "), ["velocity", "position", "current"])
        self.assertEqual(words(f"motorbenchctl tune {CIM} --aim b"), ["brisk"])
        self.assertEqual(words(f"motorbenchctl step {CIM} --profile s"), ["step", "square", "sine"])
        self.assertEqual(words(f"motorbenchctl report {CIM} --size "), ["report", "card", "label"])
        self.assertEqual(words("motorbenchctl plot a.csv --size "), [])
        self.assertIn("LL", words("motorbenchctl decode a.log --dialect "))
        for line in ("motorbenchctl diff ", f"motorbenchctl diff {CIM} "):
            self.assertIn("defaults", words(line))
            self.assertIn("sim:can", words(line))
        file = self.path("settings.json")
        open(file, "w", encoding="utf-8").close()
        self.assertEqual(words(f"motorbenchctl diff {CIM} {file[:-3]}"), [file])
        for shell in ("zsh", "fish"):
            text = self.run_text("completion", shell)
            for word in ("simulate", "velocity", "slot0.p", "dry-run", "brisk", "chirp", "label", "LL", "snapshot:"):
                self.assertIn(word, text)
        self.assert_error(2, "completion", "tcsh", says="bash, zsh and fish")

    def test_a_unit_in_its_bootloader_is_the_same_to_every_verb(self):
        saved = self.path("saved.json")
        self.run_text("get", CIM, "slot0.p", "--file", saved)
        for words in (["get", EMPTY], ["set", EMPTY, "slot0.p=1"], ["restore", EMPTY, saved], ["drive", EMPTY, "--mode", "duty", "--target", "0.1", "--for", "1"],
                      ["step", EMPTY, "--mode", "velocity", "--to", "1000"], ["identify", EMPTY], ["tune", EMPTY, "--loop", "velocity"]):
            self.assert_error(1, *words, says="bootloader")

    def test_one_value_that_cannot_be_written_is_wrong_usage_of_all(self):
        node = "sim:serial/supermodified:4"  # dialect D1, which has no reaction to errors
        drive = "sim:can/abstractdc:3"
        for unit, wrong, says in ((node, "frob=1", "frob"), (node, "error.reaction=1", "error.reaction does not exist"), (node, "node.id=5", "choose a free one"),
                                  (drive, "position.divisor=0", "position.divisor: 0 is no divisor")):
            first = "gain.p=900" if unit == node else "velocity.p=3"
            self.assert_error(2, "set", unit, first, wrong, says=says)
            self.assertNotIn("written before", Run(["set", unit, first, wrong]).err)

    def test_identify_asks_before_it_turns_a_shaft(self):
        drive = "sim:can/abstractdc:3"
        self.assert_error(2, "identify", drive, says="--yes")
        self.assert_error(2, "identify", drive, says="turn its shaft by hand")
        self.assertIn("turned to and fro", self.run_text("identify", drive, "--yes"))
        self.assertIn("blinks", self.run_text("identify", CIM))
        for answer, status, says in ((b"n\n", 1, "was not turned"), (b"y\n", 0, "turned to and fro")):
            person, terminal = os.openpty()
            process = subprocess.Popen([contract.PROGRAM, "identify", drive], stdin=terminal, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            os.write(person, b"y\n")  # typed before it is asked, which is no answer
            asked, letter = "", " "
            while letter and not asked.endswith("[y/N] "):
                letter = process.stderr.read(1)
                asked += letter
            os.write(person, answer)
            out, err = process.communicate(timeout=contract.LIMIT)
            os.close(person)
            os.close(terminal)
            self.assertEqual(process.returncode, status, err)
            self.assertIn("Turn the shaft", asked)
            self.assertIn(says, out + err)

    def test_a_signal_ends_a_question_that_nobody_answers(self):
        person, terminal = os.openpty()
        process = subprocess.Popen([contract.PROGRAM, "identify", "sim:can/abstractdc:3"], stdin=terminal, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertIn("Turn the shaft", process.stderr.read(len("abstractdc cannot blink. Turn the shaft")))
        process.send_signal(signal.SIGTERM)
        out, err = process.communicate(timeout=contract.LIMIT)
        os.close(person)
        os.close(terminal)
        self.assertEqual((process.returncode, out), (1, ""), err)
        self.assertIn("interrupted before it was done", err)

    def test_a_signal_ends_a_nudge_between_its_pushes_too(self):
        for seconds in (0.8, 1.0, 1.2, 1.5, 2.0):  # it pushes four times, and rests three times as long; all of it takes 3 s
            status, out, err = self.cut(seconds, "identify", "sim:can/abstractdc:3", "--yes")
            self.assertEqual((status, out), (1, ""), err)
            self.assertIn("interrupted before it was done", err)

    def test_a_signal_in_the_proof_of_flash_says_that_the_values_are_in_force(self):
        status, out, err = self.cut(4, "set", CIM, "slot0.p=0.41", "slot0.i=0.001", "--store")
        self.assertEqual((status, out), (1, ""), err)
        self.assertIn("the values are in force but not proved to be stored", err)
        self.assertIn("interrupted before it was done", err)

    def test_nothing_is_called_written_on_a_disk_that_is_full(self):
        trace = self.path("trace.csv", self.run_text("watch", CIM, "--for", "0.3"))
        first = self.path("first.png")
        self.run_text("plot", trace, "--out", first)  # what fonts there are is kept by then
        os.remove(first)
        step = ["step", CIM, "--mode", "velocity", "--to", "2000", "--time", "0.3"]
        trial = self.run_one(*step)["trial"]

        def small():
            resource.setrlimit(resource.RLIMIT_FSIZE, (16, 16))

        for words in (["plot", trace, "--out"], [*step, "--save"], ["trials", "--export"], ["get", CIM, "--file"]):
            name = "full.png" if words[0] == "plot" else "full.csv"
            path = self.path(name, "precious")
            limits = small if words[0] in ("plot", "get") else None  # the others keep a notebook, which must find room
            target = path if limits else "/dev/full"
            done = subprocess.run([contract.PROGRAM, "--quiet", *words, target], capture_output=True, text=True, check=False, preexec_fn=limits)
            self.assertNotEqual(done.returncode, 0, words)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertIn("greatest size" if limits else "disk is full", done.stderr)
            self.assertEqual(contents(path), "precious")
            os.remove(path)
        self.assertEqual(os.listdir(self.folder.name), ["trace.csv"])
        self.run_text("trials", "--delete", str(trial))

    def test_a_motor_at_rest_is_no_news_to_who_drives_it(self):
        run = Run(["drive", CIM, "--mode", "duty", "--target", "0.1", "--for", "0.3"])
        self.assertEqual(run.status, 0, run.err)
        self.assertNotIn("halted", run.err)
        self.assertIn("halted", Run(["watch", CIM, "--for", "0.2"]).err)

    def test_the_pins_of_an_encoder_are_no_news(self):
        run = Run(["drive", CIM, "--mode", "duty", "--target", "0.3", "--for", "0.5"])
        self.assertEqual(run.status, 0, run.err)
        self.assertEqual([line for line in run.err.splitlines() if line.endswith((": ", ": : over"))], [])

    @contract.long
    def test_every_question_is_asked_as_often_as_one_says(self):
        # Half of all frames are lost: of 31 parameters one is hardly ever read within the eight tries of the family.
        keys = [row["key"] for row in self.run_one("parameters", "dmc60c")["parameters"] if row["group"].startswith(("Loop", "Current"))]
        self.assertGreater(len(keys), 25)
        run = Run(["--json", "--quiet", "--retries=60", "get", "sim:can?loss=0.5/dmc60c:5", *keys])
        self.assertEqual((run.status, run.err), (0, ""))
        self.assertEqual(set(run.objects()[0]["parameters"]), set(keys))

    def test_a_scan_ends_after_its_time_and_lists_who_has_answered(self):
        run = Run(["--json", "--timeout", "0.3", "scan", "sim:serial", "--everything"])
        self.assertEqual(run.status, 0, run.err)
        self.assertIn("cut off after 0.3 s", run.err)
        (found,) = run.objects()
        self.assertEqual([row["link"] for row in found["links"]], ["sim:serial"])

    def test_a_signal_ends_a_long_scan_with_what_it_has_found(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            status, out, err = self.cut(4, "--json", "scan", "sim:can", "sim:serial", "--everything", number=number)
            self.assertEqual(status, 1, err)  # the list is not whole
            found = json.loads(out)
            self.assertIn(CIM, [row["device"] for row in found["devices"]])
            self.assertEqual({row["link"] for row in found["links"]}, {"sim:can", "sim:serial"})
            self.assertEqual(json.loads(err.splitlines()[-1])["error"]["fault"], "cancelled")

    def test_how_long_and_how_often_a_device_is_looked_for(self):
        nobody = "sim:can/dmc60c:60"
        self.assert_error(3, "--timeout", "0.05", "info", nobody, says="within 0.05 s")
        self.assert_error(3, "info", nobody, "--timeout=0.05", "--retries", "1", says="within 0.05 s")
        self.assertEqual(Run(["--timeout=30", "--retries=2", "get", CIM, "slot0.p"]).status, 0)
        for wrong in (["--timeout", "0"], ["--timeout=soon"], ["--retries", "-1"], ["--retries", "1.5"], ["--timeout"]):
            self.assert_error(2, *wrong, "info", nobody)
