"""The programs in docs/program-*.md, as they stand there, against the devices that they are for; and the angles of the
vendor's robot.

    python3 pages_test.py BASK
"""

import os
import re
import shutil
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


class HomingMachine:
    """Four axes, one of which tilts; its place is not known before it was homed."""

    def __init__(self):
        self.at, self.goal, self.speed = [12.0, -8.0, 170.0, 3.0], [12.0, -8.0, 170.0, 3.0], 0.0
        self.seen, self.homing, self.homed = time.monotonic(), False, False
        self.lock = threading.Lock()

    def answer(self, line):
        with self.lock:
            now = time.monotonic()
            left = max(abs(g - a) for a, g in zip(self.at, self.goal))
            share = min(1.0, self.speed * (now - self.seen) / left) if left > 0.0 else 1.0
            self.seen = now
            self.at = [a + share * (g - a) for a, g in zip(self.at, self.goal)]
            if share == 1.0:
                self.at = list(self.goal)
                self.homed, self.homing = self.homed or self.homing, False
            words = line.split()
            if words[0] == "POS?":
                return "%.4f %.4f %.4f %.4f" % tuple(self.at)
            if words[0] == "STATUS?":
                motion = "HOMING" if self.homing else "IDLE" if self.at == self.goal else "BUSY"
                return motion + (" HOMED" if self.homed else " UNHOMED")
            if words[0] == "HOME":
                self.goal, self.speed, self.homing, self.homed = [0.0, 0.0, 150.0, 0.0], 60.0, True, False
            elif words[0] == "STOP":
                self.goal, self.homing = list(self.at), False
            else:
                goal, speed = [float(w) for w in words[1:5]], float(words[5])
                if not self.homed or not 50.0 <= goal[2] <= 250.0 or speed > 60.0:
                    return "ERROR not homed" if not self.homed else "ERROR range"
                self.goal, self.speed = goal, speed
            return "OK"


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
    def check(self, role, page, device, port, *options, programs=1):
        """The page's program passes `bask check-device`; of several the last, which continues those before it."""
        with open(os.path.join(ROOT, "docs", page)) as file:
            parts = re.findall(r"```python\n(.*?)```", file.read(), re.S)[:programs]
        run = r'bask_device\.run\(\w+\("192\.168\.1\.\d+"\)\)\n'
        code = "".join(re.sub(run, "", part) for part in parts[:-1]) + parts[-1]
        code, count = re.subn(r'\("192\.168\.1\.\d+"\)', '("127.0.0.1")', code)
        self.assertEqual(count, 1)
        for attempt in range(3):  # a machine that stands still for a second breaks any program's promises
            own, count = re.subn(r"\b%d\b" % port, str(serve(device and device())), code)
            self.assertEqual(count, 1)
            with tempfile.TemporaryDirectory() as folder:
                shutil.copy(os.path.join(ROOT, "resources/program_drivers/bask_device.py"), folder)
                path = os.path.join(folder, "my_device.py")
                with open(path, "w") as file:
                    file.write(own)
                found = subprocess.run([BASK, "check-device", "--role", role, *options, "--", "python3", path],
                                       capture_output=True, text=True, timeout=120)
            if found.returncode == 0:
                return found.stdout
        self.fail(found.stdout + found.stderr)

    def test_robot(self):
        said = self.check("robot", "program-robot.md", Machine, 9000)
        self.assertIn("z goes 1 mm, from 150 mm to 151 mm", said)

    def test_robot_that_homes_and_tilts(self):
        said = self.check("robot", "program-robot.md", HomingMachine, 9000, "--home", programs=2)
        self.assertIn("theta_x goes 0.573 degrees", said)

    def test_thermometer(self):
        self.check("thermometer", "program-thermometer.md", None, 7000)

    def test_heater(self):
        self.check("heater", "program-heater.md", Controller, 5000)


class ExamplesTest(unittest.TestCase):
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
