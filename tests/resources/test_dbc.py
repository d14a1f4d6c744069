# SPDX-License-Identifier: GPL-3.0-or-later
"""test_dbc.py MOTORBENCHCTL SOURCE: the DBC files are up to date, whole, and give the numbers of literal frames and of
'motorbenchctl decode'."""
import json
import pathlib
import subprocess
import sys
import unittest

import dbcreader

PROGRAM, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
FOLDER = SOURCE / "resources/dbc"

# Golden vectors of the DMC60C (dmc60c/README.md#vectors), and what they mean.
DMC60C = [
    ("00000240#", "ENUM", {}),
    ("0206FC05#3412600000000000", "VENDORCMD_05", {"sessid": 0x1234, "cmd": 0x60, "PARAM1": 0, "PARAM2": 0}),
    ("0206FC45#41726D00", "VENDORDOUT_05", {"byte0": 0x41, "byte1": 0x72, "byte2": 0x6D, "byte3": 0}),
    ("0206FCC5#07000000", "VENDORSTS_05", {"cerc": 7, "terc": 0, "cb": 0}),
    ("0206FCC5#09040000", "VENDORSTS_05", {"cerc": 9, "terc": 4, "cb": 0}),
    ("0206FC85#45230100", "VENDORDIN_05", {"byte0": 0x45, "byte1": 0x23, "byte2": 1, "byte3": 0}),
    ("02061845#3D0000280000", "PARAMRESP_05", {"paramid": 61, "current_limit_continuous": 40.0, "perc": 0}),
    ("02061885#34123D00002800", "PARAMSET_05", {"sessid": 0x1234, "paramid": 61, "current_limit_continuous": 40.0}),
    ("02061885#34123FF4010000", "PARAMSET_05", {"paramid": 63, "current_limit_peak_duration": 500}),
    ("02061885#34124001000000", "PARAMSET_05", {"paramid": 64, "current_limit_enabled": 1}),
    ("02061885#34120A9A190000", "PARAMSET_05", {"paramid": 10, "slot0_p": 6554 / 65536}),
    ("02061885#34120A0080FDFF", "PARAMSET_05", {"paramid": 10, "slot0_p": -2.5}),
    ("02061885#341211FF7F0000", "PARAMSET_05", {"paramid": 17, "slot0_max_forward": 32767}),
    ("02061885#34120518FCFFFF", "PARAMSET_05", {"paramid": 5, "limit_forward_soft_threshold": -1000}),
    ("02061845#5D0000000002", "PARAMRESP_05", {"paramid": 93, "status_general_period": 0, "perc": 2}),
    ("02061845#C80000000001", "PARAMRESP_05", {"paramid": 200, "perc": 1}),
    ("02061885#34123401000000", "PARAMSET_05", {"paramid": 52, "faults_sticky": 1}),
    ("02061845#340500000000", "PARAMRESP_05", {"paramid": 52, "faults_sticky": 5}),
    ("02061845#091608000000", "PARAMRESP_05", {"paramid": 9, "current_adc_multiplier": 2070 / 65536}),
    ("02061845#200000640000", "PARAMRESP_05", {"paramid": 32, "current_limit_p": 100.0}),
    ("02061845#14FFFFFFFF00", "PARAMRESP_05", {"paramid": 20, "slot0_nominal_reverse": -1}),
    ("02061405#0040110000000000", "STSGENERAL_05", {"dtcApplied": 16384, "fFwdLimitPin": 1, "fRevLimitPin": 1, "modeSelect": 0, "errCLoop": 0}),
    ("02061405#0000110090FEFFFF", "STSGENERAL_05", {"modeSelect": 2, "fDivErrBy256": 1, "errCLoop": -2}),
    ("02061405#0020110018008001", "STSGENERAL_05", {"dtcApplied": 8192, "modeSelect": 3, "errCLoop": 1.5 * 65536}),
    ("02061405#000011007A000000", "STSGENERAL_05", {"modeSelect": 15, "fUnderVoltageFault": 1, "fOverTempFault": 0}),
    ("02061405#00804BE32C000000", "STSGENERAL_05",
     {"dtcApplied": -32768, "fFwdLimitPin": 1, "fFwdLimitHit": 1, "fFwdLimitDisabled": 0, "fFwdLimitNormalClosed": 1, "fRevLimitPin": 0,
      "fRevLimitDisabled": 1, "fFwdRevLimitOverride": 1, "fFwdLimitDisableOvrd": 1, "fSoftRevLimitHit": 1, "fSoftRevLimitEnabled": 1,
      "fSoftFwdLimitHit": 0, "fCurrentLimitActive": 1, "fGateDriverFault": 1, "modeSelect": 5}),
    ("02061485#01E240FED4000014", "STSENCODER_05", {"poscnt": 123456, "velcnt": -300, "fQEAPin": 1, "fQEBPin": 0, "fQEIdxPin": 1}),
    ("02061485#FFFFFF7FFF000003", "STSENCODER_05", {"poscnt": -1, "velcnt": 32767, "fDivPosBy8": 1, "fDivVelBy4": 1}),
    ("02061485#8000008000000003", "STSENCODER_05", {"poscnt": -8388608, "velcnt": -32768}),
    ("02061485#7FFFFF7FFF000003", "STSENCODER_05", {"poscnt": 8388607, "velcnt": 32767}),
    ("020614C5#4C03FF3B00F6FF1B", "STSANALOG_05", {"vltgAnalogIn": 3.296875, "crntOutput": 59.99609375, "tmpAmbient": -10.0, "vltgVbus": 27.99609375}),
    ("02060005#0F00000000000000", "CANCTRL0_05", {"modeSelect": 15, "trgtH": 0, "trgtML": 0}),
    ("02060005#000000FF00C00000", "CANCTRL0_05", {"modeSelect": 0, "target": -16384}),
    ("02060005#00000000FF7F0000", "CANCTRL0_05", {"target": 32767}),
    ("02060005#000000001027C409", "CANCTRL0_05", {"target": 10000, "vltgRampSet": 2500}),
    ("02060005#0100000000280000", "CANCTRL0_05", {"modeSelect": 1, "target": 10240}),
    ("02060005#C200000140E20004", "CANCTRL0_05", {"modeSelect": 2, "target": 123456, "pidsltSelect": 1, "fRevFeedbackSensor": 1, "vltgRampSet": 1024}),
    ("02060005#0300000C00800000", "CANCTRL0_05", {"modeSelect": 3, "target": 12.5 * 65536}),
    ("02060005#040000F400000000", "CANCTRL0_05", {"modeSelect": 4, "target": -12 * 65536}),
    ("02060005#3000000000000000", "CANCTRL0_05", {"fOverrideBC": 1, "fBrakeCoast": 1}),
    ("02060005#000E000000000000", "CANCTRL0_05", {"fRevMotor": 0, "fDisableFwdLimit": 1, "fDisableRevLimit": 1, "fEnableLimitOverride": 1}),
    ("02060005#0300007FFFFF0000", "CANCTRL0_05", {"target": 8388607}),
]
# Golden vectors of the Abstract DC Drive (abstractdc/README.md#vectors), dialect F.
ABSTRACTDC = [
    ("0C8#010040420F00", "SETTINGS_00", {"TYPE": 1, "FIELD": 0, "value": 1_000_000}),
    ("0C8#0203C0BDF0FF", "SETTINGS_00", {"TYPE": 2, "FIELD": 3, "value": -1_000_000}),
    ("0C8#01", "SETTINGS_00", {"TYPE": 1}),
    ("064#03C8000000", "SETPOINT_00", {"TYPE": 3, "value": 200}),
    ("064#0464000000", "SETPOINT_00", {"TYPE": 4, "value": 100}),
    ("064#0000000000", "SETPOINT_00", {"TYPE": 0, "value": 0}),
    ("384#01", "LOG_REQUEST_00", {"LOG": 1}),
    ("389#03", "LOG_REQUEST_05", {"LOG": 3}),
    ("400#F4010000", "SPEED_LOG_00", {"value": 500}),
    ("405#00000000", "SPEED_LOG_05", {"value": 0}),
    ("480#FFFFFFFF", "POSITION_LOG_00", {"value": -1}),
    ("500#F4010000", "CURRENT_LOG_00", {"value": 500}),
    ("605#00000000", "TEMPERATURE_LOG_05", {"value": 0}),
    ("680#9CFFFFFF", "VOLTAGE_LOG", {"value": -100}),
]


