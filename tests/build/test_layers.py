#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A forbidden link ends the configuration: the miniature in layers/ is configured as it is, and with one link more."""
import pathlib
import subprocess
import tempfile
import unittest

MINIATURE = pathlib.Path(__file__).resolve().parent / "layers"


def configure(source, how="", target=""):
    with tempfile.TemporaryDirectory() as build:
        command = ["cmake", "-S", str(MINIATURE), "-B", build, "-DCMAKE_CXX_COMPILER_FORCED=ON",
                   f"-DFROM={source}", f"-DHOW={how}", f"-DTO={target}"]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    return done.returncode, " ".join(done.stdout.split())


class Layers(unittest.TestCase):
    def expect_refusal(self, source, how, target, reached=None):
        with self.subTest(f"{source} {how} {target}"):
            status, output = configure(source, how, target)
            self.assertNotEqual(status, 0, output)
            self.assertIn(f"layers: {source} must not depend on {reached or target}", output)

    def test_the_links_of_the_project_are_accepted(self):
        status, output = configure("")
        self.assertEqual(status, 0, output)

    def test_a_link_that_the_layers_allow_is_accepted(self):
        status, output = configure("one", "PRIVATE", "wire")
        self.assertEqual(status, 0, output)

    def test_no_qt_below_transport(self):
        self.expect_refusal("async", "PUBLIC", "Qt5::Core")
        self.expect_refusal("wire", "PRIVATE", "Qt5::Core")
        self.expect_refusal("telemetry", "PRIVATE", "Qt5::Core")

    def test_no_screen_in_the_library(self):
        for layer in ("transport", "model", "one", "devices"):
            self.expect_refusal(layer, "PRIVATE", "Qt5::Gui")
        self.expect_refusal("model", "PUBLIC", "QCustomPlot")

    def test_no_layer_knows_the_one_above(self):
        self.expect_refusal("transport", "PRIVATE", "model")
        self.expect_refusal("model", "PRIVATE", "one")
        self.expect_refusal("experiment", "PRIVATE", "tuning")
        self.expect_refusal("settings", "PRIVATE", "experiment")
        self.expect_refusal("tuning", "PRIVATE", "service")
        self.expect_refusal("tuning", "PRIVATE", "one")
        self.expect_refusal("tuning", "PRIVATE", "Qt5::Sql")
        for layer in ("report", "settings", "service"):
            self.expect_refusal(layer, "PRIVATE", "one")
            self.expect_refusal(layer, "PRIVATE", "storage")
        self.expect_refusal("storage", "PRIVATE", "one")
        self.expect_refusal("devices", "PRIVATE", "widgets")

    def test_the_rooms_below_the_model_do_not_know_each_other(self):
        for room, others in (("traffic", ("simulation", "firmware", "telemetry")), ("simulation", ("traffic", "firmware")),
                             ("firmware", ("traffic", "simulation"))):
            for other in (*others, "model"):
                self.expect_refusal(room, "PRIVATE", other)
        self.expect_refusal("files", "PRIVATE", "wire")
        self.expect_refusal("transport", "PRIVATE", "telemetry")

    def test_no_family_knows_another(self):
        self.expect_refusal("one", "PRIVATE", "other")
        self.expect_refusal("other", "PUBLIC", "one")

    def test_the_console_has_no_screen(self):
        self.expect_refusal("motorbenchctl", "PRIVATE", "widgets")
        self.expect_refusal("motorbenchctl", "PRIVATE", "Qt5::Widgets")

    def test_the_guardian_knows_nothing_of_ours(self):
        for layer in ("Qt5::Core", "async", "model", "guardianclient"):
            self.expect_refusal("guardian", "PRIVATE", layer)
        self.expect_refusal("motorbench-guardian", "PRIVATE", "Qt5::Core")

    def test_the_client_of_the_guardian_has_no_screen(self):
        self.expect_refusal("guardianclient", "PRIVATE", "Qt5::Gui")
        self.expect_refusal("guardianclient", "PRIVATE", "devices")

    def test_a_private_link_of_a_library_between_is_found(self):
        self.expect_refusal("model", "PRIVATE", "harmless", reached="Qt5::Gui")


if __name__ == "__main__":
    unittest.main()
