# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrong calls of every kind, help, and what the program is linked with."""
import re
import subprocess

import contract
from contract import CIM, ContractTest, Run

VERBS = "service journal links scan info parameters get set restore snapshot snapshots diff watch drive flash identify number rename monitor decode plot simulate help completion".split()


class Usage(ContractTest):
    def test_links_no_screen(self):
        libraries = subprocess.run(["ldd", contract.PROGRAM], capture_output=True, text=True, check=True).stdout
        self.assertIn("Qt5Core", libraries)
        for forbidden in ("Qt5Gui", "Qt5Widgets", "Qt5PrintSupport", "qcustomplot"):
            self.assertNotIn(forbidden.lower(), libraries.lower())

    def test_help_of_the_program_names_every_verb(self):
        text = self.run_text("--help")
        for verb in VERBS:
            self.assertIn(f"\n  {verb} ", text)
        self.assertRegex(self.run_text("--version"), r"^motorbenchctl \d+\.\d+\.\d+\n$")

    def test_with_json_help_and_version_are_json(self):
        self.assertEqual(self.run_one("--help"), self.run_one("help"))
        self.assertEqual(Run(["--help", "--json"]).objects(), [self.run_one("help")])
        self.assertEqual(self.run_one("scan", "--help"), self.run_one("help", "scan"))
        version = self.run_one("--version")
        self.assertEqual("motorbenchctl " + version.pop("version") + "\n", self.run_text("--version"))
        self.assertEqual(version, {})

    def test_help_of_every_verb_succeeds(self):
        for verb in VERBS:
            with self.subTest(verb):
                self.assertIn("--json", self.run_text(verb, "--help"))

    def test_json_and_quiet_stand_before_or_after_the_verb(self):
        before = Run(["--json", "--quiet", "parameters", "dmc60c"])
        after = Run(["parameters", "dmc60c", "--json", "--quiet"])
        self.assertEqual((before.status, before.out), (0, after.out))
        self.assertEqual(len(after.objects()), 1)

    def test_unknown_words_are_wrong_usage(self):
        self.assert_error(2, says="verb")
        self.assert_error(2, "frobnicate", says="frobnicate")
        self.assert_error(2, "scna", says="did you mean scan?")
        self.assert_error(2, "tune", CIM)
        self.assert_error(2, "drive", CIM, "--mode", "velocity", "--target", "10", "--velocity", "10", "--for", "1", says="profile")
        self.assert_error(2, "set", "sim:spi/quadquad2drv:0", "history.length=8", "--store", says="without power")
        self.assert_error(2, "simulate", "--on", "pty:./a", "supermodified:4", "--on", "pty:./a", "supermodified:5", says="named twice")
        self.assert_error(2, "--frobnicate", "scan", says="--frobnicate")
        self.assert_error(2, "scan", "--frobnicate", says="--frobnicate")
        self.assert_error(2, "watch", CIM, "--chanel", "position", says="did you mean --channel?")
        self.assert_error(2, "info", CIM, "more", says="more")
        self.assert_error(2, "info", says="device")
        self.assert_error(2, "watch", CIM, "--for", says="--for")

    def test_wrong_links_are_wrong_usage(self):
        for link in ("can0", "bogus:x", "sim:lin", "sim:can?loss", "sim:can?loss=2", "sim:can?loss=0,1", "sim:can?loss=nan", "sim:can?seed=1.5", "sim:can?fault=drop@1,5", "sim:can?frob=1", "sim:can?fault=frob", "socketcan:", ":", ""):
            self.assert_error(2, "scan", link)
            self.assert_error(2, "monitor", link, "--for", "1")

    def test_an_option_of_a_link_that_is_no_value_or_there_twice_is_wrong_usage(self):
        for link, says in (("sim:can?seed=1&seed=2", "twice"), ("socketcan:can0?bitrate=1&bitrate=1", "twice"), ("replay:a.log?speed=0", "speed=0"),
                           ("unix:a?pace=2", "option 'pace'"), ("sim:can?bitrate=0", "bitrate=0")):
            for call in (("scan", link), ("scan", "sim:can", link), ("monitor", link, "--for", "1")):
                self.assert_error(2, *call, says=says)
        self.assert_error(2, "watch", "replay:a.log?speed=0/dmc60c:5", says="speed=0")
        self.assert_error(2, "get", "sim:can?loss=0&loss=0/dmc60c:5", says="twice")
        self.assert_error(2, "simulate", "--on", "unix:a?pace=2", "quadquad2drv:0", says="pace=2")
        self.assert_error(2, "simulate", "--on", "unix:a?speed=1", "quadquad2drv:0", says="no option 'speed'")
        self.assert_error(2, "simulate", "--on", "pty:a?baud=9600&baud=9600", "supermodified:4", says="twice")

    def test_wrong_devices_are_wrong_usage(self):
        for device in ("5", "dmc60c:5", "sim:can/dmc60c", "sim:can/dmc60c:", "sim:can/dmc60c:x", "sim:can/dmc60c:-1", "sim:can/:5", "sim:can/dmc60c:5@xyz",
                       "sim:serial/dmc60c:5", "sim:can/dmc60c:64", "sim:can/abstractdc:100", "sim:serial/supermodified:0", "sim:serial/supermodified:128", "sim:spi/quadquad2drv:1"):
            self.assert_error(2, "info", device)
        self.assert_error(2, "info", "sim:can/dmc60d:5", says="did you mean dmc60c?")
        self.assert_error(2, "parameters", "frobnicator", says="dmc60c")

    @contract.long
    def test_a_device_that_is_not_there_does_not_answer(self):
        for call in (("info",), ("get",), ("set", "slot0.p=1"), ("watch",), ("drive", "--mode", "duty", "--target", "0", "--for", "1"), ("number", "6"),
                     ("rename", "x"), ("identify",)):
            self.assert_error(3, call[0], "sim:can/dmc60c:60", *call[1:], says="60")
        self.assert_error(3, "info", "sim:can/dmc60c:5@0001")

    def test_a_link_that_cannot_be_opened(self):
        self.assert_error(5, "scan", "socketcan:nosuchcan0")
        self.assert_error(5, "get", "socketcan:nosuchcan0/dmc60c:5")
        self.assert_error(5, "monitor", "socketcan:nosuchcan0", "--for", "1")
        self.assert_error(5, "simulate", "--on", "socketcan:nosuchcan0", "dmc60c:5")
        self.assert_error(5, "scan", "sim:can?fault=busoff@0.1", says="bus-off")

    def test_wrong_values_are_refused_before_anything_is_sent(self):
        # A device that does not answer would end with 3: these calls never come that far.
        nobody = "sim:can/dmc60c:60"
        self.assert_error(2, "get", nobody, "slot0.frob", says="slot0")
        self.assert_error(2, "get", nobody, "slot0.pp", says="did you mean slot0.p?")
        for wrong in ("slot0.p", "=1", "slot0.p=", "slot0.p=abc", "slot0.p=1e9", "slot0.p=nan", "faults.active=0", "frob=1",
                      "limit.forward.soft.enabled=maybe", "limit.forward.soft.threshold=0.5"):
            self.assert_error(2, "set", nobody, "slot0.i=0", wrong)
        self.assert_error(2, "set", nobody, "slot0.p=1", "slot0.p=1", says="twice")
        self.assert_error(2, "set", nobody)
        self.assert_error(2, "watch", nobody, "--channel", "speed", says="velocity")
        for span in ("0", "-1", "abc", "1s", "nan", "inf", "1e30", ""):
            self.assert_error(2, "watch", nobody, f"--for={span}" if span else "--for=")
        for rate in ("0", "-5", "x", "1e9"):
            self.assert_error(2, "watch", nobody, "--rate", rate)
        self.assert_error(2, "number", nobody, "six")
        self.assert_error(2, "number", nobody, "1.5")
        self.assert_error(2, "number", nobody, "70000")
        self.assert_error(2, "rename", nobody, "")
        self.assert_error(2, "rename", nobody, "x" * 65)

    def test_wrong_motions_are_refused_before_anything_is_sent(self):
        nobody = "sim:can/dmc60c:60"

        def drive(*arguments, says=""):
            self.assert_error(2, "drive", nobody, *arguments, says=says)

        drive("--mode", "fly", "--target", "1", "--for", "1", says="velocity")
        drive("--mode", "ramp-position", "--target", "1", "--for", "1")
        drive("--mode", "duty", "--target", "1.5", "--for", "1")
        drive("--mode", "duty", "--target", "-1.5", "--for", "1")
        drive("--mode", "duty", "--target", "nan", "--for", "1")
        drive("--mode", "follow", "--target", "999", "--for", "1")
        drive("--mode", "duty", "--for", "1", says="--target")
        drive("--mode", "duty", "--target", "0.1", says="--for")
        drive("--target", "0.1", "--for", "1", says="--mode")
        drive("--mode", "duty", "--target", "0.1", "--for", "0")
        for device in ("sim:can/dmc60c:60", "sim:can/abstractdc:40", "sim:serial/supermodified:9", "sim:spi/quadquad2drv:0"):
            self.assert_error(2, "drive", device, "--mode", "position", "--target", "0.5", "--for", "1", says="not a whole number")
            for wrong in (("--to", "0.5"), ("--to", "100", "--from", "-0.5")):
                self.assert_error(2, "step", device, "--mode", "position", *wrong, says="not a whole number")
        drive("--mode", "duty", "--target", "0.1", "--for", "1", "--axis", "2")
        drive("--mode", "velocity", "--target", "1", "--for", "1", "--slot", "2")
        drive("--mode", "duty", "--target", "0.1", "--for", "1", "--brake", "--coast")
        for slew in ("0", "-0", "0.0"):
            drive("--mode", "velocity", "--target", "10", "--for", "1", "--slew", slew, says="--slew")
        drive("--mode", "off", "--target", "5", "--for", "1", says="off")

    def test_a_limit_of_an_experiment_is_above_0(self):
        for verb in (("step", "--mode", "position", "--to", "1500"), ("tune", "--loop", "velocity")):
            for limit in ("--travel", "--speed", "--current", "--duty"):
                for value in ("=0", "=-1", "=1e15"):  # in the words of a recipe
                    self.assert_error(2, verb[0], "sim:can/dmc60c:60", *verb[1:], limit + value, says=f"{limit}: '{limit[2:]}' must be above 0 and at most ")

    def test_wrong_files_are_wrong_usage(self):
        for verb in ("restore", "flash"):
            self.assert_error(2, verb, CIM, "/nonexistent/file", says="/nonexistent/file")
            self.assert_error(2, verb, CIM, contract.SOURCE)
            self.assert_error(2, verb, CIM, f"{contract.SOURCE}/CMakeLists.txt")
            self.assert_error(2, verb, CIM, "/dev/null")
            self.assert_error(2, verb, CIM)
        self.assert_error(2, "get", CIM, "slot0.p", "--file", "/nonexistent/file")
        self.assert_error(2, "flash", CIM, f"{contract.SOURCE}/resources/firmware/dmc60c-demo.hex", "--target", "f9")
        for options in ([], ["--dry-run"]):
            self.assert_error(2, "flash", CIM, f"{contract.SOURCE}/resources/firmware/dmc60c-demo.hex", "--target", "f4", *options, says="one kind of chip")

    def test_wrong_simulations_are_wrong_usage(self):
        self.assert_error(2, "simulate")
        self.assert_error(2, "simulate", "dmc60c:5")
        self.assert_error(2, "simulate", "--on", "socketcan:vcan0")
        self.assert_error(2, "simulate", "--on", "sim:can", "dmc60c:5")
        for unit in ("dmc60c", "dmc60c:x", "frob:5", "dmc60c:64", "dmc60c:5,motor", "dmc60c:5,motor=frob", "dmc60c:5,frob=1", "dmc60c:5,fault=frob", "dmc60c:5,load=x", "dmc60c:5,load=nan", "dmc60c:5,fault=drop@inf", "dmc60c:5,fault=drop@99999999999999999999", "dmc60c:5,fault=reset@1e30", "dmc60c:5,fault=delay@1:1e30"):
            self.assert_error(2, "simulate", "--on", "socketcan:vcan0", unit)
        self.assert_error(2, "simulate", "--on", "socketcan:vcan0", "dmc60c:5", "--seed", "x")

    def test_what_is_there_twice_or_lacks_a_value_is_told_in_words_of_this_program(self):
        for words in (["watch", CIM, "--for", "1", "--for", "2"], ["--timeout", "1", "--timeout", "2", "links"], ["--timeout=1", "links", "--timeout", "2"], ["--retries", "1", "links", "--retries=2"], ["--retries=1", "--retries=1", "links"],
                      ["trials", "--note", "1", "a", "--note", "1", "b"], ["simulate", "--on", "pty:./a", "supermodified:4,dialect=D1,dialect=D2"]):
            self.assert_error(2, *words, says="is there twice")
        self.assert_error(2, "trials", "--note", "1", says="a value of --note is missing")
        self.assert_error(2, "simulate", "--on", says="a value of --on is missing")
        self.assertTrue(Run(["links", "extra"]).err.endswith("the usage is motorbenchctl links\n"))

    def test_a_wrong_value_is_told_with_what_is_legal(self):
        for unit, says in (("supermodified:4,level=2", "docs/bench.md"), ("supermodified:4,frob=2", "docs/bench.md"), ("supermodified:4,fault=foo", "delay@N:MS"),
                           ("supermodified:4,fault=delay@3", "legal is delay@N:MS")):
            self.assert_error(2, "simulate", "--on", "pty:./a", unit, says=says)
        self.assert_error(2, "simulate", "--on", "unix:./a", "quadquad2drv:0,jumper=open", says="boot=")
        self.assert_error(2, "simulate", "--on", "socketcan:vcan0", "dmc60c:5,fault=power-page@31", says="0 … 30")
        for link, says in (("sim:can?loss=2", "below 1"), ("sim:can?bitrate=7", "legal is"), ("serial:./a?format=9N1", "8O1"), ("serial:./a?baud=x", "legal is 50 … ")):
            self.assert_error(2, "monitor", link, "--for", "1", says=says)

    def test_what_contradicts_itself_or_does_nothing_is_wrong_usage(self):
        image = f"{contract.SOURCE}/resources/firmware/dmc60c-demo.hex"
        self.assert_error(2, "step", CIM, "--mode", "velocity", "--to", "10", "--keep", says="--set")
        self.assert_error(2, "trials", "--star", "1", "--delete", "1", says="nothing to mark")
        self.assert_error(2, "restore", CIM, image, "--unit-values", "slot0.p", says="belongs to no unit")
        for way in (["openocd:stlink?target=f1", "--target", "f4"], ["openocd:stlink?target=f7"]):
            self.assert_error(2, "flash", "sim:can/abstractdc:3", image, "--via", *way, says="--target")
        self.assert_error(2, "diff", "sim:can/abstractdc:3", CIM, says="Abstract DC and DMC60C have different")

    def test_a_closed_standard_input_is_called_so(self):
        done = subprocess.run(["bash", "-c", '"$0" decode <&-', contract.PROGRAM], stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1))
        self.assertIn("it is closed", done.stderr)

    def test_a_full_disk_is_told(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = subprocess.run([contract.PROGRAM, "parameters", "dmc60c"], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr.count("\n"), 1)

    def test_a_flag_takes_no_value(self):
        self.assert_error(2, "set", CIM, "slot0.p=1", "--store=3", says="--store takes no value")
        self.assert_error(2, "set", CIM, "slot0.p=1", "--json=1", says="--json takes no value")
        for value in ("1", "0", "true", "false", "yes", ""):
            self.assert_error(2, "tune", CIM, "--loop", "velocity", "--propose=" + value, says="--propose takes no value")

    def test_no_option_takes_an_empty_value_for_one_that_is_not_given(self):
        nobody, hexadecimal = "sim:can/dmc60c:60", f"{contract.SOURCE}/resources/firmware/dmc60c-demo.hex"
        words = {"parameters": ["dmc60c"], "set": [nobody, "slot0.p=1"], "restore": [nobody, hexadecimal], "flash": [nobody, hexadecimal], "diff": ["defaults", "defaults"],
                 "drive": [nobody, "--mode=velocity", "--target=1", "--for=1"], "step": [nobody, "--mode=velocity", "--to=1"], "tune": [nobody, "--loop=velocity"],
                 "service": [hexadecimal], "report": [nobody], "number": [nobody, "6"], "rename": [nobody, "x"], "monitor": ["sim:can"], "plot": [hexadecimal, "--out=x.png"],
                 "simulate": ["--on=pty:./never", "supermodified:4"], "completion": ["bash"]}
        none = {verb: [] for verb in ("links", "scan", "snapshots", "trials", "journal", "decode", "help")}
        for verb in sorted({*VERBS, "step", "tune", "trials", "report", "restart"}):
            given = words.get(verb, none.get(verb, [nobody]))
            taking = re.findall(r"^ +(--[a-z-]+) (?!x )[A-Z]", self.run_text("help", verb), re.MULTILINE)
            self.assertLessEqual({"--timeout", "--retries"}, set(taking))
            for option in taking:
                self.assert_error(2, verb, *[each for each in given if not each.startswith(option + "=")], f"{option}=", says=option)
                if (verb, option) != ("trials", "--note"):
                    self.assert_error(2, verb, *[each for each in given if not each.startswith(option + "=")], option, "", says=option)
        self.assert_error(2, "drive", CIM, "--mode", "duty", "--target", "0", "--for", "1", "--limit-override=", says="--limit-override")
        self.assert_error(2, "step", CIM, "--mode", "velocity", "--to", "1", "--speed=", "--current", "5", says="--speed")
        self.assert_error(2, "trials", "--note", "", "text", says="--note")
        self.assert_error(2, "trials", "", says="device")
        self.assert_error(2, "--timeout", "", "links", says="--timeout")
        self.assert_error(2, "--retries=", "links", says="--retries")