def frame(text):
    identifier, data = text.split("#")
    return (int(identifier, 16), len(identifier) == 8), bytes.fromhex(data)


def target_of(fields):
    """What a user of the file computes from the two signals."""
    return {**fields, "target": fields["trgtH"] * 65536 + fields["trgtML"]} if "trgtH" in fields else fields


def monitor(vectors, family):
    """What the console makes of the same frames; nothing when it does not know the family."""
    text = "".join(f"(1.000000) can0 {frame_}\n" for frame_, _, _ in vectors)
    done = subprocess.run([PROGRAM, "--json", "decode"], input=text, capture_output=True, text=True, check=True, timeout=60)
    rows = [json.loads(line) for line in done.stdout.splitlines()]
    return rows if any(row["family"] == family for row in rows) else None


class DbcFiles(unittest.TestCase):
    def test_the_files_are_what_the_generator_writes(self):
        done = subprocess.run([sys.executable, "-B", FOLDER / "make-dbc", "--check"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)

    def check(self, name, vectors):
        messages = dbcreader.read(FOLDER / name)
        for text, message, fields in vectors:
            with self.subTest(text):
                key, data = frame(text)
                self.assertEqual(messages[key].name, message)
                found = target_of(messages[key].decode(data))
                self.assertEqual({field: found[field] for field in fields}, fields)
        return messages

    def test_dmc60c_gives_the_numbers_of_the_protocol_reference(self):
        self.check("dmc60c.dbc", DMC60C)

    def test_abstractdc_gives_the_numbers_of_the_protocol_reference(self):
        self.check("abstractdc.dbc", ABSTRACTDC)

    def test_device_numbers_are_expanded_and_the_enumeration_answers_left_out(self):
        messages = dbcreader.read(FOLDER / "dmc60c.dbc")
        self.assertEqual(len(messages), 1 + 11 * 64)
        self.assertTrue(all(extended for _, extended in messages))
        for number in range(64):
            self.assertNotIn((0x0206F000 + number, True), messages)
            self.assertEqual(messages[0x02061400 + number, True].name, f"STSGENERAL_{number:02}")
        responses = messages[0x02061845, True]
        self.assertEqual(len({signal.selected_by for signal in responses.signals} - {None}), 55, "every parameter has its signal")
        mode = next(signal for signal in messages[0x02061405, True].signals if signal.name == "modeSelect")
        self.assertEqual(mode.choices[3], "current")

    def test_offsets_are_expanded_and_nothing_meets(self):
        messages = dbcreader.read(FOLDER / "abstractdc.dbc")
        self.assertEqual(len(messages), 7 * 100 + 1)
        self.assertFalse(any(extended for _, extended in messages))
        self.assertEqual(messages[1635, False].name, "TEMPERATURE_LOG_99")

    def test_signals_fit_their_message_and_do_not_overlap(self):
        for name in ("dmc60c.dbc", "abstractdc.dbc"):
            for message in dbcreader.read(FOLDER / name).values():
                used = {}
                for signal in message.signals:
                    for place in signal.bits():
                        self.assertLess(place[0], message.size, f"{message.name} {signal.name}")
                        others = used.setdefault(place, set())
                        self.assertNotIn(signal.selected_by, others, f"{message.name} {signal.name}")
                        self.assertTrue(signal.selected_by is not None or not others, f"{message.name} {signal.name}")
                        others.add(signal.selected_by)

    def test_dmc60c_agrees_with_the_monitor(self):
        messages = dbcreader.read(FOLDER / "dmc60c.dbc")
        rows = monitor(DMC60C, "dmc60c")
        self.assertIsNotNone(rows)
        compared = 0
        for (text, _, _), row in zip(DMC60C, rows):
            key, data = frame(text)
            found = messages[key].decode(data)
            self.assertEqual(messages[key].name.split("_")[0], row["message"])
            scale = {"poscnt": 8 if found.get("fDivPosBy8") else 1, "velcnt": 4 if found.get("fDivVelBy4") else 1}
            for field, value in row["fields"].items():
                if field == "value":
                    found[field] = next((v for n, v in found.items() if n not in ("sessid", "paramid", "perc")), value)
                if field not in found or field == "errCLoop":
                    continue
                compared += 1
                self.assertEqual(found[field] * scale.get(field, 1), value, f"{text} {field}")
        self.assertGreater(compared, 200)

    def test_abstractdc_agrees_with_the_monitor(self):
        rows = monitor(ABSTRACTDC, "abstractdc")
        if rows is None:
            self.skipTest("this build does not know the family")
        messages = dbcreader.read(FOLDER / "abstractdc.dbc")
        for (text, _, _), row in zip(ABSTRACTDC, rows):
            key, data = frame(text)
            self.assertEqual(messages[key].decode(data), row["fields"], text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=2)
