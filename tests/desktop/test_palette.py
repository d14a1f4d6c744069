# SPDX-License-Identifier: GPL-3.0-or-later
"""The window on the screen has the colours of the desktop where it is told to follow them, and black where it is told to be of high
contrast: pixels of what the X server shows."""
import os
import sys

import desktop

desktop.enter()

from desktop import Program, colours, wait  # noqa: E402

LEAST = 0.5  # of the window; the rest is text, edges, buttons
DARK = {"window": (36, 20, 52), "view": (26, 12, 40), "text": (240, 236, 244)}
LIGHT = {"window": (244, 236, 214), "view": (255, 250, 236), "text": (30, 24, 10)}


def be_desktop(palette):
    """As Plasma keeps its colours, which Qt reads without a plugin."""
    triple = {key: ",".join(map(str, value)) for key, value in palette.items()}
    lines = []
    for group in "Window", "View", "Button", "Tooltip", "Selection":
        ground = "view" if group == "View" else "window"
        lines += [f"[Colors:{group}]", f"BackgroundNormal={triple[ground]}", f"BackgroundAlternate={triple[ground]}",
                  f"ForegroundNormal={triple['text']}"]
    with open(os.path.join(os.environ["XDG_CONFIG_HOME"], "kdeglobals"), "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")
    os.environ.update({"XDG_CURRENT_DESKTOP": "KDE", "KDE_FULL_SESSION": "true", "KDE_SESSION_VERSION": "5"})


def verify(path, palette, theme, expected):
    be_desktop(palette)
    with Program(path, "--theme", theme) as program:
        wanted = {red << 16 | green << 8 | blue for red, green, blue in expected}

        def share():
            return sum(part for colour, part in colours(*program.window.box).items() if colour in wanted)
        try:
            wait("the window in these colours", lambda: share() > LEAST, 20)
        finally:
            names = sorted(((part, f"{colour:06x}") for colour, part in colours(*program.window.box).items()), reverse=True)[:4]
            print(f"--theme {theme}: {share():.0%} of the window is as expected; most of it: {names}", flush=True)


def main(path):
    verify(path, DARK, "system", [DARK["window"], DARK["view"]])
    verify(path, LIGHT, "system", [LIGHT["window"], LIGHT["view"]])
    verify(path, LIGHT, "contrast", [(0, 0, 0)])


main(sys.argv[1])
