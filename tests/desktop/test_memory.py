# SPDX-License-Identifier: GPL-3.0-or-later
"""What the window keeps in memory on a real desktop, with the demo open and nothing recorded."""
import re
import sys

import desktop

desktop.enter()

from desktop import Program  # noqa: E402

MOST = 120.0  # MB


def resident(process):
    with open(f"/proc/{process}/status", encoding="ascii") as status:
        return int(re.search(r"VmRSS:\s+(\d+) kB", status.read())[1]) / 1024.0


def main(path):
    with Program(path, "--demo") as program:
        program.await_("table cell", "^DMC60C #7")
        program.await_("table cell", "^Supermodified #5")
        program.await_("table cell", "^QuadQuad2Drv #0")
        with open(f"/proc/{program.process.pid}/maps", encoding="utf-8") as maps:
            drivers = sorted(set(re.findall(r"\S*(?:libLLVM|libGLX_|/dri/)\S*", maps.read())))
        used = resident(program.process.pid)
        print(f"{used:.0f} MB resident, a screen reader listens")
        assert not drivers, drivers
        assert used <= MOST, used


main(sys.argv[1])
