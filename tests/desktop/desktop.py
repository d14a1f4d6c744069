# SPDX-License-Identifier: GPL-3.0-or-later
"""A desktop of its own for a test: X server, window manager, session bus, accessibility bus, and the program on it.

A test script begins with `desktop.enter()`, which starts the script anew under Xvfb and dbus-run-session; what it opens there is
found by what a screen reader is told (`Program.find`), touched by a real mouse and keyboard (xdotool), and waited for with a
limit. Needs the system's Python, whose gi module speaks to the bus."""
import collections
import functools
import os
import re
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import ownhome  # noqa: E402 pylint: disable=wrong-import-position

INNER = "MOTORBENCH_DESKTOP"
SCREEN = "1600x1000"
PATIENCE = 60.0  # seconds, for what takes a moment on an idle computer
NEEDED = ["Xvfb", "dbus-run-session", "openbox", "xdotool"]


def enter():
    """Returns inside the desktop only; outside it ends with the status of the script inside."""
    if INNER in os.environ:
        return
    missing = [name for name in NEEDED if not shutil.which(name)]
    if missing:
        sys.exit(f"desktop: {', '.join(missing)} missing; scripts/install-packages test installs it")
    reads, writes = os.pipe()
    with tempfile.TemporaryDirectory() as home:
        server = subprocess.Popen(["Xvfb", "-displayfd", str(writes), "-screen", "0", SCREEN + "x24", "-dpi", "96", "-noreset", "-nolisten", "tcp",
                                   "-fbdir", home], pass_fds=[writes], stderr=subprocess.DEVNULL)
        os.close(writes)
        display = os.read(reads, 16).decode().strip()
        if not display:
            sys.exit("desktop: Xvfb did not start")
        environment = {name: value for name, value in os.environ.items() if not name.startswith(("XDG_", "QT_", "DBUS_"))}
        environment.update({INNER: "1", "DISPLAY": ":" + display, "LC_ALL": "C.UTF-8", "HOME": home,
                            "QT_QPA_PLATFORM": "xcb", "QT_LINUX_ACCESSIBILITY_ALWAYS_ON": "1", "NO_AT_BRIDGE": "0"})
        own = {**ownhome.folders(home), "XDG_RUNTIME_DIR": os.path.join(home, "run")}
        environment.update(own)
        for folder in own.values():
            os.mkdir(folder, 0o700)
        try:
            with open(os.path.join(home, "said"), "w+", encoding="utf-8", errors="replace") as said:
                status = subprocess.call(["dbus-run-session", "--", sys.executable, "-B", *sys.argv], env=environment, stderr=said)
                said.seek(0)
                if status or os.environ.get("MOTORBENCH_VERBOSE"):
                    print(said.read(), flush=True)
        finally:
            server.terminate()
            server.wait()
    sys.exit(status)


if INNER in os.environ:
    import gi
    gi.require_version("Atspi", "2.0")
    from gi.repository import Atspi, GLib


class Missing(AssertionError):
    """What was waited for did not come."""


def wait(what, condition, limit=PATIENCE, pause=0.02):
    """The first true value of condition(); accessible events are taken meanwhile. The window is asked, so what a motor depends on is
    asked seldom."""
    end = time.monotonic() + limit
    while True:
        settle()
        try:
            value = condition()
        except GLib.Error:  # something that went while it was asked
            value = None
        if value:
            return value
        if time.monotonic() > end:
            raise Missing(f"{what}: not within {limit:.0f} s")
        time.sleep(pause)


def settle(limit=0.1):
    """Takes the events that wait; a program that shows live values never stops to tell of them."""
    end = time.monotonic() + limit
    while GLib.MainContext.default().iteration(False) and time.monotonic() < end:
        pass


def xdo(*words):
    subprocess.run(["xdotool", *map(str, words)], check=True, stdout=subprocess.DEVNULL)


def press(*keys):
    xdo("key", *keys)


def colours(left, top, width, height, step=4):
    """How much of a part of the screen has which colour, 0xRRGGBB to a share: of what the X server shows now."""
    with open(os.path.join(os.environ["HOME"], "Xvfb_screen0"), "rb") as file:
        screen = file.read()  # X window dump: a header, a table of colours, rows of 32 bits a pixel
    header = struct.unpack(">25I", screen[:100])
    size, order, bits, row, entries = header[0], header[7], header[11], header[12], header[19]
    assert bits == 32, bits
    found = collections.Counter()
    for y in range(top, top + height, step):
        start = size + 12 * entries + y * row
        line = struct.unpack(("<" if order == 0 else ">") + f"{row // 4}I", screen[start:start + row])
        found.update(pixel & 0xffffff for pixel in line[left:left + width:step])
    return {colour: count / found.total() for colour, count in found.items()}


