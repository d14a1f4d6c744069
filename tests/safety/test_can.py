#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Motors on real CAN interfaces, and everything that must end their motion:

    tests/safety/test_can.py MOTORBENCHCTL [unittest options]      as root where vxcan0 and vxcan1 are up (tests/socketcan/run)

The motor has an end of the bus of its own, so that it outlives what happens to ours: vxcan1 beside vxcan0, which is switched
off, and vcan7 joined to vcan8 by the kernel's CAN gateway, where vcan8 is deleted and made again.
"""
import os
import subprocess
import sys
import time
import unittest

from bench import PATIENCE, Motor, Program
from rows import ROWS
from scenarios import ROUNDS, CableScenarios, MotionScenarios, Rounds, SteadyCase
from trials import TrialScenarios, TuneScenarios


def ip(*arguments, check=True):
    subprocess.run(["ip", "link", *arguments], check=check, timeout=PATIENCE, stderr=None if check else subprocess.DEVNULL)


class Switch:
    """An interface that is switched off and on."""

    near, far = "vxcan0", "vxcan1"

    def make(self):
        ip("set", self.near, "up")

    def pull(self):
        ip("set", self.near, "down")

    def plug_in(self):
        ip("set", self.near, "up")
        return time.time()

    def remove(self):
        ip("set", self.near, "up")


class Adapter:
    """An interface that is unplugged, and plugged in again under its name."""

    near, far = "vcan8", "vcan7"

    def join(self):
        for pair in ((self.near, self.far), (self.far, self.near)):
            subprocess.run(["cangw", "-A", "-s", pair[0], "-d", pair[1], "-e"], check=True, timeout=PATIENCE)

    def make(self):
        for name in (self.far, self.near):
            ip("add", name, "type", "vcan")
            ip("set", name, "up")
        self.join()

    def pull(self):
        ip("del", self.near)

    def plug_in(self):
        ip("add", self.near, "type", "vcan")
        self.join()
        ip("set", self.near, "up")
        return time.time()

    def remove(self):
        for name in (self.far, self.near):
            ip("del", name, check=False)


class CanRig:
    written, known = (), ()

    def __init__(self, control, cable):
        self.control = control
        self.cable = cable
        self.device = f"socketcan:{cable.near}/{self.unit}"

    def start(self):
        self.cable.make()
        self.motor = Motor(self.control, "socketcan:" + self.cable.far, self.unit)
        self.bus = Program("candump", "-L", self.cable.far)

    def end(self):
        self.motor.end()
        self.bus.end()
        self.cable.remove()

    def pull(self):
        self.cable.pull()

    def plug_in(self):
        return self.cable.plug_in()

    def orders(self):
        """(time, frame) of what the motor did not send itself; the kernel's time."""
        frames = [line.split() for line in list(self.bus.lines)]
        return [(float(stamp.strip("()")), frame) for stamp, _, frame in frames if self.is_ours(frame)]

    def first_order_is_stop(self, since):
        """The first one after the return."""
        return next((self.is_stop(frame) for at, frame in self.orders() if at >= since - 0.005), False)

    def account(self, since):
        return self.motor.account(since, self.orders())


class Dmc60cRig(CanRig):
    family, unit, mode, target, watchdog = "DMC60C", "dmc60c:5", "duty", "0.2", 0.104
    gain, far_enough, stores_after = "slot0.p", 10000, 21
    loop = ("--mode", "velocity", "--to", "60000", "--travel", "10000000", "--speed", "100000", "--duty", "1", "--current", "100")
    tuning = ("--loop", "velocity", "--travel", "10000000", "--speed", "100000", "--duty", "1", "--current", "100")
    tried = ("slot1.p", "slot1.i")  # the result is for slot 0

    def is_ours(self, frame):
        return frame.startswith("02060005#")

    def is_stop(self, frame):
        return frame.startswith("02060005#0F")


class AbstractDcRig(CanRig):
    family, unit, mode, target, watchdog = "Abstract DC Drive", "abstractdc:3", "duty", "0.3", None
    stores_after = 0
    loop = ("--mode", "velocity", "--to", "4000", "--travel", "1000000", "--speed", "12000", "--duty", "1")
    tuning = ("--loop", "velocity", "--travel", "1000000", "--speed", "12000", "--duty", "1")
    tried = ("velocity.p", "velocity.i")
    written = ("velocity.divisor=1000000", "velocity.p=20001", "velocity.i=301", "velocity.d=0")

    def is_ours(self, frame):
        return not 0x400 <= int(frame.split("#")[0], 16) < 0x480

    def is_stop(self, frame):
        return True  # what it said is in the time to the stop


class Dmc60cSwitched(MotionScenarios, CableScenarios, SteadyCase):
    def setUp(self):
        self.rig = Dmc60cRig(self.control, Switch())


@unittest.skipUnless(ROUNDS > 1, "a machine that tests meanwhile loses samples, and a guard ends the trial: scripts/soak safety")
class Dmc60cTrial(TrialScenarios, SteadyCase):
    def setUp(self):
        super().setUp()
        self.rig = Dmc60cRig(self.control, Switch())


@unittest.skipUnless(ROUNDS > 1, "a machine that tests meanwhile loses samples, and a guard ends the proof: scripts/soak safety")
class Dmc60cTuning(TuneScenarios, SteadyCase):
    def setUp(self):
        super().setUp()
        self.rig = Dmc60cRig(self.control, Switch())


class AbstractDcSwitched(MotionScenarios, CableScenarios, SteadyCase):
    def setUp(self):
        self.rig = AbstractDcRig(self.control, Switch())


class Unplugged(CableScenarios):
    cable = "the adapter is unplugged"


class AbstractDcTuning(TuneScenarios, SteadyCase):
    def setUp(self):
        super().setUp()
        self.rig = AbstractDcRig(self.control, Switch())


class Dmc60cUnplugged(Unplugged, SteadyCase):
    def setUp(self):
        self.rig = Dmc60cRig(self.control, Adapter())
        self.addCleanup(self.rig.cable.remove)


class AbstractDcUnplugged(Unplugged, SteadyCase):
    def setUp(self):
        self.rig = AbstractDcRig(self.control, Adapter())
        self.addCleanup(self.rig.cable.remove)


if __name__ == "__main__":
    Rounds.control = os.path.abspath(sys.argv.pop(1))
    result = unittest.main(argv=[sys.argv[0], "-v", *sys.argv[1:]], exit=False).result
    ROWS.print()
    sys.exit(not result.wasSuccessful())
