"""The programs in docs/program-*.md, as they stand there, against the devices that they are for; and bask_device.py.

    python3 pages_test.py BASK
"""

import json
import os
import random
import re
import shutil
import signal
import socketserver
import subprocess
import sys
import tempfile
import threading
import time
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BASK = sys.argv.pop(1)


class Machine:
    """Three axes at up to 50 mm/s, as the page for robots has it."""

    def __init__(self):
        self.at, self.goal, self.speed, self.seen = [0.0, 0.0, 150.0], [0.0, 0.0, 150.0], 0.0, time.monotonic()
        self.lock = threading.Lock()

    def answer(self, line):
        with self.lock:
            now = time.monotonic()
            reach, self.seen = self.speed * (now - self.seen), now
            self.at = [a + max(-reach, min(reach, g - a)) for a, g in zip(self.at, self.goal)]
            words = line.split()
            if words[0] == "MOVE":
                self.goal, self.speed = [float(w) for w in words[1:4]], min(50.0, float(words[4]))
                return "OK"
            if words[0] == "STOP":
                self.goal = list(self.at)
                return "OK"
            return "%.4f %.4f %.4f %s" % (*self.at, "STANDING" if self.at == self.goal else "MOVING")


class Controller:
    def __init__(self):
        self.set_point, self.is_on = 20.0, False

    def answer(self, line):
        words = line.split()
        if words[0] == "SP":
            self.set_point = float(words[1])
        elif words[0] in ("ON", "OFF"):
            self.is_on = words[0] == "ON"
        return {"T?": "20.0", "SP?": "%.1f" % self.set_point, "OUT?": "ON" if self.is_on else "OFF"}.get(words[0], "OK")


def serve(device):
    class Handler(socketserver.StreamRequestHandler):
        def handle(self):
            if device is None:
                while True:
                    try:
                        self.wfile.write(b"23.4 25.1\n")
                    except OSError:
                        return
                    time.sleep(0.3)
            for line in self.rfile:
                self.wfile.write((device.answer(line.decode()) + "\n").encode())

    server = socketserver.ThreadingTCPServer(("127.0.0.1", 0), Handler)
    server.daemon_threads = True
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return server.server_address[1]


class PagesTest(unittest.TestCase):
    def check(self, role, page, device, port):
        """The page's program passes `bask check-device`."""
        with open(os.path.join(ROOT, "docs", page)) as file:
            code = re.search(r"```python\n(.*?)```", file.read(), re.S).group(1)
        code, count = re.subn(r'\("192\.168\.1\.\d+"\)', '("127.0.0.1")', code)
        self.assertEqual(count, 1)
        code, count = re.subn(r"\b%d\b" % port, str(serve(device)), code)
        self.assertEqual(count, 1)
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(os.path.join(ROOT, "resources/program_drivers/bask_device.py"), folder)
            path = os.path.join(folder, "my_device.py")
            with open(path, "w") as file:
                file.write(code)
            found = subprocess.run([BASK, "check-device", "--role", role, "--", "python3", path],
                                   capture_output=True, text=True, timeout=120)
        self.assertEqual(found.returncode, 0, found.stdout + found.stderr)

    def test_robot(self):
        self.check("robot", "program-robot.md", Machine(), 9000)

    def test_thermometer(self):
        self.check("thermometer", "program-thermometer.md", None, 7000)

    def test_heater(self):
        self.check("heater", "program-heater.md", Controller(), 5000)


PROBE = """
import sys, time
import bask_device

class Probe(bask_device.Robot):
    name, axes, moves = "Probe", ["x", "y"], "velocity"
    calls = 0
    def read(self):
        print("a stray word")
        if "blocks" in sys.argv: time.sleep(3)
        if "fails" in sys.argv: raise ValueError("no answer from the arm")
        return self.state([0.0, float("nan") if "nan" in sys.argv else 0.0], moving=False, sure=True)
    def velocity(self, rates):
        self.tell("velocity", *rates)
    def stop(self):
        self.tell("stop")
    def tell(self, *words):
        sys.stderr.write("%.3f %s\\n" % (time.monotonic(), " ".join(map(str, words))))
        sys.stderr.flush()

bask_device.run(Probe())
"""


