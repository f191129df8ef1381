"""bask_device.py and serial_thermometer.py over real pipes, without Bask:

    python3 tests/program_drivers/bask_device_test.py
"""

import json
import math
import os
import random
import re
import select
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

PROGRAMS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "resources", "program_drivers")

# Each call of a method is a line of the standard error: its time and its name, then what it was given.
PROBE = """
import os, sys, time
sys.path.insert(0, %r)
sys.dont_write_bytecode = True
import bask_device

OPTIONS = sys.argv[2:]

def tell(*words):
    os.write(2, ("@ %%.3f %%s\\n" %% (time.monotonic(), " ".join(map(str, words)))).encode())

class Base:
    failures = 1
    def make_safe(self, word):
        if "fails-once" in OPTIONS and self.failures:
            self.failures -= 1
            tell("failed", word)
            raise OSError("the line is dead")
        tell(word)
    def read(self):
        if "talks" in OPTIONS:
            print("a stray word")
            os.write(1, b"a word of a library\\n")
            os.system("echo a word of a child")
        if "blocks" in OPTIONS:
            tell("read")
            time.sleep(3.0)
        if "raises" in OPTIONS: raise ValueError("no answer from the arm")
        if "refuses" in OPTIONS: raise bask_device.Refused("the door is open")
        if "exits" in OPTIONS: sys.exit("the arm is gone")
        return self.told()

class Velocity(Base, bask_device.Robot):
    name, axes, moves = "Probe", ["x", "theta_z"], "velocity"
    def told(self):
        return self.state([0.0, float("nan") if "nan" in OPTIONS else 0.25], moving=False, sure=True)
    def velocity(self, rates):
        if "late" in OPTIONS: time.sleep(1.0)
        tell("velocity", *rates)
    def stop(self): self.make_safe("stop")
    def clear(self): tell("clear")

class Steps(Velocity):
    moves, limits = "steps", {"x": (-0.1, 0.1)}
    def step(self, to, duration): tell("step", *to, duration)

class Plate(Base, bask_device.Heater):
    name, max_temperature = "Plate", 400.0
    def told(self): return self.state(None, heating=False)
    def heat(self, set_point): tell("heat", set_point)
    def off(self): self.make_safe("off")

class Sensors(Base, bask_device.Thermometer):
    name, channels = "Sensors", 2
    def told(self): return self.state([295.0, None], faults=["", "open"], age=0.1)

bask_device.run({"velocity": Velocity, "steps": Steps, "plate": Plate, "sensors": Sensors}[sys.argv[1]]())
""" % os.path.abspath(PROGRAMS)

ROLES = {"velocity": "robot", "steps": "robot", "plate": "heater", "sensors": "thermometer"}
VELOCITY = {"do": "velocity", "rates": [0.1, 0.0], "valid_for": 30.0}
STEP = {"do": "step", "to": [0.05, 0.0], "duration": 5.0}
HEAT = {"do": "heat", "set_point": 350.0, "valid_for": 30.0}


class Talk:
    """A program, and what is said with it."""

    def __init__(self, command, role=None):
        self.errors = tempfile.TemporaryFile("w+b")
        self.program = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self.errors)
        self.kept, self.number = b"", 0
        if role:
            self.hello = self.ask(do="hello", protocol=1, role=role, dead_man=1.0)["hello"]

    def write(self, line):
        os.write(self.program.stdin.fileno(), line)

    def ask(self, **request):
        self.number += 1
        self.write(json.dumps({"id": self.number, **request}).encode() + b"\n")
        return self.answer()

    def answer(self, within=10.0):
        """None: nothing comes."""
        until = time.monotonic() + within
        while b"\n" not in self.kept:
            if not select.select([self.program.stdout], [], [], max(0.0, until - time.monotonic()))[0]:
                return None
            more = os.read(self.program.stdout.fileno(), 65536)
            if not more:
                return None
            self.kept += more
        line, self.kept = self.kept.split(b"\n", 1)
        return json.loads(line)

    def words(self):
        """The whole standard error."""
        return os.pread(self.errors.fileno(), 1 << 26, 0).decode()

    def calls(self):
        """(time, words) of each call of a method."""
        lines = [line.split() for line in self.words().splitlines() if line.startswith("@ ")]
        return [(float(line[1]), line[2:]) for line in lines]

    def names(self):
        return [words[0] for _, words in self.calls()]

    def end(self, how="input"):
        """Returns how long it takes."""
        began = time.monotonic()
        if how == "input":
            self.program.stdin.close()
        else:
            self.program.send_signal(how)
        self.program.wait(timeout=5)
        return time.monotonic() - began

    def close(self):
        self.program.kill()
        self.program.wait()
        for pipe in (self.program.stdin, self.program.stdout, self.errors):
            pipe.close()


