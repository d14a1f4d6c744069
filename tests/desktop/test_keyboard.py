# SPDX-License-Identifier: GPL-3.0-or-later
"""From the start of the program to a gain in flash with the keyboard alone: Tab, arrows, Enter and the keys that F1 lists."""
import re
import sys

import desktop

desktop.enter()

from desktop import Missing, Program, press, wait, xdo  # noqa: E402
import story  # noqa: E402

MOST = 300  # times that Tab is pressed, more than any page has controls


def tab_to(program, name, roles=None, key="Tab"):
    passed = []
    for _ in range(MOST):
        node = program.tab(key)
        if node and re.search(name, node.name) and (roles is None or node.role in roles):
            return
        passed.append(node.name if node else "nothing")
    raise Missing(f"{key} does not come to {name or roles}, but to {passed[:80]}")


def arm(program):
    wait("something to arm", lambda: program.find("push button", "^Arm button: SAFE$").description == "hold to arm")
    xdo("keydown", "ctrl", "keydown", "shift", "keydown", "F12")
    try:
        program.await_("push button", "^Arm button: ARMED")
    finally:
        xdo("keyup", "F12", "keyup", "shift", "keyup", "ctrl")


def play(program):
    program.await_("push button", "^Try it: .*overshoots")
    tab_to(program, "^Try it: .*overshoots")
    press("Return")
    program.await_("table cell", "^DMC60C #7")
    tab_to(program, "", ("tree", "table cell", "tree table"))
    press("Home")
    tab_to(program, "^DMC60C #7", key="Down")
    story.await_step(program, "Arm")
    press("ctrl+3")
    arm(program)
    story.await_step(program, "Step")
    program.await_enabled("push button", "^(Write and )?[Rr]un")
    press("F5")
    story.await_step(program, "Tune")
    press("ctrl+4")
    program.await_enabled("push button", "^Autotune")
    press("F6")
    story.await_step(program, "Store")
    press("ctrl+2")
    program.await_enabled("push button", "^Store and prove")
    tab_to(program, "^Store and prove")
    press("Return")
    story.await_done(program)


def main(path):
    with Program(path) as program:
        play(program)
        press("ctrl+q")
        wait("the end of the program", lambda: program.process.poll() is not None)
    story.verify_kept(path)


main(sys.argv[1])
