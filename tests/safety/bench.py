# SPDX-License-Identifier: GPL-3.0-or-later
"""A simulated controller in a process of its own, the cable to it, and the program that drives its motor.

The simulator tells when its output goes on and off, in Unix time of this machine; that is the truth here, not what a program says of it.
"""
import json
import os
import pathlib
import select
import signal
import socket
import subprocess
import tempfile
import threading
import time
import sys
import tty

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import steady  # noqa: E402 pylint: disable=wrong-import-position

PATIENCE = 30.0


class Program:
    """A running program whose lines of output are kept."""

    def __init__(self, *command, environment=None):
        self.lines = []
        self.changed = threading.Condition()
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment)
        self.threads = [threading.Thread(target=self.read, args=(stream,), daemon=True)
                        for stream in (self.process.stdout, self.process.stderr)]
        for thread in self.threads:
            thread.start()

    def read(self, stream):
        for line in stream:
            with self.changed:
                self.lines.append(line.rstrip("\n"))
                self.changed.notify_all()
            if stream is self.process.stderr:
                steady.complaints.append(line)

    def wait_for(self, fits, since=0, patience=PATIENCE):
        """The first line from `since` on that fits; None when it does not come."""
        deadline = time.monotonic() + patience
        with self.changed:
            while True:
                for line in self.lines[since:]:
                    if fits(line):
                        return line
                left = deadline - time.monotonic()
                if left <= 0:
                    return None
                self.changed.wait(min(left, 0.2))

    def send(self, number):
        self.process.send_signal(number)

    def is_running(self):
        return self.process.poll() is None

    def end(self, number=signal.SIGTERM):
        """Its exit status; killed when it does not end."""
        if self.is_running():
            self.process.send_signal(number)
        try:
            status = self.process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            self.process.kill()
            status = self.process.wait()
        for thread in self.threads:
            thread.join()
        self.process.stdout.close()
        self.process.stderr.close()
        return status


class Motor:
    """`motorbenchctl simulate` on a link, with one unit."""

    def __init__(self, control, link, unit):
        self.program = Program(control, "--json", "simulate", "--on", link, unit, "--events")
        if not self.program.wait_for(lambda line: '"ready":true' in line):
            raise AssertionError(f"the simulator did not start: {self.program.lines}")

    def events(self):
        """(time, on?) of each change of the output; the four of a board count as one."""
        found = []
        for line in list(self.program.lines):
            if '"output-o' in line:
                event = json.loads(line)
                found.append((event["t"], event["event"] == "output-on"))
        return found

    def gains(self):
        """As the unit itself has them, raw, since it was last written to: of one whose wire cannot tell them."""
        written = [line for line in list(self.program.lines) if '"gains-written"' in line]
        return json.loads(written[-1])["gains"] if written else {}

    def await_gains(self, wanted):
        """Until it has these."""
        return self.program.wait_for(lambda line: '"gains-written"' in line and wanted.items() <= json.loads(line)["gains"].items())

    def is_on(self):
        return self.events()[-1:] != [] and self.events()[-1][1]

    def await_output(self, on, since, patience=PATIENCE):
        """When the output went on or off for good as far as is known, after `since`."""
        deadline = time.monotonic() + patience
        while time.monotonic() < deadline:
            fitting = [at for at, state in self.events() if at >= since and state == on]
            if fitting and self.is_on() == on:
                return fitting[0]
            time.sleep(0.002)
        return None

    def stays_off(self, seconds):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if self.is_on():
                return False
            time.sleep(0.01)
        return True

    def account(self, since, orders):
        """What its output did, and the orders that came, by the time of each from `since` on."""
        lines = [(at, "output on" if on else "output off") for at, on in self.events()] + orders
        return "; ".join(f"{1000 * (at - since):.1f} ms {what}" for at, what in sorted(lines) if at >= since)

    def end(self):
        self.program.end()


class Cable:
    """What lies between the program and the simulator; `path` is where the program finds it. It can be pulled and plugged in."""

    def __init__(self):
        self.folder = tempfile.TemporaryDirectory()
        self.far = os.path.join(self.folder.name, "far")
        self.path = os.path.join(self.folder.name, "near")
        self.heard = []  # (time, bytes) from the program
        self.plugged = threading.Event()
        self.ended = False
        self.thread = None

    def start(self):
        self.plugged.set()
        self.thread = threading.Thread(target=self.run, daemon=True)
        self.thread.start()

    def pull(self):
        """Yields when nothing passes any more."""
        self.plugged.clear()
        while os.path.lexists(self.path):
            time.sleep(0.001)

    def plug_in(self):
        """Yields when the program can open its end again."""
        self.plugged.set()
        while not os.path.lexists(self.path):
            time.sleep(0.001)
        return time.time()

    def end(self):
        self.ended = True
        self.plugged.set()
        self.thread.join(5)
        self.folder.cleanup()


class SerialCable(Cable):
    """A pair of terminals. Pulled, the program's terminal is gone, as with a USB adapter; the simulator's end stays."""

    def run(self):
        far = os.open(self.far, os.O_RDWR | os.O_NOCTTY)
        tty.setraw(far)
        while not self.ended:
            self.plugged.wait()
            if self.ended:
                break
            near, slave = os.openpty()
            tty.setraw(slave)
            name = os.ttyname(slave)
            os.symlink(name, self.path)
            os.close(slave)
            while self.plugged.is_set() and not self.ended:
                for source in select.select([near, far], [], [], 0.005)[0]:
                    try:
                        data = os.read(source, 4096)
                    except OSError:  # nobody has the terminal open
                        time.sleep(0.002)
                        continue
                    if source == near:
                        self.heard.append((time.time(), data))
                    try:
                        os.write(far if source == near else near, data)
                    except OSError:  # nobody hears it
                        pass
            os.close(near)
            os.unlink(self.path)
        os.close(far)


class SocketCable(Cable):
    """A socket passed on. Pulled, connections are closed and nobody listens; the simulator's board keeps running."""

    def run(self):
        while not self.ended:
            self.plugged.wait()
            if self.ended:
                break
            listener = socket.socket(socket.AF_UNIX)
            listener.bind(self.path)
            listener.listen()
            self.serve(listener)
            listener.close()
            os.unlink(self.path)

    def serve(self, listener):
        pairs = {}
        while self.plugged.is_set() and not self.ended:
            for source in select.select([listener, *pairs], [], [], 0.005)[0]:
                if source is listener:
                    near, _ = listener.accept()
                    far = socket.socket(socket.AF_UNIX)
                    try:
                        far.connect(self.far)
                    except OSError:  # the simulator has ended; a guardian may still look for it
                        near.close()
                        far.close()
                        continue
                    pairs[near], pairs[far] = (far, True), (near, False)
                    continue
                if source not in pairs:
                    continue
                other, ours = pairs[source]
                try:
                    data = source.recv(4096)
                    if data:
                        if ours:
                            self.heard.append((time.time(), data))
                        other.sendall(data)
                        continue
                except OSError:
                    pass
                for end in (source, other):
                    pairs.pop(end, None)
                    end.close()
        for end in pairs:
            end.close()


def source_tree():
    return pathlib.Path(__file__).resolve().parents[2]
