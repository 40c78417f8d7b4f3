"""The monitor and a broker: what is retained, the last will, and a broker that comes late.

    broker_test.py HOST_SIM
"""

import json
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import unittest

import jsonschema

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "program"))

from logs import Log, LoggedNode  # noqa: E402

HOST_SIM = ""
SKIPPED = 77


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class BrokerTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="broker-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.port = free_port()

    def start(self, *command):
        process = subprocess.Popen([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def broker(self):
        return self.start(shutil.which("mosquitto", path="/usr/sbin:/usr/bin"), "-p", self.port)

    def monitor(self, end_s):
        log = Log()
        LoggedNode(log, 5, "inspect", 612_345_678, 5_000_000).speak(0, 2)
        LoggedNode(log, 9, "normal", 10_000_000).speak(0, end_s)
        log.write(self.folder / "run.log")
        return self.start(HOST_SIM, "monitor", "--log", self.folder / "run.log", "--mqtt", f"127.0.0.1:{self.port}")

    def retained(self):
        """What a client that comes now gets at once, by topic."""
        done = subprocess.run(["mosquitto_sub", "-p", str(self.port), "-t", "tendonlife/#", "-v", "-W", "1"],
                              capture_output=True, text=True, check=False)
        lines = (line.split(" ", 1) for line in done.stdout.splitlines())
        return {topic: json.loads(payload) for topic, payload in lines}

    def eventually(self, condition, what, seconds=30):
        deadline = time.monotonic() + seconds
        while not condition(retained := self.retained()):
            if time.monotonic() > deadline:
                self.fail(f"not within {seconds} s: {what}: {retained}")
        return retained

    def assert_as_the_schema_says(self, *statuses):
        schema = json.loads(subprocess.run([HOST_SIM, "schema", "monitor"], capture_output=True, check=True).stdout)
        schema = {"$defs": schema["$defs"], "$ref": "#/$defs/mqtt_status"}
        for status in statuses:
            jsonschema.validate(status, schema, cls=jsonschema.Draft202012Validator)

    def test_each_node_is_retained_until_the_end_and_then_stale(self):
        self.broker()
        monitor = self.monitor(60)
        both = {"tendonlife/5/status", "tendonlife/9/status"}
        retained = self.eventually(lambda retained: both <= set(retained), "two nodes")
        self.assertEqual(retained["tendonlife/monitor"], {"online": True})
        five = retained["tendonlife/5/status"]
        self.assertEqual((five["state"], five["damage_percent"]), ("inspect", 61.2345678))
        self.assert_as_the_schema_says(*(retained[topic] for topic in sorted(both)))
        retained = self.eventually(lambda retained: retained["tendonlife/5/status"]["vanished"], "node 5 has vanished")
        self.assertTrue(retained["tendonlife/5/status"]["stale"])
        self.assertFalse(retained["tendonlife/9/status"]["stale"])
        monitor.terminate()
        self.assertEqual(monitor.wait(20), 0)
        retained = self.retained()
        self.assertEqual(retained["tendonlife/monitor"], {"online": False})
        self.assertTrue(retained["tendonlife/9/status"]["stale"])

    def test_the_last_will_of_a_monitor_that_is_killed(self):
        self.broker()
        monitor = self.monitor(60)
        self.eventually(lambda retained: retained.get("tendonlife/monitor") == {"online": True}, "the monitor is there")
        monitor.kill()
        self.eventually(lambda retained: retained["tendonlife/monitor"] == {"online": False}, "its last will")

    def test_a_broker_that_comes_late_and_goes_and_comes_again(self):
        monitor = self.monitor(120)
        time.sleep(1)
        self.assertIsNone(monitor.poll())
        for _ in range(2):
            broker = self.broker()
            self.eventually(lambda retained: "tendonlife/9/status" in retained, "it gets all")
            broker.kill()
            broker.wait()


if __name__ == "__main__":
    HOST_SIM = sys.argv[1]
    if not shutil.which("mosquitto", path="/usr/sbin:/usr/bin") or not shutil.which("mosquitto_sub"):
        print("SKIPPED, NOTHING WAS TESTED: mosquitto or mosquitto_sub is missing (toolchains/setup.sh all)")
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1], verbosity=2)
