# SPDX-License-Identifier: GPL-3.0-or-later
"""test_console.py PROGRAM SOURCE: what motorbenchctl promises, verb by verb, on simulated devices."""
import sys

import contract
from test_board import BoardTest  # noqa: F401
from test_abstractdc import AbstractDc  # noqa: F401
from hostile import Hostile  # noqa: F401
from test_devices import DeviceVerbs  # noqa: F401
from test_motion import Motion  # noqa: F401
from test_plot import Plot  # noqa: F401
from test_publish import Mqtt, Udp  # noqa: F401
from test_serial import SerialTest  # noqa: F401
from test_supermodified import SupermodifiedTest  # noqa: F401
from test_traffic import Replay, Traffic  # noqa: F401
from test_usage import Usage  # noqa: F401

if __name__ == "__main__":
    contract.PROGRAM, contract.SOURCE = sys.argv[1:3]
    sys.exit(contract.main(sys.argv[3:]))
