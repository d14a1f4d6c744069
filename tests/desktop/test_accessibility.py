# SPDX-License-Identifier: GPL-3.0-or-later
"""What a screen reader is told, on a real accessibility bus: every page and every dialog is walked through, and each control has a name,
its states are right, arming is announced, and live values do not drown them."""
import re
import sys
import time
import unittest

import desktop

desktop.enter()

from desktop import Atspi, GLib, Program, press, settle, wait, xdo  # noqa: E402

PATH = sys.argv.pop(1)
CONTROLS = {"push button", "toggle button", "check box", "radio button", "combo box", "text", "password text", "spin button", "slider",
            "list", "tree", "tree table", "table", "page tab", "page tab list", "menu item", "check menu item", "link", "progress bar",
            "dialog", "alert", "frame", "window"}
CELLS = {"table cell", "list item", "tree item", "column header", "row header", "table column header", "table row header"}
MOST_EVENTS = 100  # a second, of a bench of nine units that report a hundred times a second each


def is_labelled(node):
    """On this bus a combo box is called as what is chosen in it; its name is in its description, or in a label beside it."""
    if node.description:
        return True
    return any(relation.get_relation_type() == Atspi.RelationType.LABELLED_BY for relation in node.thing.get_relation_set())


def unnamed(program, within=None):
    found, count = [], 0
    for node in program.all(within):
        role = node.role
        if role in CELLS or (role not in CONTROLS and not node.has("focusable")):
            continue
        if role in ("frame", "window") and node.parent.role != "application":
            continue
        count += 1
        if not node.name.strip() or (role == "combo box" and not is_labelled(node)):
            found.append(f"{node} in '{node.parent.name}' in '{node.parent.parent.name}'")
    return found, count


class Walk(unittest.TestCase):
    def verify_named(self, program, place, within=None):
        settle()
        found, count = unnamed(program, within)
        print(f"{place}: {count} controls, {len(found)} unnamed", flush=True)
        for one in found:
            print("   ", one, flush=True)
        self.bad += [f"{place}: {one}" for one in found]

    def setUp(self):
        self.bad = []

    def tearDown(self):
        self.assertEqual(self.bad, [])

    def run_command(self, program, words):
        """By its name, in the list of commands."""
        press("ctrl+k")
        field = program.await_("text", "^Command$")
        xdo("type", "--delay", "2", words)
        wait(f"command '{words}'", lambda: field.thing.get_text(0, -1) == words)
        press("Return")

    def close(self, program, title):
        press("Escape")
        wait(f"dialog '{title}' to go", lambda: not any(
            re.search(title, window.name) for window in program.windows() if window.role != "frame"))

    def test_pages(self):
        with Program(PATH, "--demo") as program:
            program.await_("table cell", "^DMC60C #7")
            for number in range(1, 10):
                press(f"ctrl+{number}")
                tabs = program.await_("page tab list", "")
                wait(f"page {number}", lambda: list(tabs.children())[number - 1].has("focused"))  # Qt's word for the chosen tab
                settle(0.5)
                self.verify_named(program, f"page {number} {list(tabs.children())[number - 1].name}")
            press("F11")
            program.await_("push button", "Leave")
            self.verify_named(program, "production")
            press("F11")

    def test_start_page_and_states(self):
        with Program(PATH) as program:
            program.await_("push button", "^Try it: .*overshoots")
            self.verify_named(program, "start")
            for name in ("Tune", "Design"):  # Qt tells no state of a single tab: the reason stands for it
                self.assertEqual(program.find("page tab", f"^{name}$").description, "needs a device; open a link first")
            filtering = program.find("check box", "^Filter devices$")
            self.assertFalse(filtering.has("checked"))
            filtering.click()
            wait("the box to be told as checked", lambda: filtering.has("checked"))
            filtering.click()
            wait("and as not checked", lambda: not filtering.has("checked"))

    def test_dialogs(self):
        with Program(PATH, "--demo") as program:
            program.await_("table cell", "^DMC60C #7").click()
            for how, title in {"ctrl+comma": "^Preferences", "F1": "^Keys", "ctrl+k": "^Commands"}.items():
                press(how)
                dialog = program.dialog(title)
                self.verify_named(program, title, dialog)
                for tab in [node for node in dialog.walk(1) if node.role == "page tab" and not node.has("focused")]:
                    tab.click()
                    self.verify_named(program, f"{title}, {tab.name}", dialog)
                self.close(program, title)
            for words, title in {"About MotorBench": "^About", "Menu Add link": "^Add", "Open recording": "^Open",
                                 "Menu Help": "^Help", "Open the folder": "", "Save the machine": ""}.items():
                self.run_command(program, words)
                wait("the list of commands to go", lambda: not program.find("text", "^Command$"))
                dialog = program.dialog(title)
                self.verify_named(program, words, dialog)
                self.close(program, dialog.name)
            press("ctrl+3")
            program.await_("push button", "^(Write and )?[Rr]un")
            press("F7")
            dialog = program.dialog("")
            self.verify_named(program, dialog.name, dialog)
            self.close(program, dialog.name)


    def arm(self, program):
        press("ctrl+3")
        arm = program.await_("push button", "^Arm button: SAFE$")
        arm.point()
        xdo("mousedown", 1)
        try:
            wait("armed, and told so", lambda: program.heard("ARMED"))
        finally:
            xdo("mouseup", 1)

    def test_the_result_of_a_step_is_announced(self):
        with Program(PATH, "--demo") as program:
            program.await_("table cell", "^DMC60C #7").click()
            self.arm(program)
            program.await_enabled("push button", "^(Write and )?[Rr]un")
            for number in 1, 2:  # the second is told like the first
                since = len(program.heard_from)
                press("F5")
                said = wait("what came of the step", lambda: program.heard(
                    rf"#7: trial #{number}: overshoot \d+(\.\d+)?\s%, settled in \d+\sms", since))
                print(f"heard '{said}'", flush=True)
                program.await_enabled("push button", "^(Write and )?[Rr]un")

    def test_arming_is_announced_and_live_values_are_not_shouted(self):
        with Program(PATH, "--demo") as program:
            program.await_("table cell", "^DMC60C #7").click()
            press("ctrl+1")
            settle(3)
            since, begun = len(program.heard_from), time.monotonic()
            while time.monotonic() < begun + 5:
                settle(0.1)
                time.sleep(0.01)
            rate = (len(program.heard_from) - since) / (time.monotonic() - begun)
            print(f"{rate:.0f} accessible events a second at rest")
            self.assertLess(rate, MOST_EVENTS)
            self.arm(program)


unittest.main(verbosity=2)