class Case(unittest.TestCase):
    def talk(self, kind, *options):
        talk = Talk([sys.executable, "-c", PROBE, kind, *options], ROLES[kind])
        self.addCleanup(talk.close)
        return talk

    def waits(self, is_so, within):
        until = time.monotonic() + within
        while not is_so() and time.monotonic() < until:
            time.sleep(0.01)
        return is_so()


class Answers(Case):
    def test_hello_and_read(self):
        robot = self.talk("steps")
        self.assertEqual((robot.hello["protocol"], robot.hello["role"], robot.hello["name"], robot.hello["axes"]),
                         (1, "robot", "Probe", ["x", "theta_z"]))
        self.assertEqual((robot.hello["moves"], robot.hello["limits"]), ("steps", {"x": [-0.1, 0.1]}))
        first, second = robot.ask(do="read"), robot.ask(do="read")
        self.assertEqual((first["id"], first["seq"], second["id"], second["seq"]), (2, 2, 3, 3))
        self.assertLessEqual(first["time"], second["time"])
        self.assertEqual(first["state"]["position"], [0.0, 0.25])
        state = self.talk("sensors").ask(do="read")["state"]
        self.assertEqual((state["temperatures"], state["faults"], state["age"]), ([295.0, None], ["", "open"], 0.1))
        plate = self.talk("plate")
        self.assertEqual((plate.hello["max_temperature"], plate.hello["watchdog"]), (400.0, False))
        self.assertIsNone(plate.ask(do="read")["state"]["temperature"])

    def test_what_it_does_not_know_is_refused(self):
        for kind, requests in (("velocity", ("dance", "heat", "off", "step", "home")), ("steps", ("velocity",)),
                               ("plate", ("velocity", "stop", "home")), ("sensors", ("stop", "off", "clear"))):
            talk = self.talk(kind)
            for what in requests + (None, 7, [], {}, True):
                request = {**VELOCITY, **STEP, **HEAT, "do": what}
                self.assertTrue(talk.ask(**request)["error"], (kind, what))
            for hello in ({"protocol": 2, "role": ROLES[kind]}, {"protocol": 1, "role": "toaster"}, {}):
                self.assertIn("error", talk.ask(do="hello", **hello))
            self.assertIn("state", talk.ask(do="read"))
            self.assertEqual(talk.names(), [])

    def test_exceptions_are_refusals(self):
        for option, words in (("raises", "ValueError: no answer from the arm"), ("refuses", "the door is open")):
            talk = self.talk("velocity", option)
            for _ in range(2):
                self.assertEqual(talk.ask(do="read")["error"], words)
        self.assertIn("not finite", self.talk("velocity", "nan").ask(do="read")["error"])

    def test_wrong_numbers_are_refused(self):
        robot, steps, plate = self.talk("velocity"), self.talk("steps"), self.talk("plate")
        wrong = [None, "1", True, [], {}, math.nan, math.inf, -math.inf, 10 ** 400]
        for value in wrong:
            self.assertIn("error", robot.ask(**{**VELOCITY, "rates": [0.1, value]}), value)
            self.assertIn("error", robot.ask(**{**VELOCITY, "valid_for": value}), value)
            self.assertIn("error", steps.ask(**{**STEP, "to": [value, 0.0]}), value)
            self.assertIn("error", steps.ask(**{**STEP, "duration": value}), value)
            self.assertIn("error", plate.ask(**{**HEAT, "set_point": value}), value)
            self.assertIn("error", plate.ask(**{**HEAT, "valid_for": value}), value)
        for rates in wrong + [[0.1], [0.1, 0.1, 0.1], {"x": 0.1}, "00"]:
            self.assertIn("error", robot.ask(**{**VELOCITY, "rates": rates}), rates)
        for time_s in (-0.1, 61.0):
            self.assertIn("error", robot.ask(**{**VELOCITY, "valid_for": time_s}))
            self.assertIn("error", plate.ask(**{**HEAT, "valid_for": time_s}))
        self.assertIn("error", steps.ask(**{**STEP, "to": [0.11, 0.0]}), "beyond its limits")
        self.assertIn("error", plate.ask(**{**HEAT, "set_point": 400.1}))
        for talk in (robot, steps, plate):
            self.assertEqual(talk.names(), [])

    def test_what_is_printed_goes_to_the_standard_error(self):
        talk = self.talk("velocity", "talks")
        for _ in range(3):
            self.assertIn("state", talk.ask(do="read"))
        for words in ("a stray word", "a word of a library", "a word of a child"):
            self.assertEqual(talk.words().count(words), 3, words)

    def test_a_line_that_is_too_long_is_refused_with_its_end(self):
        talk = self.talk("velocity")
        whole = json.dumps({"id": 9, **VELOCITY}).encode() + b"\n"
        for before in (65536, 65537, 65536 + 65537, 200000):
            talk.write(b" " * before + whole)
            while (answer := talk.answer(0.3)) is not None:
                self.assertTrue(answer["id"] is None and answer["error"], before)
            self.assertEqual(talk.names(), [], before)
        self.assertIn("state", talk.ask(do="read"))
        self.assertIn("ok", talk.ask(**VELOCITY))