class Talk:
    def __init__(self, *options):
        self.folder = tempfile.TemporaryDirectory()
        shutil.copy(os.path.join(ROOT, "resources/program_drivers/bask_device.py"), self.folder.name)
        path = os.path.join(self.folder.name, "probe.py")
        with open(path, "w") as file:
            file.write(PROBE)
        self.errors = open(os.path.join(self.folder.name, "errors"), "w+")
        self.program = subprocess.Popen([sys.executable, path, *options], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, stderr=self.errors)
        self.number = 0
        self.ask(do="hello", protocol=1, role="robot", dead_man=1.0)

    def write(self, line):
        self.program.stdin.write(line)
        self.program.stdin.flush()

    def ask(self, **request):
        self.number += 1
        self.write(json.dumps({"id": self.number, **request}).encode() + b"\n")
        return self.answer()

    def answer(self):
        return json.loads(self.program.stdout.readline())

    def calls(self):
        """(time, name) of each call of velocity() and stop()."""
        with open(self.errors.name) as file:
            lines = [line.split() for line in file if re.match(r"\d+\.\d+ (velocity|stop)", line)]
        return [(float(words[0]), words[1]) for words in lines]

    def close(self):
        self.program.kill()
        self.program.communicate()
        self.errors.close()
        self.folder.cleanup()


class BaskDeviceTest(unittest.TestCase):
    def talk(self, *options):
        talk = Talk(*options)
        self.addCleanup(talk.close)
        return talk

    def test_counts_and_times_its_lines(self):
        talk = self.talk()
        first, second = talk.ask(do="read"), talk.ask(do="read")
        self.assertEqual((first["id"], first["seq"], second["seq"]), (2, 2, 3))
        self.assertLess(abs(second["time"] - time.clock_gettime(time.CLOCK_BOOTTIME)), 0.5)
        self.assertEqual(first["state"]["position"], [0.0, 0.0], "and a stray word is not in the way")

    def test_refuses_what_is_no_request(self):
        talk = self.talk()
        for line in (b"\n", b"no JSON\n", b"[]\n", b"{}\n", b'{"id": 7}\n', b'{"id": "x", "do": "read"}\n',
                     b"x" * 70000 + b"\n", b"\xff\xfe\n"):
            talk.write(line)
            answer = talk.answer()
            self.assertTrue(answer["id"] is None and answer["error"], line[:20])
            if len(line) > 65536:
                talk.answer()  # what is left of it is another line
        for rates in (None, 1, [1], [1, "2"], [1, True], [1, 2, 3]):
            self.assertIn("error", talk.ask(do="velocity", rates=rates, valid_for=0.3))
        talk.write(b'{"id": 99, "do": "velocity", "rates": [NaN, 0], "valid_for": 1}\n')
        self.assertIn("error", talk.answer())
        talk.write(b'{"id": 99, "do": "velocity", "rates": [1e999, 0], "valid_for": 1}\n')
        self.assertIn("error", talk.answer())
        self.assertIn("error", talk.ask(do="step", to=[0, 0], duration=1))
        self.assertIn("error", talk.ask(do="heat", set_point=300, valid_for=1))
        self.assertEqual(talk.calls(), [])

    def test_damaged_lines_move_nothing_that_they_do_not_say(self):
        talk = self.talk()
        chance = random.Random(3)
        whole = b'{"id": 5, "do": "velocity", "rates": [0.001, 0.002], "valid_for": 0.05}'
        for _ in range(20000):
            line = bytearray(whole)
            for _ in range(chance.randint(1, 4)):
                line[chance.randrange(len(line))] = chance.choice(b'0123456789{}[]",:.eE-xN')
            talk.write(bytes(line) + b"\n")
            answer = talk.answer()
            if "ok" in answer:
                request = json.loads(line)
                self.assertEqual(request["do"], "velocity")
                self.assertTrue(len(request["rates"]) == 2 and 0 <= request["valid_for"] <= 60, line)

    def test_an_exception_is_a_refusal(self):
        answer = self.talk("fails").ask(do="read")
        self.assertEqual(answer["error"], "ValueError: no answer from the arm")
        self.assertIn("not finite", self.talk("nan").ask(do="read")["error"])

    def test_a_velocity_ends_by_itself(self):
        talk = self.talk()
        began = time.monotonic()
        talk.ask(do="velocity", rates=[0.1, 0], valid_for=0.3)
        while time.monotonic() - began < 0.8:
            talk.ask(do="read")
            time.sleep(0.05)
        (_, first), (ended, last) = talk.calls()
        self.assertEqual((first, last), ("velocity", "stop"))
        self.assertTrue(0.28 < ended - began < 0.5, ended - began)

    def test_silence_stops_it(self):
        for options in ((), ("blocks",)):
            talk = self.talk(*options)
            talk.ask(do="velocity", rates=[0.1, 0], valid_for=30.0)
            heard = time.monotonic()
            if options:
                talk.write(b'{"id": 9, "do": "read"}\n')  # which takes 3 s
                heard = time.monotonic()
            time.sleep(1.6)
            stopped = [at for at, name in talk.calls() if name == "stop"]
            self.assertTrue(stopped and 0.9 < stopped[0] - heard < 1.35, (options, stopped, heard))

    def test_ends_safely(self):
        for options in ((), ("blocks",)):
            for how in ("input", signal.SIGTERM, signal.SIGINT):
                talk = self.talk(*options)
                talk.ask(do="velocity", rates=[0.1, 0], valid_for=30.0)
                if options:
                    talk.write(b'{"id": 9, "do": "read"}\n')
                    time.sleep(0.1)
                ended = time.monotonic()
                if how == "input":
                    talk.program.stdin.close()
                    talk.program.stdin = None
                else:
                    talk.program.send_signal(how)
                talk.program.wait(timeout=3)
                self.assertLess(time.monotonic() - ended, 1.0, (options, how))
                self.assertEqual(talk.calls()[-1][1], "stop", (options, how))


    def test_a_stop_does_not_wait_behind_a_slow_read(self):
        talk = self.talk("blocks")
        talk.ask(do="velocity", rates=[0.1, 0], valid_for=30.0)
        talk.write(b'{"id": 8, "do": "read"}\n')  # which takes 3 s
        time.sleep(0.1)
        talk.write(b'{"id": 9, "do": "velocity", "rates": [0.2, 0], "valid_for": 20}\n')
        talk.write(b'{"id": 10, "do": "stop"}\n')
        asked = time.monotonic()
        time.sleep(0.6)
        self.assertTrue([at for at, name in talk.calls() if name == "stop" and at - asked < 0.4], talk.calls())
        for _ in range(3):
            talk.answer()
        names = [name for _, name in talk.calls()]
        self.assertEqual(names.count("velocity"), 1, "one from before the stop is not begun")
        self.assertEqual(names[-1], "stop")


