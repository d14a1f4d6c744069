#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""kill_service.py PROGRAM SOURCE KILLS [vcan]: a queue of simulated units in another process, killed at random moments and resumed each time.
Afterwards every unit must answer, each has passed once, and no number was given twice. On a pseudo terminal, or on vcan0."""
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

AVRDUDE = """#!/bin/sh
echo "avrdude: AVR device initialized and ready to accept instructions" >&2
sleep 0.3
printf 'Writing | ################################################## | 100%% 0.01s\\n' >&2
echo "avrdude: 6 bytes of flash written" >&2
sleep 0.3
printf 'Reading | ################################################## | 100%% 0.01s\\n' >&2
echo "avrdude: 6 bytes of flash verified" >&2
echo "avrdude done.  Thank you." >&2
"""


def on_terminal(folder):
    """Nodes of a Supermodified line, with an avrdude of our own."""
    programs = os.path.join(folder, "bin")
    os.makedirs(programs)
    with open(os.path.join(programs, "avrdude"), "w", encoding="utf-8") as file:
        file.write(AVRDUDE)
    os.chmod(file.name, 0o755)
    os.environ["PATH"] = programs + ":" + os.environ["PATH"]
    with open(os.path.join(folder, "node.hex"), "w", encoding="ascii") as file:
        file.write(":060000000C942000FFCF6C\n:00000001FF\n")
    terminal = os.path.join(folder, "tty")
    units = [f"supermodified:{node}" for node in range(4, 10)]
    recipe = {"recipe": 1, "name": "kills", "family": "supermodified", "firmware": {"file": "node.hex", "via": "avrdude:arduino:/dev/null"},
              "parameters": {"file": "base.json"},
              "test": {"loop": "position", "to": 200, "time": 0.8, "limits": {"travel": 4000, "speed": 40000, "duty": 1}}}
    return f"serial:{terminal}?baud=57600", "pty:" + terminal, units, recipe, {"gain.p": {"raw": 900}}


def on_can(folder, source):
    shutil.copy(os.path.join(source, "resources/firmware/dmc60c-demo.hex"), folder)
    units = [f"dmc60c:{number},firmware=1.23" for number in (5, 6, 7)]
    recipe = {"recipe": 1, "name": "kills", "family": "dmc60c", "firmware": {"file": "dmc60c-demo.hex"}, "parameters": {"file": "base.json"},
              "number": {"first": 20}}
    return "socketcan:vcan0", "socketcan:vcan0", units, recipe, {"slot1.d": {"raw": 77}}


def main():
    program, source, kills = sys.argv[1], sys.argv[2], int(sys.argv[3])
    folder = tempfile.mkdtemp()
    os.environ["XDG_DATA_HOME"] = os.path.join(folder, "data")
    link, line, units, recipe, values = on_can(folder, source) if "vcan" in sys.argv else on_terminal(folder)
    for name, content in (("recipe.json", recipe), ("base.json", {"family": recipe["family"], "parameters": values})):
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            json.dump(content, file)
    simulator = subprocess.Popen([program, "simulate", "--on", line, *units], stdout=subprocess.PIPE, text=True)
    assert json.loads(simulator.stdout.readline())["ready"]
    command = [program, "--json", "--quiet", "service", os.path.join(folder, "recipe.json"), link, "--resume"]
    seed = int.from_bytes(os.urandom(4), "big")
    moments = random.Random(seed)
    done = 0
    try:
        while done < kills:
            running = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            try:
                running.wait(moments.uniform(0.3, 4.0))
                shutil.rmtree(os.environ["XDG_DATA_HOME"]) # all were done: once more from the beginning
            except subprocess.TimeoutExpired:
                running.send_signal(signal.SIGKILL)
                running.wait()
                done += 1
                time.sleep(0.3)
        ended = subprocess.run(command, capture_output=True, text=True, timeout=600, check=False)
        entries = json.loads(subprocess.run([program, "--json", "journal"], capture_output=True, text=True, check=True).stdout)["entries"]
        found = json.loads(subprocess.run([program, "--json", "scan", link], capture_output=True, text=True, check=True).stdout)["devices"]
    finally:
        simulator.terminate()
        simulator.wait()
    names = [entry["unit"] for entry in entries]
    passed = sum(entry["result"] == "passed" for entry in entries)
    reached = sum(row["family"] == recipe["family"] and row["state"] == "online" for row in found)
    numbers = [row["address"] for row in found]
    print(f"service: {done} kills (seed {seed}), {len(units)} units: {passed} passed, {len(names) - len(set(names))} twice, {reached} answer, "
          f"{len(numbers) - len(set(numbers))} numbers twice")
    good = ended.returncode == 0 and passed == len(units) == reached and len(set(names)) == len(names)
    if not good:
        print(ended.stdout, ended.stderr, json.dumps(entries, indent=1))
    shutil.rmtree(folder)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
