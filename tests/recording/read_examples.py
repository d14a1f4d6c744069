# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads what the program wrote with a reader that shares nothing with it: MCAP by the specification of mcap.dev, messages by
the descriptor that the file itself carries, CSV with Python's own module. Usage: read_examples.py TEST_PROGRAM"""
import csv
import math
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

PROGRAM = ""
MAGIC = b"\x89MCAP0\r\n"
START = 1_700_000_000


def records(data, at, end):
    while at < end:
        kind, length = struct.unpack_from("<BQ", data, at)
        yield kind, at, data[at + 9:at + 9 + length]
        at += 9 + length


def text(content, at):
    (length,) = struct.unpack_from("<I", content, at)
    return content[at + 4:at + 4 + length], at + 4 + length


def mapping(content, at):
    inside, at = text(content, at)
    pairs, place = {}, 0
    while place < len(inside):
        key, place = text(inside, place)
        value, place = text(inside, place)
        pairs[key.decode()] = value.decode()
    return pairs, at


def varint(content, at):
    value = shift = 0
    while True:
        byte = content[at]
        at += 1
        value |= (byte & 0x7F) << shift
        shift += 7
        if byte < 0x80:
            return value, at


def fields(content):
    """Number and value of each field of a protocol buffers message."""
    at = 0
    while at < len(content):
        tag, at = varint(content, at)
        wire = tag & 7
        if wire == 0:
            value, at = varint(content, at)
        elif wire == 1:
            value, at = content[at:at + 8], at + 8
        elif wire == 2:
            length, at = varint(content, at)
            value, at = content[at:at + length], at + length
        else:
            raise ValueError(f"wire type {wire}")
        yield tag >> 3, value


def message_fields(descriptor_set, wanted):
    """Number to (name, type) of a message, from a FileDescriptorSet."""
    for _, file in fields(descriptor_set):
        package = b"".join(value for number, value in fields(file) if number == 2)
        for number, message in fields(file):
            if number != 4:
                continue
            name = next(value for key, value in fields(message) if key == 1)
            if (package + b"." + name).decode() != wanted:
                continue
            found = {}
            for key, field in fields(message):
                if key == 2:
                    row = dict(fields(field))
                    found[row[3]] = (row[1].decode(), row[5])
            return found
    raise ValueError(wanted)


class Mcap:
    def __init__(self, data):
        self.topics, self.samples, self.facts, self.indexed, self.statistics = {}, {}, {}, {}, None
        assert data.startswith(MAGIC) and data.endswith(MAGIC)
        kinds = []
        for kind, at, content in records(data, len(MAGIC), len(data) - len(MAGIC)):
            kinds.append(kind)
            self.take(kind, at, content)
        assert kinds[0] == 1 and kinds[-1] == 2 and 15 in kinds
        summary, _, _ = struct.unpack("<QQI", content)
        assert next(records(data, summary, len(data)))[0] == 3
        for offset, (name, length) in self.indexed.items():
            kind, _, content = next(records(data, offset, len(data)))
            assert kind == 12 and len(content) + 9 == length and text(content, 0)[0].decode() == name

    def take(self, kind, _at, content):
        if kind == 3:
            (self.schema_id,) = struct.unpack_from("<H", content)
            self.schema, place = text(content, 2)
            self.encoding, place = text(content, place)
            self.fields = message_fields(text(content, place)[0], self.schema.decode())
        elif kind == 4:
            channel, schema = struct.unpack_from("<HH", content)
            topic, place = text(content, 4)
            encoding, place = text(content, place)
            assert schema == self.schema_id and encoding == b"protobuf" == self.encoding
            self.topics[channel] = (topic.decode(), mapping(content, place)[0])
        elif kind == 5:
            channel, _, log, publish = struct.unpack_from("<HIQQ", content)
            assert log == publish
            message = {self.fields[number][0]: value for number, value in fields(content[22:])}
            value = struct.unpack("<d", message["value"])[0]
            self.samples.setdefault(channel, []).append((log, value, message.get("lost", 0), message.get("gap", 0)))
        elif kind == 11:
            self.statistics = struct.unpack_from("<QHIIIIQQ", content)
        elif kind == 12:
            name, place = text(content, 0)
            self.facts[name.decode()] = mapping(content, place)[0]
        elif kind == 13:
            offset, length = struct.unpack_from("<QQ", content)
            self.indexed[offset] = (text(content, 16)[0].decode(), length)


