# SPDX-License-Identifier: GPL-3.0-or-later
"""A family that cannot be read back, has dialects, and is updated by somebody else's program."""
import os
import tempfile

from contract import ContractTest, Run

F, L, D = (f"sim:can/abstractdc:{offset}" for offset in (3, 4, 5))
HEX = """:020000040800F2
:0C0000000050002009000008FEE700BFCF
:00000001FF
"""


class AbstractDc(ContractTest):
    def test_scan_lists_each_dialect_beside_the_other_family(self):
        rows = {row["device"]: row for row in self.run_one("scan", "sim:can")["devices"]}
        self.assertEqual([rows[device]["dialect"] for device in (F, L, D)], ["F", "L", "D"])
        self.assertEqual(len([row for row in rows.values() if row["family"] == "dmc60c"]), 3)
        self.assertEqual(len(rows), 6)
        self.assertIn("firmware's codes, not the document's", rows[F]["detail"])
        self.assertEqual({row["state"] for row in rows.values() if row["family"] == "abstractdc"}, {"online"})

    def test_set_is_assumed_and_never_verified(self):
        answer = self.run_one("set", F, "velocity.p=1000000", "velocity.divisor=1000000")
        self.assertIsNone(answer["verified"])
        self.assertEqual({row["state"] for row in answer["parameters"].values()}, {"assumed"})
        self.assertEqual([row["verified"] for row in answer["parameters"].values()], [None, None])
        stored = Run(["--json", "set", F, "velocity.p=5", "--store"])
        self.assertEqual(stored.status, 0, stored.err)
        self.assertIn("cannot prove", stored.err)
        self.assert_error(2, "set", F, "velocity.divisor=0", says="divisor")
        self.assert_error(2, "set", F, "current.averaging=501")
        self.assert_error(2, "set", F, "velocity.frob=1")

    def test_get_of_what_cannot_be_read_is_unknown(self):
        answer = self.run_one("get", F)
        self.assertEqual(len(answer["parameters"]), 13)
        for row in answer["parameters"].values():
            self.assertEqual((row["value"], row["state"]), (None, "unknown"))

    def test_drives_of_every_dialect_run_and_are_seen_to_stop(self):
        for device in (F, L, D):
            lines = self.run_json("drive", device, "--mode", "duty", "--target", "0.3", "--for", "0.5")
            self.assertEqual((lines[-1]["stopped"], lines[-1]["reason"]), (True, "done"), device)
            self.assertTrue(any(line["channel"] == "position" and line["value"] > 0 for line in lines[:-1]), device)

    def test_current_is_counts_until_its_scale_is_kept(self):
        units = {line["channel"]: line["unit"] for line in self.run_json("watch", F, "--for", "1.5")[:-1]}
        self.assertEqual((units["position"], units["current"]), ("counts", "counts"))

    def test_keep_wants_keys_of_the_family(self):
        self.assert_error(2, "info", F, "--keep", "frob=1")
        self.assert_error(2, "info", F, "--keep", "counts_per_revolution=-1")
        self.assert_error(2, "info", F, "--keep", "dialect=X")
        row = self.run_one("info", F, "--keep", "counts_per_revolution=2248.9")
        self.assertEqual(row["descriptors"]["counts_per_revolution"], "2248.9")
        forced = Run(["--json", "info", F, "--keep", "dialect=D"])
        self.assertEqual(forced.status, 0, forced.err)
        self.assertIn("full power", forced.err, "what would go wrong")

    def test_decode_gives_a_voltage_log_to_the_drive_that_was_asked_and_names_every_question_of_a_scan(self):
        log = "(1.0) can0 320#00\n(1.1) can0 387#04\n(1.101) can0 680#01000000\n"
        self.assertEqual([(line["message"], line["address"]) for line in self.run_json("decode", text=log)],
                         [("log request", 0), ("log request", 3), ("voltage log", 3)])

    def test_decode_reads_each_dialect(self):
        line = "(1.0) can0 067#0410270000\n"
        self.assertEqual(self.run_json("decode", text=line)[0]["fields"], {"TYPE": 4, "value": 10000})
        self.assertEqual(self.run_json("decode", "--dialect", "D", text=line)[0]["message"], "setpoint")
        legacy = "(1.0) can0 067#0400000064000000\n"
        self.assertIsNone(self.run_json("decode", text=legacy)[0]["family"])
        self.assertEqual(self.run_json("decode", "--dialect", "L", text=legacy)[0]["fields"], {"TYPE": 4, "value": 100})

    def test_flash_names_the_way_in(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "drive.hex")
            with open(path, "w", encoding="ascii") as file:
                file.write(HEX)
            self.assert_error(2, "flash", F, path, says="openocd:stlink")
            self.assert_error(2, "flash", F, path, "--via", "openocd:stlink", says="--target")
            self.assert_error(2, "flash", F, path, "--via", "avrdude:x:y", "--target", "f1")
            for way in (["openocd:stlink?target=f1"], ["openocd:stlink", "--target", "f1"]):
                dry = self.run_one("flash", F, path, "--via", *way, "--dry-run")
            self.assertEqual((dry["result"], dry["verified"]), ("done", False))
            nowhere = Run(["--json", "flash", F, path, "--via", "openocd:stlink", "--target", "f1"],
                          environment={**os.environ, "PATH": folder})
            self.assertEqual(nowhere.status, 5, nowhere.err)
            self.assertIn("sudo apt install openocd", nowhere.err)

    def test_flash_writes_no_mute_drive_while_the_probe_may_hang_on_another(self):
        mute = "sim:can/abstractdc:6"
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "drive.hex")
            with open(path, "w", encoding="ascii") as file:
                file.write(HEX)
            self.assert_error(3, "flash", mute, path, "--via", "openocd:stlink", "--target", "f1",
                              says="take all others off the line")
        self.assert_error(3, "get", mute, says="abstractdc answers as number 6")