class MadeSafe(Case):
    def test_a_time_that_is_over_ends_it(self):
        for kind, request, word in (("velocity", VELOCITY, "stop"), ("plate", HEAT, "off")):
            talk = self.talk(kind)
            began = time.monotonic()
            for _ in range(5):  # each one renews it
                talk.ask(**{**request, "valid_for": 0.3})
                time.sleep(0.1)
            last = time.monotonic() - 0.1
            while time.monotonic() - began < 1.2:
                talk.ask(do="read")
                time.sleep(0.05)
            self.assertEqual(talk.names(), 5 * [request["do"]] + [word])
            self.assertTrue(0.25 < talk.calls()[-1][0] - last < 0.6, talk.calls())

    def test_silence_makes_it_safe(self):
        for kind, request, word in (("velocity", VELOCITY, "stop"), ("steps", STEP, "stop"), ("plate", HEAT, "off")):
            talk = self.talk(kind)
            self.assertIn("ok", talk.ask(**request))
            heard = time.monotonic()
            self.assertTrue(self.waits(lambda: word in talk.names(), 2.0), kind)
            self.assertTrue(0.9 < talk.calls()[-1][0] - heard < 1.2, (kind, talk.calls()))

    def test_silence_makes_it_safe_while_read_blocks(self):
        for kind, request, word in (("velocity", VELOCITY, "stop"), ("plate", HEAT, "off")):
            talk = self.talk(kind, "blocks")
            self.assertIn("ok", talk.ask(**request))
            talk.write(b'{"id": 9, "do": "read"}\n')
            heard = time.monotonic()
            self.assertTrue(self.waits(lambda: word in talk.names(), 2.5), kind)
            made = next(at for at, words in talk.calls() if words[0] == word)
            self.assertTrue(0.9 < made - heard < 1.35, (kind, made - heard))  # 1 s, and 0.2 s for read() to return

    def test_the_end_makes_it_safe(self):
        for kind, request, word in (("velocity", VELOCITY, "stop"), ("plate", HEAT, "off")):
            for options in ((), ("blocks",)):
                for how in ("input", signal.SIGTERM, signal.SIGINT):
                    talk = self.talk(kind, *options)
                    talk.ask(**request)
                    if options:
                        talk.write(b'{"id": 9, "do": "read"}\n')
                        self.assertTrue(self.waits(lambda: "read" in talk.names(), 2.0))
                    self.assertLess(talk.end(how), 1.0, (kind, options, how))
                    self.assertEqual(talk.names()[-1], word, (kind, options, how))

    def test_it_is_tried_again_where_it_has_failed(self):
        for kind, request, word in (("velocity", VELOCITY, "stop"), ("plate", HEAT, "off")):
            talk = self.talk(kind, "fails-once")
            talk.ask(**request)
            self.assertEqual(talk.ask(do=word)["error"], "OSError: the line is dead")
            self.assertTrue(self.waits(lambda: talk.names()[-1] == word, 0.8), talk.names())
            talk = self.talk(kind, "fails-once")
            talk.ask(**request)
            self.assertLess(talk.end(), 1.0)
            self.assertEqual(talk.names()[:3], [request["do"], "failed", word])

    def test_what_begins_late_is_ended(self):
        talk = self.talk("velocity", "late")  # by 1 s
        talk.write(json.dumps({"id": 9, **VELOCITY, "valid_for": 0.3}).encode() + b"\n")
        self.assertTrue(self.waits(lambda: "velocity" in talk.names(), 3.0))
        self.assertTrue(self.waits(lambda: talk.names()[-1] == "stop", 0.8), talk.names())

    def test_a_method_that_ends_the_program_leaves_it_safe(self):
        talk = self.talk("velocity", "exits")
        talk.ask(**VELOCITY)
        talk.write(b'{"id": 9, "do": "read"}\n')
        talk.program.wait(timeout=2)
        self.assertEqual(talk.names()[-1], "stop")
        self.assertIn("the arm is gone", talk.words())


