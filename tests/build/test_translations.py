#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every text of the sources is in the .ts files, German is complete, and the patterns of device sentences still fit."""
import collections
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
LITERALS = r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*'
Message = collections.namedtuple("Message", "context source plural kind forms")


def messages(path):
    found = []
    for context in ElementTree.parse(path).getroot().iter("context"):
        for message in context.iter("message"):
            translation = message.find("translation")
            forms = [form.text or "" for form in translation.iter("numerusform")] or [translation.text or ""]
            plural = message.get("numerus") == "yes"
            found.append(Message(context.findtext("name"), text_of(message.find("source")), plural, translation.get("type"), forms))
    return found


def text_of(element):
    """The text with the control characters that XML cannot hold, which lupdate writes as <byte value="x9"/>."""
    bytes_ = [chr(int(byte.get("value").lstrip("x"), 16)) + (byte.tail or "") for byte in element]
    return (element.text or "") + "".join(bytes_)


def literal(text):
    """What adjacent C++ string literals say together."""
    joined = "".join(re.findall(r'"((?:[^"\\\n]|\\.)*)"', text))
    return joined.replace("\\n", "\n").replace("\\t", "\t").replace('\\"', '"').replace("\\\\", "\\")


def sources(*folders):
    for folder in folders:
        for path in sorted((ROOT / folder).rglob("*.cpp")) + sorted((ROOT / folder).rglob("*.h")):
            yield path, path.read_text(encoding="utf-8")


def placeholders(text):
    return sorted(set(re.findall(r"%L?[1-9n]", text)))


class Translations(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.german = messages(ROOT / "translations/motorbench_de.ts")
        cls.english = messages(ROOT / "translations/motorbench_en.ts")

    def test_the_files_hold_every_text_of_the_sources_and_no_other(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("motorbench_de.ts", "motorbench_en.ts"):
                shutil.copy(ROOT / "translations" / name, folder)
            done = subprocess.run([str(ROOT / "scripts/translate"), folder], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stdout)
            for name, known in (("motorbench_de.ts", self.german), ("motorbench_en.ts", self.english)):
                fresh = {message[:3] for message in messages(pathlib.Path(folder, name))}
                known = {message[:3] for message in known}
                self.assertEqual((sorted(fresh - known), sorted(known - fresh)), ([], []), f"{name}: run scripts/translate")

    def test_nothing_is_unfinished(self):
        for message in self.german + self.english:
            with self.subTest(message.source):
                self.assertIsNone(message.kind)
                self.assertEqual(len(message.forms), 2 if message.plural else 1)
                self.assertTrue(all(message.forms), message.forms)

    def test_placeholders_agree(self):
        for message in self.german + self.english:
            for form in message.forms:
                with self.subTest(message.source):
                    self.assertEqual(placeholders(form), placeholders(message.source))

    def test_no_text_escapes_lupdate(self):
        known = {message.source for message in self.german}
        lost = [f"{path.relative_to(ROOT)}: {literal(found)}"
                for path, text in sources("app", "widgets") if "console" not in path.parts
                for found in re.findall(r"\btr\(\s*(" + LITERALS + ")", text) if literal(found) not in known]
        self.assertEqual(lost, [])

    def test_device_sentences_are_still_said(self):
        said = [literal(found) for path, text in sources("devices", "app") for found in re.findall(LITERALS, text)]
        patterns = (ROOT / "widgets/common/devicephrases.cpp").read_text(encoding="utf-8")
        for found in re.findall(r'QT_TRANSLATE_NOOP\("table", (' + LITERALS + r")\)", patterns):
            # joined from parts (a cause, a remedy), so the parts are looked for: whole, or else word by word
            parts = [part.strip() for part in re.split(r"%[1-9]|[;:,] ", literal(found)) if re.search(r"\w", part)]
            words = [word for part in parts if not any(part in text for text in said)
                     for word in re.findall(r"[A-Za-z][A-Za-z-]{3,}", part)]
            with self.subTest(literal(found)):
                self.assertEqual([word for word in words if not any(word in text for text in said)], [])


if __name__ == "__main__":
    unittest.main()
