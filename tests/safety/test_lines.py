#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Motors on a serial line (a pair of terminals) and on an SPI socket, and everything that must end their motion:

    tests/safety/test_lines.py MOTORBENCHCTL WINDOWDRIVER [unittest options]
"""
import os
import sys
import unittest

from bench import Motor, SerialCable, SocketCable
from rows import ROWS
from scenarios import CableScenarios, MotionScenarios, Rounds, WindowScenarios, SteadyCase, ownhome
from trials import TrialScenarios, TuneScenarios


class LineRig:
    watchdog, written, known = None, (), ()

    def __init__(self, control):
        self.control = control

    def start(self):
        self.cable = self.make_cable()
        self.motor = Motor(self.control, self.far(), self.unit)
        self.cable.start()
        self.cable.plug_in()
        self.device = self.near()

    def end(self):
        self.motor.end()
        self.cable.end()

    def pull(self):
        self.cable.pull()

    def plug_in(self):
        return self.cable.plug_in()

    def account(self, since):
        return self.motor.account(since, [(at, data.hex()) for at, data in list(self.cable.heard)])

    def after(self, since):
        return b"".join(data for at, data in list(self.cable.heard) if at >= since)


class SerialRig(LineRig):
    family, unit, mode, target = "Supermodified", "supermodified:5", "velocity", "200"
    make_cable = SerialCable
    gain, far_enough, stores_after = "gain.p", 3000, 0
    loop = ("--mode", "position", "--to", "20000", "--travel", "60000", "--duty", "1")

    def far(self):
        return "pty:" + self.cable.far

    def near(self):
        return f"serial:{self.cable.path}?baud=57600/supermodified:5"

    def first_order_is_stop(self, since):
        heard = self.after(since).lstrip(b"\0")  # zeros end the half of a frame that a pulled cable left in the node
        return heard[:2] == b"\x55\xaa" and len(heard) > 4 and heard[4] in (0x1B, 0xCB)  # addressed, or to all


class TunedRig(SerialRig):
    """A motor without a gear, which the unit's own profile leads in its proof: that is owed with the gains."""

    unit = "supermodified:5,dialect=D3,motor=rs775"
    tuning = ("--loop", "position", "--travel", "60000", "--duty", "1", "--speed", "500000", "--current", "5")
    tried = ("gain.p", "gain.d", "profile.velocity", "profile.acceleration")


class SocketRig(LineRig):
    family, unit, mode, target = "QuadQuad2Drv", "quadquad2drv:0", "duty", "0.3"
    make_cable = SocketCable

    def far(self):
        return "unix:" + self.cable.far

    def near(self):
        return f"unix:{self.cable.path}/quadquad2drv:0"

    def first_order_is_stop(self, since):
        return bool(self.after(since))  # the length of the first exchange; what it said is in the time to the stop


class TunedBoardRig(SocketRig):
    """Without the cable, which no one pulls here: what passes it on is late where others use the machine, and tells of another motor."""

    stores_after = 0
    loop = ("--mode", "velocity", "--to", "1500", "--travel", "1000000", "--speed", "5000", "--duty", "1")
    tuning = ("--loop", "velocity", "--travel", "1000000", "--speed", "5000", "--duty", "1")
    tried = ("ch1.velocity.p", "ch1.velocity.i")
    written = ("ch1.velocity.p=91", "ch1.velocity.i=92", "ch1.velocity.d=93")
    known = ("velocity.p.scale=0.01", "velocity.i.scale=0.0000355")  # which else are looked for first, for a minute or two

    def near(self):
        return f"unix:{self.cable.far}/quadquad2drv:0"


class Serial(MotionScenarios, CableScenarios, SteadyCase):
    def setUp(self):
        self.rig = SerialRig(self.control)


class SerialTrial(TrialScenarios, SteadyCase):
    def setUp(self):
        super().setUp()
        self.rig = SerialRig(self.control)


class SerialTuning(TuneScenarios, SteadyCase):
    def setUp(self):
        super().setUp()
        self.rig = TunedRig(self.control)


class Socket(MotionScenarios, CableScenarios, SteadyCase):
    def setUp(self):
        self.rig = SocketRig(self.control)


class SocketTuning(TuneScenarios, SteadyCase):
    def setUp(self):
        super().setUp()
        self.rig = TunedBoardRig(self.control)


class SerialWindow(WindowScenarios, SteadyCase):
    def setUp(self):
        self.rig = SerialRig(self.control)


class SocketWindow(WindowScenarios, SteadyCase):
    def setUp(self):
        self.rig = SocketRig(self.control)


if __name__ == "__main__":
    Rounds.control = os.path.abspath(sys.argv.pop(1))
    Rounds.window = os.path.abspath(sys.argv.pop(1))
    with ownhome.move_in():
        result = unittest.main(argv=[sys.argv[0], "-v", *sys.argv[1:]], exit=False).result
    ROWS.print()
    sys.exit(not result.wasSuccessful())