class Damage(Case):
    """Nothing is acted on that is not a valid request, whatever comes."""

    def said(self, line):
        """The call that a line may lead to."""
        def no(word):
            raise ValueError

        def is_number(value, least=-math.inf, greatest=math.inf):
            return type(value) in (int, float) and abs(value) < 1e308 and least <= value <= greatest

        try:
            request = json.loads(line, parse_constant=no)
            if type(request["id"]) is not int or len(line) >= 65536:
                return None
            if request["do"] in ("stop", "clear"):
                return [request["do"]]
            rates = request["rates"]
            if (request["do"] == "velocity" and isinstance(rates, list) and len(rates) == 2
                    and all(map(is_number, rates)) and is_number(request["valid_for"], 0.0, 60.0)):
                return ["velocity", *(str(float(rate)) for rate in rates)]
        except (ValueError, KeyError, TypeError, RecursionError):
            pass
        return None

    def lines(self, chance, count):
        whole = [json.dumps(request).encode() for request in (
            {"id": 5, **VELOCITY}, {"id": 6, "do": "velocity", "rates": [-1e-3, 2], "valid_for": 0.5},
            {"id": 8, "do": "read"}, {"id": 9, "do": "clear"})]
        whole = 4 * whole + [b'{"id": 7, "do": "stop"}']  # seldom: what came before a stop is refused
        signs = b'0123456789{}[]",:.eE+-xN \\tnful'
        for _ in range(count):
            line = bytearray(chance.choice(whole))
            kind = chance.randrange(8)
            if kind == 0:
                line = bytearray(chance.randbytes(chance.randrange(200)))
            elif kind == 1:
                line = bytearray(chance.choice(signs) for _ in range(chance.randrange(80)))
            elif kind == 2:
                del line[chance.randrange(len(line)):]
            elif kind == 3:
                other = chance.choice(whole)
                line = line[:chance.randrange(len(line))] + other[chance.randrange(len(other)):]
            elif kind == 4:
                line = bytearray(b"[" * (3000 if chance.random() < 0.01 else chance.randrange(100)))
            elif kind < 7:
                for _ in range(chance.randint(1, 3)):
                    line[chance.randrange(len(line))] = chance.choice(signs)
            yield bytes(line).replace(b"\n", b"")

    def test_twenty_thousand_lines(self):
        talk = self.talk("velocity")
        expected, answers, answered = [], 0, 0
        lines = list(self.lines(random.Random(7), 20000))
        for first in range(0, len(lines), 100):  # few at a time: a request that had to wait is refused
            part = lines[first:first + 100]
            talk.write(b"".join(line + b"\n" for line in part))
            for line in part:
                answer = talk.answer()
                self.assertIsNotNone(answer, line)
                answers += 1
                self.assertEqual(answer["seq"], answers + 1)
                said = self.said(line)
                if said and "ok" in answer:
                    expected.append(said)
                    answered += 1
                elif said is None:
                    self.assertNotIn("ok", answer, line)
        made = [words for _, words in talk.calls()]
        # It stops by itself, too, when a velocity's time is over.
        self.assertEqual([words for words in made if words[0] != "stop"],
                         [words for words in expected if words[0] != "stop"])
        self.assertGreater(answered, 500, "valid ones are among them")
        self.assertIn("state", talk.ask(do="read"))
        self.assertLess(talk.end(), 1.0)