class Node:
    """Something that the bus tells of: role, name, states, place on the screen."""

    def __init__(self, thing):
        self.thing = thing

    @property
    def name(self):
        return self.thing.get_name() or ""

    @property
    def description(self):
        return self.thing.get_description() or ""

    @functools.cached_property
    def role(self):
        return self.thing.get_role_name()

    def has(self, *states):
        """All of them, by one question to the bus."""
        told = self.thing.get_state_set()
        return all(told.contains(getattr(Atspi.StateType, state.upper())) for state in states)

    @property
    def shown(self):
        return self.has("showing", "visible")

    @property
    def box(self):
        """x, y, width, height in pixels of the screen."""
        place = self.thing.get_extents(Atspi.CoordType.SCREEN)
        return place.x, place.y, place.width, place.height

    @property
    def parent(self):
        return Node(self.thing.get_parent())

    def children(self):
        for index in range(self.thing.get_child_count()):
            child = self.thing.get_child_at_index(index)
            if child is not None:
                yield Node(child)

    def walk(self, depth=0):
        """All that is shown, this one first; of long tables and trees what is in sight."""
        if depth > 1 and not self.shown:
            return
        yield self
        if depth < 40:
            for child in self.children():
                yield from child.walk(depth + 1)

    def center(self):
        x, y, width, height = self.box
        return x + width // 2, y + height // 2

    def point(self):
        xdo("mousemove", "--sync", *self.center())

    def click(self):
        self.point()
        xdo("click", 1)

    def __str__(self):
        return f"{self.role} '{self.name}' at {self.box}"


KINDS = ["object:property-change:accessible-name", "object:property-change:accessible-description", "object:state-changed:focused"]


class Program:
    """The window's program on this desktop, from its start until it is told to end."""

    def __init__(self, path, *arguments):
        self.manager = subprocess.Popen(["openbox", "--sm-disable"], stderr=subprocess.DEVNULL)  # a second one ends at once
        wait("a window manager", lambda: subprocess.run(  # which loses a window that is mapped while it starts
            ["xdotool", "get_desktop"], capture_output=True, check=False).returncode == 0)
        self.process = subprocess.Popen([path, "--language", "en", *arguments])
        # A program that is asked before it has told the bus of all its parts answers no more.
        wait("its window on the screen", lambda: subprocess.run(
            ["xdotool", "search", "--onlyvisible", "--pid", str(self.process.pid)], capture_output=True, check=False).stdout)
        self.heard_from = []
        self.focus = None
        self.listener = Atspi.EventListener.new(self._heard)
        for kind in KINDS:
            self.listener.register(kind)
        self.root = wait("the program on the accessibility bus", self._root)
        self.window = wait("its window", lambda: self.find("frame", "^MotorBench$"))
        wait("its window in front", lambda: self.window.has("active") or self._activate())

    def _activate(self):
        """The window manager may be later than the window."""
        time.sleep(0.2)
        subprocess.run(["xdotool", "search", "--onlyvisible", "--pid", str(self.process.pid), "windowactivate"],
                       capture_output=True, check=False)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for kind in KINDS:
            self.listener.deregister(kind)
        for process in (self.process, self.manager):
            process.terminate()
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.send_signal(signal.SIGKILL)
            self.process.wait()
        self.manager.wait()

    def _root(self):
        desktop = Atspi.get_desktop(0)
        for index in range(desktop.get_child_count()):
            application = desktop.get_child_at_index(index)
            if application and application.get_process_id() == self.process.pid and application.get_child_count():
                return Node(application)
        return None

    def _heard(self, event):
        """Keeps from whom it came and asks nothing: that would only make more events."""
        if event.type != "object:state-changed:focused":
            self.heard_from.append((event.type.rsplit("-", 1)[-1], event.source))
        elif event.detail1:
            self.focus = Node(event.source)

    def windows(self):
        """Window and dialogs that are shown, the newest last."""
        return [window for window in self.root.children() if window.shown]

    def all(self, within=None):
        for start in [within] if within else self.windows():
            yield from start.walk(1)

    def find(self, role, name, within=None):
        """The first thing shown of this role whose name matches; None where there is none."""
        for node in self.all(within):
            if node.role == role and re.search(name, node.name):
                return node
        return None

    def await_(self, role, name, within=None, limit=PATIENCE):
        return wait(f"{role} '{name}'", lambda: self.find(role, name, within), limit)

    def await_enabled(self, role, name, within=None, limit=PATIENCE):
        def enabled():
            node = self.find(role, name, within)
            return node if node and node.has("enabled") else None
        return wait(f"{role} '{name}', enabled", enabled, limit)

    def tab(self, key="Tab"):
        """What has the focus after Tab; the same as before where Tab led to nothing else."""
        before, self.focus = self.focus, None
        press(key)
        try:
            wait("another focus", lambda: self.focus, 2)
        except Missing:
            self.focus = before
        return self.focus

    def dialog(self, title):
        return wait(f"dialog '{title}'", lambda: next(
            (window for window in self.windows() if window.role != "frame" and re.search(title, window.name)), None))

    def heard(self, words, since=0):
        """Whether an event since then came from something whose name or description matches now."""
        asked = set()
        for kind, source in self.heard_from[since:]:
            if source is None or (kind, hash(source)) in asked:
                continue
            asked.add((kind, hash(source)))
            try:
                said = source.get_name() if kind == "name" else source.get_description()
            except GLib.Error:
                continue
            if said and re.search(words, said):
                return said
        return None
