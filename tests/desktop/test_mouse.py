# SPDX-License-Identifier: GPL-3.0-or-later
"""From the start of the program to a gain in flash with a mouse alone: the first story of the start page."""
import sys

import desktop

desktop.enter()

from desktop import Program, wait, xdo  # noqa: E402
import story  # noqa: E402


def main(path):
    with Program(path) as program:
        program.await_("push button", "^Try it: .*overshoots").click()
        program.await_("table cell", "^DMC60C #7").click()
        story.await_step(program, "Arm")
        program.find("push button", "^Show me where$").click()
        arm = program.await_("push button", "^Arm button: SAFE$")
        wait("something to arm", lambda: arm.description == "hold to arm")
        arm.point()
        xdo("mousedown", 1)
        program.await_("push button", "^Arm button: ARMED")
        xdo("mouseup", 1)
        story.await_step(program, "Step")
        program.await_enabled("push button", "^(Write and )?[Rr]un").click()
        story.await_step(program, "Tune")
        program.await_("page tab", "^Design$").click()
        program.await_enabled("push button", "^Autotune").click()
        story.await_step(program, "Store")
        program.await_("page tab", "^Parameters$").click()
        program.await_enabled("push button", "^Store and prove").click()
        story.await_done(program)
    story.verify_kept(path)


main(sys.argv[1])
