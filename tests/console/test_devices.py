# SPDX-License-Identifier: GPL-3.0-or-later
"""Verbs that find, read, set up and update devices."""
import json
import os
import signal
import subprocess
import tempfile

import contract
from contract import CIM, EMPTY, LINK_ROW, SCAN_ROW, ContractTest, Run

PARAMETER_ROW = {"key", "id", "label", "group", "type", "unit", "min", "max", "default", "access", "persistent"}
VALUE = {"value", "raw", "unit", "state"}
GET = {"device", "family", "serial", "firmware", "parameters"}
FLASH = {"result", "from", "to", "pages", "retries", "seconds", "verified", "evidence"}


class DeviceVerbs(ContractTest):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.firmware = f"{contract.SOURCE}/resources/firmware/dmc60c-demo.hex"

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def test_links_are_listed_and_not_opened(self):
        rows = self.run_one("links")["links"]
        self.assertIn("sim:can", [row["link"] for row in rows])
        for row in rows:
            self.assertEqual(set(row), LINK_ROW)
            self.assertIn(row["kind"], ("can", "serial", "spi"))
        self.assertIn("sim:can", self.run_text("links"))

    def test_scan_finds_the_bench(self):
        for link in ("sim:can", "sim:"):
            found = self.run_one("scan", link)
            self.assertEqual(set(found), {"devices", "links"})
            rows = {row["device"]: row for row in found["devices"]}
            self.assertLessEqual({CIM, "sim:can/dmc60c:7", EMPTY}, set(rows))
            for row in rows.values():
                self.assertEqual(set(row), SCAN_ROW)
            for row in found["links"]:
                self.assertEqual(set(row), LINK_ROW)
            self.assertEqual((rows[CIM]["state"], rows[CIM]["address"], rows[CIM]["family"]), ("online", 5, "dmc60c"))
            self.assertIsInstance(rows[CIM]["session"], int)
            self.assertRegex(rows[CIM]["firmware"], r"^\d+\.\d+$")
            self.assertEqual((rows[EMPTY]["state"], rows[EMPTY]["firmware"]), ("bootloader", None))

    def test_scan_without_a_link_opens_no_simulated_one(self):
        found = self.run_one("scan")
        self.assertIn("sim:can", [row["link"] for row in found["links"]])
        self.assertFalse([row for row in found["devices"] if row["device"].startswith("sim:")])

    def test_a_fault_that_only_some_links_can_have_is_theirs(self):
        found = self.run_one("scan", "sim:?fault=duplicate")
        self.assertIn("duplicate", [row["state"] for row in found["devices"]])
        self.assertEqual([row["link"] for row in found["links"]], ["sim:can?fault=duplicate", "sim:serial?fault=duplicate", "sim:spi"])
        self.assert_error(2, "scan", "sim:spi?fault=duplicate", says="no device of sim:spi can have the fault 'duplicate'")
        self.assert_error(2, "scan", "sim:?fault=frob", says="unknown fault 'frob'")

    def test_scan_shows_duplicates_by_session(self):
        rows = self.run_one("scan", "sim:can?fault=duplicate")["devices"]
        fives = [row for row in rows if (row["family"], row["address"]) == ("dmc60c", 5)]
        self.assertEqual([row["state"] for row in fives], ["duplicate", "duplicate"])
        for row in fives:
            self.assertTrue(row["device"].endswith(f"/dmc60c:5@{row['session']:04x}"), row["device"])
        self.assert_error(2, "get", "sim:can?fault=duplicate/dmc60c:5", says="@")

    def test_info_adds_descriptors_faults_and_counters(self):
        row = self.run_one("info", CIM)
        self.assertEqual(set(row), SCAN_ROW | {"descriptors", "faults", "states", "counters"})
        self.assertEqual(set(row["counters"]), {"rx", "tx", "lost", "errors"})
        self.assertEqual(row["descriptors"]["serial"], row["serial"])
        for fault in row["faults"].values():
            self.assertEqual(set(fault), {"active", "sticky", "count"})
        self.assertEqual(self.run_one("info", EMPTY)["state"], "bootloader")
        self.assertIn("firmware", self.run_text("info", CIM))

    def test_parameters_need_no_device(self):
        rows = {row["key"]: row for row in self.run_one("parameters", "dmc60c")["parameters"]}
        self.assertEqual(len(rows), 55)
        for row in rows.values():
            self.assertEqual(set(row), PARAMETER_ROW)
            self.assertIn(row["type"], ("boolean", "integer", "number", "flags"))
            self.assertIn(row["access"], ("ro", "rw", "wo"))
            self.assertLessEqual(row["min"], row["default"])
            self.assertLessEqual(row["default"], row["max"])
        self.assertEqual((rows["slot0.p"]["id"], rows["slot0.p"]["type"]), (10, "number"))
        self.assertIs(rows["limit.forward.soft.enabled"]["default"], False)
        self.assertEqual(rows["faults.active"]["access"], "ro")

    def test_get_reads_everything_by_default(self):
        got = self.run_one("get", CIM)
        self.assertEqual(set(got), GET)
        self.assertEqual((got["device"], got["family"]), (CIM, "dmc60c"))
        self.assertEqual(len(got["parameters"]), 55)
        for value in got["parameters"].values():
            self.assertEqual(set(value), VALUE)
            self.assertIsInstance(value["raw"], int)
        self.assertIsInstance(got["parameters"]["limit.forward.soft.enabled"]["value"], bool)
        gain = got["parameters"]["slot0.p"]
        self.assertAlmostEqual(gain["value"], gain["raw"] / 65536)

    def test_get_reads_what_is_named_and_all_of_it_over_a_bad_bus(self):
        self.assertEqual(set(self.run_one("get", CIM, "slot0.p", "slot1.d")["parameters"]), {"slot0.p", "slot1.d"})
        got = self.run_one("get", "sim:can?loss=0.1/dmc60c:5")["parameters"]
        self.assertEqual((len(got), {value["state"] for value in got.values()} & {"failed", "unknown"}), (55, set()))

    def test_a_device_in_its_bootloader_has_no_parameters(self):
        path = self.path("saved.json")
        self.run_text("get", CIM, "--file", path)
        for call in (("get",), ("set", "slot0.p=1"), ("restore", path), ("drive", "--mode", "duty", "--target", "0.1", "--for", "1")):
            self.assert_error(1, call[0], EMPTY, *call[1:], says="flash")

    def test_a_device_that_falls_silent_is_told_of_after_its_last_samples(self):
        run = Run(["--json", "watch", "sim:can?fault=silent@150/dmc60c:5", "--for", "1.5"])
        self.assertEqual(run.status, 3, run.err)
        self.assertEqual(set(run.objects()[-1]), {"summary"})
        self.assertIn("not heard any more", self.error_of(run, 3))
        *samples, last = run.objects()
        positions = [sample["t"] for sample in samples if sample["channel"] == "position"]
        period = (positions[-1] - positions[0]) / (len(positions) - 1)
        missed = (1.5 - positions[-1]) / period
        lost = last["summary"]["lost"]
        alone = Run(["--json", "watch", "sim:can?fault=silent@150/dmc60c:5", "--channel", "position", "--for", "1.5"]).objects()[-1]["summary"]
        self.assertGreater(missed, 5)
        self.assertGreater(lost, 2 * missed, "position and velocity come in one frame, and others beside it")
        self.assertAlmostEqual(alone["lost"] + alone["samples"], 1.5 / period, delta=2)

    def test_a_raised_rate_that_cannot_be_put_back_is_told_beside_what_went_wrong(self):
        run = Run(["--json", "watch", "sim:can?fault=silent@150/dmc60c:5", "--rate", "500", "--for", "1.5"])
        self.assertEqual(run.status, 3)
        self.assertIn("is not heard any more", run.err)
        self.assertIn("the device's rate was not put back", run.err)

    def test_set_reads_back(self):
        got = self.run_one("set", CIM, "slot0.p=1.5", "limit.forward.soft.enabled=on", "encoder.position=-3")
        self.assertEqual(set(got), GET | {"verified"})
        self.assertIs(got["verified"], True)
        self.assertEqual(got["parameters"]["slot0.p"], {"value": 1.5, "raw": 98304, "unit": got["parameters"]["slot0.p"]["unit"], "state": "ram",
                                                       "verified": True})
        self.assertIs(got["parameters"]["limit.forward.soft.enabled"]["value"], True)
        self.assert_error(2, "set", CIM, "slot0.p=1,500", says="with a dot")

    def test_set_store_proves_that_flash_has_it(self):
        got = self.run_one("set", CIM, "slot0.p=1.5", "--store")
        self.assertEqual((got["verified"], got["parameters"]["slot0.p"]["state"]), (True, "stored"))

    def test_a_saved_file_is_restored(self):
        path = self.path("saved.json")
        self.run_text("get", CIM, "--file", path)
        with open(path, encoding="utf-8") as file:
            saved = json.load(file)
        self.assertEqual(set(saved), GET)
        self.assertEqual(self.run_one("restore", CIM, path), {"changes": []})
        before = saved["parameters"]["slot0.p"]["value"]
        for key, raw in (("slot0.p", 65536), ("encoder.position", 77), ("faults.over_current.count", 3)):
            saved["parameters"][key] = {"raw": raw}
        with open(path, "w", encoding="utf-8") as file:
            json.dump(saved, file)
        change = {"key": "slot0.p", "from": before, "to": 1}
        self.assertEqual(self.run_one("restore", CIM, path, "--dry-run"), {"changes": [dict(change, result="would write")]})
        self.assertEqual(self.run_one("restore", CIM, path), {"changes": [dict(change, result="written")]})
        self.assertIn("slot0.p", self.run_text("restore", CIM, path))

    def test_a_restore_that_fails_in_the_middle_tells_which_key_it_was(self):
        path = self.path("two.json")
        with open(path, "w", encoding="utf-8") as file:  # a P that rises is written after what does not make the loop livelier
            json.dump({"family": "dmc60c", "parameters": {"slot0.p": {"raw": 100000}, "slot0.f": {"raw": 500}}}, file)
        for silent in range(60, 200, 20):  # frames: it may still be read then, or written
            run = Run(["--json", "restore", f"sim:can?fault=silent@{silent}/dmc60c:5", path])
            results = {row["key"]: row["result"] for object_ in run.objects() for row in object_.get("changes", [])}
            if "failed" in results.values():
                break
        self.assertEqual(results, {"slot0.f": "failed", "slot0.p": "unchanged"})
        self.assertIn("slot0.f: no answer", run.err)

    def test_restore_refuses_what_is_not_for_this_device(self):
        path = self.path("other.json")
        for text in ("", "[]", "{}", '{"family":"abstractdc","parameters":{}}', '{"family":"dmc60c"}', '{"family":"dmc60c","parameters":[]}',
                     '{"family":"dmc60c","parameters":{"slot0.p":{"raw":1e12}}}', '{"family":"dmc60c","parameters":{"slot0.p":{"value":"x"}}}'):
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
            self.assert_error(2, "restore", CIM, path, says="other.json")

    def test_flash_writes_verifies_and_says_so(self):
        done = self.run_one("flash", EMPTY, self.firmware)
        self.assertEqual(set(done), FLASH)
        self.assertEqual((done["result"], done["from"], done["to"], done["pages"], done["verified"]), ("done", None, "1.25", 31, True))
        trial = self.run_one("flash", CIM, self.firmware, "--dry-run")
        self.assertEqual((set(trial), trial["from"], trial["pages"], trial["verified"]), (FLASH, "1.23", 0, False))
        self.assert_error(2, "flash", CIM, self.firmware, "--via", "avrdude:usbasp:/dev/ttyUSB0")

    def test_faults_that_are_cleared_are_read_back(self):
        for key in ("faults.sticky", "faults.under_voltage.count"):
            got = self.run_one("set", CIM, f"{key}=1")
            self.assertIs(got["verified"], True)
            self.assertEqual((got["parameters"][key]["value"], got["parameters"][key]["verified"]), (0, True))

    def test_numbers_of_keys_are_decimal(self):
        for text in ("0x10", "0X10", "1e", "1,5", "1.5x", "", "nan", "inf"):
            self.assert_error(2, "set", CIM, f"slot0.p={text}", says="slot0.p")
        self.assert_error(2, "set", CIM, "encoder.position=0x10", says="decimal")

    def test_a_file_with_a_key_that_nobody_knows_is_refused_as_a_whole(self):
        path = self.path("some.json")
        for rows, says in ('{"no.such":{"value":1}}', "no.such"), ('{"slot0.p":{"value":1},"no.such":{}}', "no.such"), ('{"slot0.p":{"valeu":1}}', "valeu"):
            with open(path, "w", encoding="utf-8") as file:
                file.write('{"family":"dmc60c","parameters":' + rows + "}")
            self.assert_error(2, "restore", CIM, path, says=says)
            self.assert_error(2, "diff", path, CIM, says=says)
            self.assert_error(2, "diff", CIM, path, says=says)
            self.assert_error(2, "diff", path, "defaults", says=says)

    @contract.long
    def test_a_flash_that_is_cut_is_not_a_success(self):
        run = Run(["--json", "flash", "sim:can?fault=silent@40/dmc60c:9", self.firmware])
        self.assertIn(run.status, (1, 3))
        result = run.objects()[-1]
        self.assertEqual((result["result"], result["verified"]), ("failed", False))
        self.assertTrue(result["evidence"])

    def test_a_flash_that_is_cancelled_tells_how_far_it_came_and_what_was_there(self):
        with subprocess.Popen([contract.PROGRAM, "--json", "flash", CIM, self.firmware], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
            line = process.stderr.readline()
            while line and not line.startswith("motorbenchctl: Page 2"):
                line = process.stderr.readline()
            process.send_signal(signal.SIGINT)
            out, err = process.communicate(timeout=contract.LIMIT)
        self.assertEqual(process.returncode, 1, err)
        cut = json.loads(out)
        self.assertEqual((cut["result"], cut["from"], cut["to"], cut["verified"]), ("cancelled", "1.23", None, False))
        self.assertIn(cut["pages"], range(3, 31), err)

    @contract.long
    def test_identify_number_and_rename(self):
        self.assertEqual(set(self.run_one("identify", CIM)), {"device", "result"})
        for device in ("sim:can/abstractdc:3", "sim:serial/supermodified:4", "sim:spi/quadquad2drv:0"):
            self.assert_error(2, "identify", device, says="turn its shaft by hand")
            self.assertEqual(self.run_one("identify", device, "--yes"), {"device": device, "result": "nudged"})
        for node in ("4", "5"):  # its short way is the first closed loop of its run
            self.assert_error(4, "identify", f"sim:serial?fault=encoder-reversed/supermodified:{node}", "--yes", says="reversed")
        self.assertEqual(self.run_one("number", CIM, "6"), {"device": "sim:can/dmc60c:6", "old": 5, "new": 6, "verified": True})
        self.assertEqual(self.run_one("rename", CIM, "Left arm"), {"device": CIM, "old": "DMC60C", "new": "Left arm", "verified": True})
        self.assert_error(2, "number", CIM, "7", says="taken")
        for number in ("64", "-1", "0"):
            self.assert_error(2, "number", CIM, number, says="legal is 1 … 63")
        self.assert_error(2, "number", "sim:serial/supermodified:4", "128", says="legal is 1 … 127")
        run = Run(["--json", "rename", CIM, "a name of more than 28 characters"])
        self.assertEqual((run.status, run.err.count("\n")), (0, 1))

    def test_a_name_with_a_line_break_would_break_every_list(self):
        for device in (CIM, "sim:can/abstractdc:3"):  # the one stores its name, the other's is kept on this computer
            for name in ("two\nlines", "a\ttab", "\x1b[31mred"):
                self.assert_error(2, "rename", device, name, says="control character")

    def test_restart_of_a_unit_without_application_says_what_helps(self):
        run = Run(["restart", EMPTY])
        self.assertEqual((run.status, run.err.count("\n")), (1, 1), run.err)
        self.assertIn("update its firmware", run.err)

    def test_restart_tells_that_the_unit_answers_again(self):
        self.assertEqual(self.run_one("restart", CIM), {"device": CIM, "result": "restarted"})
        self.assertEqual(self.run_one("restart", "sim:spi/quadquad2drv:0")["result"], "restarted")
        self.assert_error(2, "restart", "sim:can/abstractdc:3", says="switch it off")

    def test_what_the_system_says_of_an_error_is_english_in_every_locale(self):
        if not os.path.exists("/usr/share/locale/de/LC_MESSAGES/libc.mo"):
            self.skipTest("the C library has no German here: package libc-l10n")
        run = Run(["scan", "serial:/dev/null"], environment=dict(os.environ, LC_ALL="C.UTF-8", LANGUAGE="de"))
        self.assertIn("Inappropriate ioctl for device", run.err)

    def test_text_is_for_people_and_has_a_dot_in_every_locale(self):
        environment = dict(os.environ, LC_ALL="de_DE.UTF-8", LANG="de_DE.UTF-8")
        run = Run(["set", CIM, "slot0.p=1.5"], environment=environment)
        self.assertEqual(run.status, 0)
        self.assertRegex(run.out, r"slot0\.p +1\.5 ")
