#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every text of the sources is in the .ts files, and every language is complete: also what the library says (say())."""
import collections
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "scripts"))
import messages as said_by  # noqa: E402
LITERALS = r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*'
PLURALS = {"ja": 1, "zh": 1}  # forms of %n; two elsewhere
MNEMONIC = re.compile(r"&(?=\w)(?!\w+;)")
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
        cls.languages = {path.stem.split("_")[1]: messages(path) for path in sorted(ROOT.glob("translations/motorbench_*.ts"))}
        cls.german = cls.languages["de"]

    def each(self, check):
        for language, found in self.languages.items():
            for message in found:
                with self.subTest(language=language, source=message.source):
                    check(language, message)

    def test_the_languages_of_the_window_are_there(self):
        self.assertLessEqual({"de", "en", "es", "fr", "ja", "zh"}, set(self.languages))

    def test_the_files_hold_every_text_of_the_sources_and_no_other(self):
        with tempfile.TemporaryDirectory() as folder:
            for language in self.languages:
                shutil.copy(ROOT / f"translations/motorbench_{language}.ts", folder)
            done = subprocess.run([str(ROOT / "scripts/translate"), folder], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stdout)
            for language, known in self.languages.items():
                fresh = {message[:3] for message in messages(pathlib.Path(folder, f"motorbench_{language}.ts"))}
                known = {message[:3] for message in known}
                self.assertEqual((sorted(fresh - known), sorted(known - fresh)), ([], []), f"{language}: run scripts/translate")

    def test_nothing_is_unfinished(self):
        def check(language, message):
            self.assertIsNone(message.kind)
            self.assertEqual(len(message.forms), PLURALS.get(language, 2) if message.plural else 1)
            self.assertTrue(all(message.forms), message.forms)
        self.each(check)

    def test_placeholders_agree(self):
        def check(_, message):
            for form in message.forms:
                self.assertEqual(placeholders(form), placeholders(message.source))
        self.each(check)

    def test_marks_of_html_agree(self):
        def check(_, message):
            for form in message.forms:
                self.assertEqual(sorted(re.findall(r"</?[a-z]+[^>]*>", form)), sorted(re.findall(r"</?[a-z]+[^>]*>", message.source)))
        self.each(check)

    def test_mnemonics_agree(self):
        """A letter behind & wherever the source has one, and nowhere else."""
        def check(_, message):
            for form in message.forms:
                self.assertEqual(len(MNEMONIC.findall(form)), len(MNEMONIC.findall(message.source)))
        self.each(check)

    def test_no_text_escapes_lupdate(self):
        known = {message.source for message in self.german}
        lost = [f"{path.relative_to(ROOT)}: {literal(found)}"
                for path, text in sources("app", "widgets") if "console" not in path.parts
                for found in re.findall(r"\btr\(\s*(" + LITERALS + ")", text) if literal(found) not in known]
        self.assertEqual(lost, [])

    def test_every_sentence_of_the_library_has_german(self):
        known = {message.source: message for message in self.german if message.context == "table"}
        said = {literal(f'"{found}"'): path.relative_to(ROOT) for path in said_by.sources()
                for found in said_by.said(path.read_text(encoding="utf-8"))}
        self.assertGreater(len(said), 800)
        for sentence, path in sorted(said.items()):
            with self.subTest(f"{path}: {sentence}"):
                self.assertIn(sentence, known, "run scripts/translate")
                self.assertTrue(known[sentence].forms[0] and known[sentence].kind is None)

    def test_every_label_of_a_drawing_has_every_language(self):
        """The help shows docs/hardware/*.svg with the words of the window, and knows how much room each has."""
        labels = list(said_by.labels())
        self.assertGreater(len({path for path, _attributes, _label in labels}), 3)
        for language, found in self.languages.items():
            known = {message.source: message for message in found if message.context == "drawings"}
            for path, attributes, label in labels:
                with self.subTest(f"{language}, {path.name}: {label}"):
                    self.assertIn("data-room=", attributes)
                    if language != "en":
                        self.assertIn(label, known, "run scripts/translate")
                        self.assertTrue(known[label].forms[0] and known[label].kind is None)

    def test_labels_of_drawings_that_are_no_words_are_names(self):
        """What is_words() lets pass untranslated, one by one: whoever adds one says here that no language has another word for it."""
        every = {label for path in ROOT.glob("docs/hardware/*.svg") for _attributes, label in said_by.LABEL.findall(path.read_text(encoding="utf-8"))}
        names = {"0 … 3.3 V", "1 Mbit/s", "120 Ω", "3.3 V", "3.3V", "A", "AUX1 – AUX2", "B", "CE0", "DMC60C", "DMC60C #5", "DMC60C #7", "DRV3",
                 "DRV4", "GND", "M1", "M2", "MCLR", "MISO", "MOSI", "POW", "QuadQuad2Drv", "SCK", "SCLK", "SRDY", "SS", "SWDIO, SWCLK,",
                 "VIN 5 … 12 V, 5 A"}
        self.assertEqual(sorted(label for label in every if not said_by.is_words(label)), sorted(names))

    def test_each_language_knows_its_own_code(self):
        """By which the help finds its pages."""
        for language, found in self.languages.items():
            code = [message.forms[0] for message in found if (message.context, message.source) == ("Languages", "en")]
            self.assertEqual(code, [] if language == "en" else [language])

    def test_no_sentence_of_the_library_is_hidden_from_the_collection(self):
        """say() with anything but a literal behind it would be found by nobody."""
        hidden = [f"{path.relative_to(ROOT)}: {found}" for path in said_by.sources() if path.is_relative_to(ROOT / "devices")
                  for found in re.findall(r'(?<![\w:>.])say\((?!\s*")[^;]{0,40}', path.read_text(encoding="utf-8"))]
        self.assertEqual(hidden, [])


if __name__ == "__main__":
    unittest.main()
