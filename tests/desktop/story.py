# SPDX-License-Identifier: GPL-3.0-or-later
"""What the story "tame it in a minute" shows of itself, and what must be in the notebook after it."""
import json
import os
import re
import subprocess

from desktop import Missing, wait

TUNING = 240.0  # seconds, of a tuning and its proof of flash on a busy computer
PAUSE = 0.5  # seconds between two looks at a window that drives a motor


def steps(program):
    """The strip's line, "Select done  ·  2. Arm  ·  Step"; empty where no story is played."""
    label = program.find("label", r"\d\. |done  ·") if program.find("frame", "^Guide$") else None
    return label.name if label else ""


def await_step(program, name, limit=TUNING):
    """Also ends where the motor was stopped meanwhile: the story would wait for somebody who arms it again."""
    def reached():
        stopped = program.find("push button", "^Arm button: STOPPED")
        if stopped:
            raise Missing(f"step {name} of the story: stopped, {stopped.description}")
        return re.search(rf"\d\. {name}\b", steps(program))
    try:
        wait(f"step {name} of the story", reached, limit, PAUSE)
    except Missing as missing:
        raise Missing(f"{missing}; it shows '{steps(program)}'") from None


def await_done(program):
    guide = wait("the end of the story",
                 lambda: next((node for node in program.all() if node.name == "Guide" and node.description.startswith("Done.")), None),
                 TUNING, PAUSE)
    print(guide.description)


def verify_kept(path):
    """The console program, another process, finds the trials; the newest was proved with the gains that were kept."""
    console = os.path.join(os.path.dirname(path), "motorbenchctl")
    kept = json.loads(subprocess.run([console, "--json", "--quiet", "trials"], check=True, capture_output=True, text=True).stdout)
    velocity = [trial for trial in kept["trials"] if trial["mode"] == "velocity" and trial["reason"] == "done"]
    first, last = velocity[0], velocity[-1]
    assert first["metrics"]["overshoot"] > 0.1, first
    assert last["metrics"]["overshoot"] <= 0.05, last
    assert first["gains"] != last["gains"], last
    print(f"{len(velocity)} steps, overshoot {first['metrics']['overshoot']:.2f} at first, {last['metrics']['overshoot']:.2f} at last")