class SerialThermometer(Case):
    def start(self, path):
        talk = Talk([sys.executable, "-B", os.path.join(PROGRAMS, "serial_thermometer.py"), path, "--channels", "3"],
                    "thermometer")
        self.addCleanup(talk.close)
        return talk

    def temperatures(self, talk):
        return talk.ask(do="read").get("state", {}).get("temperatures")

    def test_over_a_pseudo_terminal(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "port")
            talk = self.start(path)
            self.assertIn("No such file", talk.ask(do="read")["error"])
            main, line = os.openpty()
            os.symlink(os.ttyname(line), path)
            self.assertTrue(self.waits(lambda: self.temperatures(talk) == [None, None, None], 2.0))
            os.close(line)
            os.write(main, b"3.9 t0=2")
            os.write(main, b"3.5 t2=-5\r\nt1=\nt1=nan t0=9.4.1 t0=23.4x xt0=9 t0=1e3 t7=20.0\n\xff\xfe t1=--3\n")
            self.assertTrue(self.waits(lambda: self.temperatures(talk) == [296.65, None, 268.15], 1.0))
            came = time.monotonic()
            state = talk.ask(do="read")["state"]
            self.assertEqual(state["faults"], ["", "other", ""])
            self.assertTrue(0.0 <= state["age"] < 0.5, state)
            while time.monotonic() - came < 1.5:  # only one goes on; the oldest tells the age
                os.write(main, b"t1=25.1\n")
                time.sleep(0.1)
            state = talk.ask(do="read")["state"]
            self.assertEqual(state["temperatures"][1], 298.25)
            self.assertTrue(1.3 < state["age"] < 2.2, state)
            while time.monotonic() - came < 3.3:
                os.write(main, b"t1=25.1\n")
                time.sleep(0.1)
            state = talk.ask(do="read")["state"]
            self.assertEqual(state["temperatures"], [None, 298.25, None])
            self.assertLess(state["age"], 0.5)
            os.write(main, b"t1=-127.00\n")  # a sensor that is not there
            self.assertTrue(self.waits(lambda: self.temperatures(talk) == [None, None, None], 1.0))
            os.close(main)  # the plug is pulled
            self.assertTrue(self.waits(lambda: "error" in talk.ask(do="read"), 1.0))
            main, line = os.openpty()
            os.remove(path)
            os.symlink(os.ttyname(line), path)
            os.write(main, b"t0=20\nt0=20\n")
            self.assertTrue(self.waits(lambda: (self.temperatures(talk) or [None])[0] == 293.15, 3.0))
            self.assertLess(talk.end(), 1.0)
            os.close(main)
            os.close(line)

    def test_random_bytes_are_no_temperatures(self):
        chance = random.Random(5)
        main, line = os.openpty()
        self.addCleanup(os.close, main)
        self.addCleanup(os.close, line)
        talk = self.start(os.ttyname(line))
        self.assertTrue(self.waits(lambda: self.temperatures(talk) is not None, 2.0))
        for _ in range(200):
            os.write(main, bytes(chance.choice(b"t012=.-x \r\n\xff\x00") for _ in range(200)))
            state = talk.ask(do="read")["state"]
            for value in state["temperatures"]:
                self.assertTrue(value is None or 213.1 < value < 1173.2, value)

    def test_a_speed_that_no_line_has(self):
        found = subprocess.run([sys.executable, "-B", os.path.join(PROGRAMS, "serial_thermometer.py"), "/dev/null",
                                "--baud", "12345"], capture_output=True, text=True, timeout=10)
        self.assertEqual(found.returncode, 2)
        self.assertIn("12345", found.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