class Examples(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        subprocess.run([PROGRAM, "--gtest_filter=Examples.*"], check=True, stdout=subprocess.DEVNULL,
                       env={**os.environ, "MOTORBENCH_EXAMPLES": cls.folder.name})
        cls.path = pathlib.Path(cls.folder.name)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_mcap_has_every_sample_with_time_gap_and_loss(self):
        mcap = Mcap((self.path / "example.mcap").read_bytes())
        self.assertEqual(mcap.fields, {1: ("value", 1), 2: ("lost", 4), 3: ("gap", 8)})
        by_topic = {topic: mcap.samples[channel] for channel, (topic, _) in mcap.topics.items()}
        self.assertEqual(set(by_topic), {"/sim_can/dmc60c_5/velocity", "/sim_can/dmc60c_5/position"})
        velocity = by_topic["/sim_can/dmc60c_5/velocity"]
        self.assertEqual([row[0] for row in velocity], [START * 10**9 + i * 10**6 for i in range(1000)])
        self.assertEqual([row[1] for row in velocity], [math.sqrt(i) for i in range(1000)])
        self.assertEqual([(i, row[2], row[3]) for i, row in enumerate(velocity) if row[2] or row[3]], [(400, 7, 1)])
        self.assertEqual([row[1] for row in by_topic["/sim_can/dmc60c_5/position"]], [-i for i in range(0, 1000, 4)])
        messages, schemas, channels, attachments, metadata, chunks, first, last = mcap.statistics
        self.assertEqual((messages, schemas, channels, attachments, chunks), (1250, 1, 2, 0, 0))
        self.assertEqual(metadata, len(mcap.indexed))
        self.assertEqual((first, last), (START * 10**9, START * 10**9 + 999 * 10**6))

    def test_mcap_describes_itself(self):
        mcap = Mcap((self.path / "example.mcap").read_bytes())
        about = {topic: facts for topic, facts in mcap.topics.values()}["/sim_can/dmc60c_5/velocity"]
        self.assertEqual((about["unit"], about["device"], about["key"]), ("counts/s", "sim:can/dmc60c:5", "velocity"))
        self.assertEqual(mcap.facts["device sim:can/dmc60c:5"]["serial"], "SN 7")
        self.assertEqual(mcap.facts["parameters sim:can/dmc60c:5"], {"slot0.p": "1.5"})
        self.assertEqual(mcap.facts["loss sim:can/dmc60c:5"]["velocity"], "7 of 1007")
        self.assertEqual(mcap.facts["note"]["text"], "load pulse")

    def test_csv_is_a_plain_table_below_its_notes(self):
        lines = (self.path / "example.csv").read_text(encoding="utf-8").splitlines()
        self.assertIn("# loss sim:can/dmc60c:5: velocity = 7 of 1007 lost", lines)
        table = list(csv.DictReader(line for line in lines if not line.startswith("#")))
        velocity = [(float(row["time_s"]), float(row["dmc60c:5 velocity (counts/s)"])) for row in table
                    if row["dmc60c:5 velocity (counts/s)"]]
        values = [pair for pair in velocity if not math.isnan(pair[1])]
        self.assertEqual([value for _, value in values], [math.sqrt(i) for i in range(1000)])
        for i, (time, _) in enumerate(values):
            self.assertAlmostEqual(time, i / 1000, places=6)
        self.assertEqual([round(time, 6) for time, value in velocity if math.isnan(value)], [0.399999])
        times = [float(row["time_s"]) for row in table]
        self.assertEqual(times, sorted(times))


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
