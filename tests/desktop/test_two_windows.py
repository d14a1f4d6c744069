# SPDX-License-Identifier: GPL-3.0-or-later
"""Two windows on one serial line: the first drives, the second says who has it, and opens it once the first has gone."""
import os
import re
import subprocess
import sys
import tempfile

import desktop

desktop.enter()

from desktop import Program, press, wait  # noqa: E402


def listening(process):
    """Sockets of this process that others could reach from outside: TCP that listens, UDP that is open to everybody."""
    folder = f"/proc/{process}/fd"
    ours = {os.readlink(os.path.join(folder, one)) for one in os.listdir(folder)}
    found = []
    for kind, states in (("tcp", ("0A",)), ("tcp6", ("0A",)), ("udp", ("07",)), ("udp6", ("07",))):
        if not os.path.exists(f"/proc/{process}/net/{kind}"):
            continue
        with open(f"/proc/{process}/net/{kind}", encoding="ascii") as table:
            for row in [line.split() for line in list(table)[1:]]:
                if row[3] in states and f"socket:[{row[9]}]" in ours:
                    found.append(f"{kind} {row[1]}")
    return found


def says(program, words):
    return next((node.name for node in program.all() if re.search(words, node.name) or re.search(words, node.description)), None)


def main(path):
    console = os.path.join(os.path.dirname(path), "motorbenchctl")
    with tempfile.TemporaryDirectory() as folder:
        line = os.path.join(folder, "line")
        unit = subprocess.Popen([console, "simulate", "--on", f"pty:{line}?baud=57600", "supermodified:4"], stdout=subprocess.PIPE)
        assert b'"ready":true' in unit.stdout.readline()
        link = f"serial:{line}?baud=57600"
        try:
            with Program(path, "--link", link) as first:
                first.await_("table cell", "^Supermodified #4")
                assert not listening(first.process.pid), listening(first.process.pid)
                assert not listening(unit.pid), listening(unit.pid)
                print("neither window nor simulator listens to a network")
                with Program(path, "--link", link) as second:
                    press("ctrl+8")  # the log
                    words = rf"MotorBench, process {first.process.pid}\b|motorbench, process {first.process.pid}\b"
                    print("the second says:", wait("the second to say who has it", lambda: says(second, words)))
                    assert not second.find("table cell", "^Supermodified #4")
                assert first.find("table cell", "^Supermodified #4"), "the first goes on"
        finally:
            unit.terminate()
            unit.wait()


main(sys.argv[1])