class ExamplesTest(unittest.TestCase):
    def test_serial_thermometer(self):
        main, line = os.openpty()
        program = subprocess.Popen(
            [sys.executable, os.path.join(ROOT, "resources/program_drivers/serial_thermometer.py"), os.ttyname(line),
             "--channels", "3"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        try:
            program.stdin.write(b'{"id": 1, "do": "hello", "protocol": 1, "role": "thermometer", "dead_man": 1}\n')
            program.stdin.flush()
            self.assertEqual(json.loads(program.stdout.readline())["hello"]["channels"], 3)
            os.write(main, b"garbage t0=2")
            os.write(main, b"3.5 t2=-5\r\nt1=\n")
            time.sleep(0.3)
            program.stdin.write(b'{"id": 2, "do": "read"}\n')
            program.stdin.flush()
            state = json.loads(program.stdout.readline())["state"]
            self.assertEqual(state["temperatures"], [296.65, None, 268.15])
            self.assertTrue(0.2 < state["age"] < 1.0, state)
        finally:
            program.kill()
            program.communicate()
            os.close(main)
            os.close(line)

    def test_angles_of_the_vendors_robot(self):
        sys.dont_write_bytecode = True
        sys.path.insert(0, os.path.join(ROOT, "resources/program_drivers"))
        import vendor_robot

        def times(a, b):
            return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]

        def rotation(tx, ty, tz):
            x, y, z = (vendor_robot.matrix_of(v) for v in ([tx, 0, 0], [0, ty, 0], [0, 0, tz]))
            return times(z, times(y, x))

        vector = [0.3, -0.8, 0.5]
        angles = vendor_robot.angles_of(vector)
        for row, same in zip(rotation(*angles), vendor_robot.matrix_of(vector)):
            for a, b in zip(row, same):
                self.assertAlmostEqual(a, b, 12)
        rates, dt = [0.2, -0.1, 0.3], 1e-6
        later = rotation(*(a + dt * r for a, r in zip(angles, rates)))
        before = rotation(*angles)
        change = [[(later[i][j] - before[i][j]) / dt for j in range(3)] for i in range(3)]
        spin = times(change, [list(column) for column in zip(*before)])
        for a, b in zip(vendor_robot.turning_of(angles, rates), (spin[2][1], spin[0][2], spin[1][0])):
            self.assertAlmostEqual(a, b, 5)


unittest.main(verbosity=2)
