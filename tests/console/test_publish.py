# SPDX-License-Identifier: GPL-3.0-or-later
"""watch --to: samples to a UDP listener and to a real MQTT broker of the test's own."""
import json
import pathlib
import shutil
import signal
import socket
import subprocess
import tempfile
import threading
import time

import contract
from contract import CIM, LIMIT, ContractTest, Run

BROKER = shutil.which("mosquitto", path="/usr/sbin:/usr/local/sbin:/usr/bin")
SUBSCRIBER = shutil.which("mosquitto_sub")


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Listener(threading.Thread):
    """Takes datagrams until it is told to end."""

    def __init__(self):
        super().__init__(daemon=True)
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 20)
        self.socket.bind(("127.0.0.1", 0))
        self.socket.settimeout(0.2)
        self.port = self.socket.getsockname()[1]
        self.ended = False
        self.got = []

    def run(self):
        while True:
            try:
                self.got.append(json.loads(self.socket.recv(65536)))
            except socket.timeout:
                if self.ended:
                    self.socket.close()
                    return

    def end(self):
        self.ended = True
        self.join(LIMIT)


class Broker:
    """mosquitto on loopback, as whoever runs the test."""

    def __init__(self, folder, port=None):
        self.port = port or free_port()
        settings = pathlib.Path(folder) / "broker.conf"
        settings.write_text(f"listener {self.port} 127.0.0.1\nallow_anonymous true\n", encoding="utf-8")
        self.process = subprocess.Popen([BROKER, "-c", str(settings)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        end = time.monotonic() + LIMIT
        while True:
            try:
                socket.create_connection(("127.0.0.1", self.port), 1).close()
                return
            except OSError:
                if time.monotonic() > end or self.process.poll() is not None:
                    raise
                time.sleep(0.02)

    def stop(self):
        self.process.send_signal(signal.SIGTERM)
        self.process.wait(LIMIT)


class Udp(ContractTest):
    def test_every_sample_is_a_datagram_that_plotjuggler_reads(self):
        listener = Listener()
        listener.start()
        lines = self.run_json("watch", CIM, "--channel", "duty", "--channel", "velocity", "--for", "1", "--to", f"udp://127.0.0.1:{listener.port}")
        listener.end()
        self.assertEqual(len(lines), 1, "samples go there instead of standard output")
        self.assertEqual(lines[0]["summary"]["samples"], len(listener.got))
        self.assertGreater(len(listener.got), 20)
        for row in listener.got:
            self.assertEqual(set(row), {"timestamp", "dmc60c:5"})
            self.assertTrue(set(row["dmc60c:5"]) <= {"duty", "velocity"})
        times = [row["timestamp"] for row in listener.got]
        self.assertEqual(times, sorted(times))

    def test_nobody_there_is_counted_and_ends_nothing(self):
        run = Run(["watch", CIM, "--channel", "duty", "--for", "0.5", "--to", f"udp://127.0.0.1:{free_port()}"])
        self.assertEqual(run.status, 0, run.err)
        self.assertRegex(run.err, r"\d+ samples could not be sent")

    def test_what_is_no_address_is_wrong_usage(self):
        for to in ("", "http://host/x", "udp://host", "udp://:5", "udp://host:0", "udp://host:70000", "udp://host:1x", "mqtt://host",
                   "mqtt://host/", "mqtt://host/a/#", "mqtt:///topic", "mqtt://host:/topic"):
            if to:
                self.assert_error(2, "watch", CIM, "--for", "0.1", "--to", to)


class SilentHost:
    """Its queue of connections is full: who comes next gets no answer at all, not even that there is none."""

    def __init__(self):
        self.listener = socket.socket()
        self.listener.bind(("127.0.0.1", 0))
        self.listener.listen(0)
        self.port = self.listener.getsockname()[1]
        self.waiting = []
        for _ in range(8):
            client = socket.socket()
            client.setblocking(False)
            client.connect_ex(("127.0.0.1", self.port))
            self.waiting.append(client)

    def connecting(self):
        """How many wait for an answer to their first packet."""
        rows = [line.split() for line in pathlib.Path("/proc/net/tcp").read_text(encoding="ascii").splitlines()[1:]]
        return sum(row[2].endswith(f":{self.port:04X}") and row[3] == "02" for row in rows)

    def close(self):
        for client in [*self.waiting, self.listener]:
            client.close()


class Silent(ContractTest):
    """Kept waiting for minutes by the kernel, unless the program has a limit of its own."""

    def setUp(self):
        self.host = SilentHost()
        self.address = f"mqtt://127.0.0.1:{self.host.port}/bench"

    def tearDown(self):
        self.host.close()

    def test_a_host_that_says_nothing_is_given_up_after_the_timeout(self):
        self.assertGreater(self.host.connecting(), 0)
        self.assert_error(5, "--timeout", "0.5", "watch", CIM, "--for", "0.1", "--to", self.address, says="does not answer")

    def test_a_host_that_says_nothing_holds_up_no_signal(self):
        before = self.host.connecting()
        watch = subprocess.Popen([contract.PROGRAM, "--timeout", "3600", "watch", CIM, "--to", self.address],
                                 stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        end = time.monotonic() + LIMIT
        while self.host.connecting() == before and time.monotonic() < end:
            time.sleep(0.02)
        watch.send_signal(signal.SIGINT)
        _, err = watch.communicate(timeout=LIMIT)
        self.assertIn("interrupted", err)


class Mqtt(ContractTest):
    def setUp(self):
        if not BROKER or not SUBSCRIBER:
            self.skipTest("no mosquitto here")
        self.folder = tempfile.TemporaryDirectory()

    def tearDown(self):
        self.folder.cleanup()

    def test_a_broker_gets_every_sample_under_its_topic(self):
        broker = Broker(self.folder.name)
        subscriber = subprocess.Popen([SUBSCRIBER, "-h", "127.0.0.1", "-p", str(broker.port), "-t", "bench/#", "-t", "ready", "-v"],
                                      stdout=subprocess.PIPE, text=True)
        try:
            # it listens once it gets what was kept for it
            subprocess.run(["mosquitto_pub", "-h", "127.0.0.1", "-p", str(broker.port), "-t", "ready", "-r", "-m", "yes"], check=True, timeout=LIMIT)
            self.assertEqual(subscriber.stdout.readline().strip(), "ready yes")
            lines = self.run_json("watch", CIM, "--channel", "duty", "--for", "1", "--to", f"mqtt://127.0.0.1:{broker.port}/bench/one")
            count = lines[-1]["summary"]["samples"]
            self.assertGreater(count, 20)
            rows = [subscriber.stdout.readline() for _ in range(count)]
        finally:
            subscriber.kill()
            subscriber.wait(LIMIT)
            subscriber.stdout.close()
            broker.stop()
        for row in rows:
            topic, text = row.split(" ", 1)
            self.assertEqual(topic, "bench/one/dmc60c:5/duty")
            self.assertEqual(set(json.loads(text)), {"t", "channel", "value", "unit"})

    def test_no_broker_is_a_link_that_cannot_be_opened(self):
        self.assert_error(5, "watch", CIM, "--for", "0.1", "--to", f"mqtt://127.0.0.1:{free_port()}/bench", says="broker")

    def test_a_broker_that_goes_loses_counted_samples_and_ends_nothing(self):
        broker = Broker(self.folder.name)
        watch = subprocess.Popen([contract.PROGRAM, "--json", "watch", CIM, "--channel", "duty", "--for", "3", "--to",
                                  f"mqtt://127.0.0.1:{broker.port}/bench"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        subscriber = subprocess.Popen([SUBSCRIBER, "-h", "127.0.0.1", "-p", str(broker.port), "-t", "bench/#", "-C", "1"], stdout=subprocess.DEVNULL)
        subscriber.wait(LIMIT)  # samples flow
        broker.stop()
        out, err = watch.communicate(timeout=LIMIT)
        self.assertEqual(watch.returncode, 0, err)
        self.assertGreater(json.loads(out.splitlines()[-1])["summary"]["samples"], 20)
