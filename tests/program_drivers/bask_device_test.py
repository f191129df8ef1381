"""bask_device.py and serial_thermometer.py over real pipes, without Bask:

    python3 bask_device_test.py

Whoever waits for something waits long: only what comes too early, or never, is an error on a busy computer.
"""

import json
import math
import os
import random
import select
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAMS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "resources", "program_drivers")
LONG = 20.0  # s

# Each call of a method is a line of the file argv[1]: its time and its name, then what it was given.
PROBE = """
import ctypes, os, sys, time
sys.path.insert(0, %r)
import bask_device

CALLS = os.open(sys.argv[1], os.O_WRONLY | os.O_CREAT | os.O_APPEND)
OPTIONS = sys.argv[3:]

def tell(*words):
    os.write(CALLS, ("%%.3f %%s\\n" %% (time.clock_gettime(time.CLOCK_BOOTTIME), " ".join(map(str, words)))).encode())

def talk():
    print("a stray word")
    os.write(1, b"a word of a library\\n")
    os.system("echo a word of a child; cat")  # cat would take the requests

class Base:
    failures = 3
    def make_safe(self, word):
        if "prints" in OPTIONS: print("x" * 200000)
        if "fails" in OPTIONS and self.failures:
            self.failures -= 1
            tell("failed", word)
            raise OSError("the line is dead")
        tell(word)
        if "stop-blocks" in OPTIONS: time.sleep(1e6)
    def command(self, *words):
        tell(*words)
        for option, seconds in (("late", 1.0), ("later-than-stop", 0.4)):
            if option in OPTIONS:
                time.sleep(seconds)
                tell("begun")
        if "command-raises" in OPTIONS: raise OSError("the cable has come off")
    def read(self):
        tell("read")
        if "talks" in OPTIONS: talk()
        if "slow" in OPTIONS: time.sleep(1.0)
        if "blocks" in OPTIONS: time.sleep(1e6)
        if "blocks-in-c" in OPTIONS:  # no signal ends it
            mutex = ctypes.create_string_buffer(128)
            for _ in range(2): ctypes.CDLL(None).pthread_mutex_lock(mutex)
        if "raises" in OPTIONS: raise ValueError("no answer from the arm")
        if "raises-much" in OPTIONS: raise ValueError("\\ud800" * 100000)
        if "refuses" in OPTIONS: raise bask_device.Refused("the door is open")
        if "exits" in OPTIONS: sys.exit("the arm is gone")
        return self.told()

class Velocity(Base, bask_device.Robot):
    name, axes, moves = "Probe", ["x", "theta_z"], "velocity"
    def told(self):
        return self.state([0.0, float("nan") if "nan" in OPTIONS else 0.25], moving=False, sure=True,
                          alarm="\\u00e9" * 5000 if "wide" in OPTIONS else "")
    def velocity(self, rates): self.command("velocity", *rates)
    def stop(self): self.make_safe("stop")
    def clear(self): tell("clear")

class Steps(Velocity):
    moves, limits = "steps", {"x": (-0.1, 0.1)}
    def step(self, to, duration): self.command("step", *to, duration)

class Plate(Base, bask_device.Heater):
    name, max_temperature = "Plate", 400.0
    def told(self): return self.state(None, heating="OFF" if "word" in OPTIONS else False)
    def heat(self, set_point): self.command("heat", set_point)
    def off(self): self.make_safe("off")

class Sensors(Base, bask_device.Thermometer):
    name, channels = "Sensors", 2
    def told(self): return self.state([295.0, None], faults=["", "open"], age=0.1)

class NoStop(bask_device.Robot):
    name, axes = "No stop", ["x"]
    def read(self): pass
    def velocity(self, rates): pass

if "talks" in OPTIONS: talk()
bask_device.run(globals()[sys.argv[2]]())
""" % os.path.abspath(PROGRAMS)

ROLES = {"Velocity": "robot", "Steps": "robot", "Plate": "heater", "Sensors": "thermometer"}
VELOCITY = {"do": "velocity", "rates": [0.1, 0.0], "valid_for": 30.0}
STEP = {"do": "step", "to": [0.05, 0.0], "duration": 5.0}
HEAT = {"do": "heat", "set_point": 350.0, "valid_for": 30.0}
ACTIVE = (("Velocity", VELOCITY, "stop"), ("Plate", HEAT, "off"))


def now():
    return time.clock_gettime(time.CLOCK_BOOTTIME)


class Talk:
    """A program, and what is said with it."""

    def __init__(self, command, errors=None):
        self.errors = errors or tempfile.TemporaryFile("w+b")
        self.program = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self.errors)
        self.kept, self.number = b"", 0

    def write(self, data):
        os.write(self.program.stdin.fileno(), data)

    def send(self, **request):
        self.number += 1
        self.write(json.dumps({"id": self.number, **request}).encode() + b"\n")

    def ask(self, **request):
        self.send(**request)
        return self.answer()

    def answer(self, within=LONG):
        """None: nothing comes."""
        until = now() + within
        while b"\n" not in self.kept:
            if not select.select([self.program.stdout], [], [], max(0.0, until - now()))[0]:
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

    def hold_up(self, for_s, meanwhile):
        """Stops the process as a debugger does, or a computer that sleeps."""
        self.program.send_signal(signal.SIGSTOP)
        os.waitpid(self.program.pid, os.WUNTRACED)
        meanwhile()
        time.sleep(for_s)
        self.program.send_signal(signal.SIGCONT)

    def end(self, how="input"):
        if how == "input":
            self.program.stdin.close()
        else:
            self.program.send_signal(how)
        return self.program.wait(timeout=LONG)

    def close(self):
        self.program.kill()
        self.program.wait()
        for pipe in (self.program.stdin, self.program.stdout, self.errors):
            pipe.close()


class Case(unittest.TestCase):
    def talk(self, kind, *options, dead_man=10.0, errors=None):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        calls = os.path.join(folder.name, "calls")
        talk = Talk([sys.executable, "-B", "-c", PROBE, calls, kind, *options], errors)
        self.addCleanup(talk.close)
        talk.calls_file = calls
        if kind in ROLES:
            talk.hello = talk.ask(do="hello", protocol=1, role=ROLES[kind], dead_man=dead_man)["hello"]
        return talk

    def calls(self, talk):
        """(time, name, ...) of each call of a method but read()."""
        with open(talk.calls_file) as file:
            lines = [line.split() for line in file]
        return [(float(line[0]), *line[1:]) for line in lines if line[1] != "read"]

    def names(self, talk):
        return [name for _, name, *_ in self.calls(talk)]

    def commands(self, talk):
        """Without stop and off, which come by themselves, too."""
        return [name for name in self.names(talk) if name not in ("stop", "off")]

    def wait(self, is_so, within=LONG):
        until = now() + within
        while not is_so():
            self.assertLess(now(), until, "it does not come")
            time.sleep(0.01)

    def wait_for(self, talk, word, after):
        """Returns when a method was called that was called after another one."""
        self.wait(lambda: word in self.names(talk)[self.names(talk).index(after) + 1:])
        names = self.names(talk)
        return self.calls(talk)[names.index(word, names.index(after) + 1)][0]

    def wait_for_read(self, talk):
        def has_begun():
            with open(talk.calls_file) as file:
                return " read\n" in file.read()
        self.wait(has_begun)


class Answers(Case):
    def test_hello_and_read(self):
        robot = self.talk("Steps")
        self.assertEqual(robot.hello, {"protocol": 1, "role": "robot", "name": "Probe", "serial": "", "moves": "steps",
                                       "axes": ["x", "theta_z"], "can_home": False, "limits": {"x": [-0.1, 0.1]}})
        before, first, second = now(), robot.ask(do="read"), robot.ask(do="read")
        self.assertEqual((first["id"], first["seq"], second["id"], second["seq"]), (2, 2, 3, 3))
        self.assertTrue(before <= first["time"] <= second["time"] <= now())
        # An age of 0 would call a slow measurement new.
        self.assertEqual(first["state"], {"position": [0.0, 0.25], "moving": False, "sure": True, "alarm": ""})
        self.assertEqual(self.talk("Sensors").ask(do="read")["state"],
                         {"temperatures": [295.0, None], "faults": ["", "open"], "age": 0.1})
        plate = self.talk("Plate")
        self.assertEqual((plate.hello["max_temperature"], plate.hello["watchdog"]), (400.0, False))
        self.assertIsNone(plate.ask(do="read")["state"]["temperature"])

    def test_what_it_does_not_know_is_refused(self):
        for kind, requests in (("Velocity", ("dance", "heat", "off", "step", "home")), ("Steps", ("velocity",)),
                               ("Plate", ("velocity", "stop", "home")), ("Sensors", ("stop", "off", "clear"))):
            talk = self.talk(kind)
            for what in requests + (None, 7, [], {}, True):
                self.assertTrue(talk.ask(**{**VELOCITY, **STEP, **HEAT, "do": what})["error"], (kind, what))
            for hello in ({"protocol": 2, "role": ROLES[kind]}, {"protocol": 1, "role": "toaster"}, {}):
                self.assertIn("error", talk.ask(do="hello", **hello))
            self.assertIn("state", talk.ask(do="read"))
            self.assertEqual(self.commands(talk), [])

    def test_exceptions_are_refusals_that_bask_can_read(self):
        for option, words in (("raises", "ValueError: no answer from the arm"), ("refuses", "the door is open")):
            talk = self.talk("Velocity", option)
            for _ in range(2):
                self.assertEqual(talk.ask(do="read")["error"], words)
        self.assertTrue(self.talk("Velocity", "raises-much").ask(do="read")["error"].startswith("ValueError: ???"))
        for option, key in (("raises-much", "error"), ("wide", "state")):
            told = self.talk("Velocity", option).ask(do="read")[key]
            self.assertLessEqual(len((told if key == "error" else told["alarm"]).encode()), 1000)
        self.assertIn("not finite", self.talk("Velocity", "nan").ask(do="read")["error"])
        self.assertIn("heating", self.talk("Plate", "word").ask(do="read")["error"])

    def test_wrong_numbers_are_refused(self):
        robot, steps, plate = self.talk("Velocity"), self.talk("Steps"), self.talk("Plate")
        wrong = [None, "1", True, [], {}, math.nan, math.inf, -math.inf, 10**400]
        for value in wrong:
            self.assertIn("error", robot.ask(**{**VELOCITY, "rates": [0.1, value]}), value)
            self.assertIn("error", robot.ask(**{**VELOCITY, "valid_for": value}), value)
            self.assertIn("error", steps.ask(**{**STEP, "to": [value, 0.0]}), value)
            self.assertIn("error", steps.ask(**{**STEP, "duration": value}), value)
            self.assertIn("error", plate.ask(**{**HEAT, "set_point": value}), value)
            self.assertIn("error", plate.ask(**{**HEAT, "valid_for": value}), value)
        robot.write(b'{"id": 9, "do": "velocity", "rates": [1e999, 0], "valid_for": 1}\n')
        self.assertIn("error", robot.answer())
        for rates in wrong + [[0.1], [0.1, 0.1, 0.1], {"x": 0.1}, "00"]:
            self.assertIn("error", robot.ask(**{**VELOCITY, "rates": rates}), rates)
        for valid_for in (-0.1, 61.0):
            self.assertIn("error", robot.ask(**{**VELOCITY, "valid_for": valid_for}))
            self.assertIn("error", plate.ask(**{**HEAT, "valid_for": valid_for}))
        self.assertIn("error", steps.ask(**{**STEP, "to": [0.11, 0.0]}), "beyond its limits")
        self.assertIn("error", plate.ask(**{**HEAT, "set_point": 400.1}))
        for talk in (robot, steps, plate):
            self.assertEqual(self.commands(talk), [])

    def test_what_is_printed_is_no_line_and_children_take_no_requests(self):
        talk = self.talk("Velocity", "talks")
        for _ in range(3):
            self.assertIn("state", talk.ask(do="read"))
        for words in ("a stray word", "a word of a library", "a word of a child"):
            self.assertEqual(talk.words().count(words), 4, words)  # once before run()

    def test_a_line_that_is_too_long_is_refused_with_its_end(self):
        talk = self.talk("Velocity")
        whole = json.dumps({"id": 9, **VELOCITY}).encode() + b"\n"
        for before in (65536, 65537, 65536 + 65537, 200000, 65536):
            talk.write(b" " * before + whole)
            answer = talk.answer()
            self.assertTrue(answer["id"] is None and "too long" in answer["error"], (before, answer))
        self.assertIn("state", talk.ask(do="read"))
        self.assertEqual(self.commands(talk), [])
        talk.write(b" " * 65000 + whole)
        self.assertIn("ok", talk.answer())

    def test_half_a_line_at_the_end_is_not_acted_on(self):
        talk = self.talk("Velocity")
        talk.write(json.dumps({"id": 9, **VELOCITY}).encode())
        talk.end()
        self.assertEqual(self.commands(talk), [])

    def test_a_robot_without_stop_does_not_start(self):
        talk = self.talk("NoStop")
        self.assertEqual(talk.program.wait(timeout=LONG), 1)
        self.assertIn("a robot needs stop()", talk.words())


class MadeSafe(Case):
    def test_a_time_that_is_over_ends_it(self):
        for options in ((), ("blocks",)):
            for kind, request, word in ACTIVE:
                talk = self.talk(kind, *options)
                asked = now()
                talk.ask(**{**request, "valid_for": 0.5})
                talk.send(do="read")
                self.assertGreater(self.wait_for(talk, word, request["do"]) - asked, 0.4)

    def test_a_time_that_is_renewed_does_not(self):
        for kind, request, word in ACTIVE:
            talk = self.talk(kind)
            talk.ask(**{**request, "valid_for": 1.0})
            talk.ask(**request)
            time.sleep(1.3)
            self.assertEqual(self.names(talk)[-2:], [request["do"]] * 2)

    def test_silence_makes_it_safe(self):
        for options, active in (((), (*ACTIVE, ("Steps", STEP, "stop"))), (("blocks",), ACTIVE[:1])):
            for kind, request, word in active:
                talk = self.talk(kind, *options, dead_man=1.0)
                asked = now()
                self.assertIn("ok", talk.ask(**request))
                if options:
                    talk.send(do="read")
                self.assertGreater(self.wait_for(talk, word, request["do"]) - asked, 0.9, (kind, options))
                if not options:
                    self.assertIn("ok", talk.ask(**request), "and it goes on")
                    self.assertEqual(self.names(talk).count(request["do"]), 2)

    def test_silence_makes_safe_what_an_earlier_start_has_left(self):
        talk = self.talk("Plate", dead_man=1.0)
        self.wait(lambda: self.names(talk) == ["off"])

    def test_lines_from_before_a_hold_up_move_nothing(self):
        talk = self.talk("Velocity", dead_man=1.0)
        talk.ask(**VELOCITY)
        late = [{**VELOCITY, "valid_for": 0.3}, VELOCITY]
        talk.hold_up(1.5, lambda: [talk.send(**request) for request in late])
        for _ in late:
            self.assertIn("ok", talk.answer(), "since its time is over")
        self.wait_for(talk, "stop", "velocity")
        self.assertEqual(self.commands(talk), ["velocity"])
        talk.ask(**VELOCITY)
        self.assertEqual(self.commands(talk), ["velocity"] * 2, "and it goes on")

    def test_a_stop_does_not_wait_behind_a_slow_read(self):
        for kind, request, word in ACTIVE:
            talk = self.talk(kind, "blocks")
            talk.ask(**request)
            talk.send(do="read")
            self.wait_for_read(talk)
            talk.send(do=word)
            self.wait_for(talk, word, request["do"])

    def test_what_came_before_a_stop_is_not_begun_and_what_came_after_is(self):
        talk = self.talk("Velocity", "slow")
        lines = [{"do": "read"}, VELOCITY, {"do": "stop"}, {**VELOCITY, "rates": [0.2, 0.0]}]
        talk.write(b"".join(json.dumps({"id": 5, **line}).encode() + b"\n" for line in lines))
        for _ in lines:
            self.assertNotIn("error", talk.answer())
        begun = [call[1:] for call in self.calls(talk) if call[1] == "velocity"]
        self.assertEqual(begun, [("velocity", "0.2", "0.0")])

    def test_what_begins_late_is_ended(self):
        talk = self.talk("Velocity", "late")
        talk.ask(**{**VELOCITY, "valid_for": 0.3})
        self.wait_for(talk, "stop", "begun")

    def test_it_is_tried_again_where_it_has_failed(self):
        for kind, request, word in ACTIVE:
            talk = self.talk(kind, "fails")
            talk.ask(**request)
            self.assertEqual(talk.ask(do=word)["error"], "OSError: the line is dead")
            self.wait_for(talk, word, request["do"])
            talk = self.talk(kind, "fails")
            talk.ask(**request)
            talk.end()
            self.assertEqual(self.names(talk)[:5], [request["do"], "failed", "failed", "failed", word])

    def test_a_command_that_has_failed_is_ended(self):
        for kind, request, word in (*ACTIVE, ("Steps", STEP, "stop")):
            talk = self.talk(kind, "command-raises")
            self.assertIn("the cable", talk.ask(**request)["error"])
            self.wait_for(talk, word, request["do"])


class TheEnd(Case):
    def test_it_is_safe(self):
        for kind, request, word in ACTIVE:
            for how in ("input", signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
                talk = self.talk(kind)
                talk.ask(**request)
                self.assertEqual(talk.end(how), 0, (kind, how))
                self.assertEqual(self.names(talk)[-1], word, (kind, how))

    def test_it_is_safe_while_read_blocks(self):
        for option in ("blocks", "blocks-in-c"):
            for how in ("input", signal.SIGTERM):
                talk = self.talk("Velocity", option)
                talk.ask(**VELOCITY)
                talk.send(do="read")
                self.wait_for_read(talk)
                self.assertEqual(talk.end(how), 0, (option, how))
                self.assertEqual(self.names(talk)[-1], "stop", (option, how))

    def test_a_command_under_way_is_ended(self):
        talk = self.talk("Velocity", "later-than-stop")
        talk.send(**VELOCITY)
        self.wait(lambda: "velocity" in self.names(talk))
        talk.end()
        self.assertEqual(self.names(talk)[-1], "stop")

    def test_a_stop_that_blocks_is_no_reason_to_go_on(self):
        talk = self.talk("Velocity", "stop-blocks")
        self.assertEqual(talk.end(), 1)

    def test_a_method_that_ends_the_program_leaves_it_safe(self):
        talk = self.talk("Velocity", "exits")
        talk.ask(**VELOCITY)
        talk.send(do="read")
        talk.program.wait(timeout=LONG)
        self.assertEqual(self.names(talk)[-1], "stop")
        self.assertIn("the arm is gone", talk.words())

    def test_answers_that_nobody_reads_end_it(self):
        talk = self.talk("Velocity")
        talk.ask(**VELOCITY)
        talk.program.stdout.close()
        talk.send(do="read")
        talk.program.wait(timeout=LONG)
        self.assertEqual(self.names(talk)[-1], "stop")

    def test_pipes_that_are_full_do_not_hold_it_up(self):
        talk = self.talk("Velocity")
        talk.ask(**VELOCITY)
        for _ in range(3000):  # more than the pipe for the answers takes
            talk.send(do="read")
        talk.end()
        self.assertEqual(self.names(talk)[-1], "stop")

    def test_words_that_nobody_reads_do_not_hold_up_a_stop(self):
        for is_closed in (True, False):
            out, errors = os.pipe()
            with open(out, "rb") as nobody:
                talk = self.talk("Velocity", "prints", "fails", errors=open(errors, "wb"))
                talk.ask(**VELOCITY)
                if is_closed:
                    nobody.close()
                talk.end()
            self.assertEqual(self.names(talk)[-1], "stop", is_closed)


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
            if type(request["id"]) is not int:
                return None
            if request["do"] in ("stop", "clear"):
                return (request["do"],)
            rates = request["rates"]
            if (request["do"] == "velocity" and isinstance(rates, list) and len(rates) == 2
                    and all(map(is_number, rates)) and is_number(request["valid_for"], 0.0, 60.0)):
                return ("velocity", *(str(float(rate)) for rate in rates))
        except (ValueError, KeyError, TypeError, RecursionError):
            pass
        return None

    def lines(self, chance, count):
        whole = [json.dumps(request).encode() for request in (
            {"id": 5, **VELOCITY}, {"id": 6, "do": "velocity", "rates": [-1e-3, 2], "valid_for": 0.5},
            {"id": 8, "do": "read"}, {"id": 9, "do": "clear"})]
        whole = 4 * whole + [b'{"id": 7, "do": "stop"}']  # seldom: what came before a stop is not begun
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

    def test_damaged_lines_move_nothing_that_they_do_not_say(self):
        talk = self.talk("Velocity")
        expected, answers = [], 1
        lines = list(self.lines(random.Random(7), 20000))
        until = now() + 5.0
        for first in range(0, len(lines), 100):
            if now() > until and first >= 1000:
                break  # a busy computer tries fewer
            part = lines[first:first + 100]
            talk.write(b"".join(line + b"\n" for line in part))
            for line in part:
                answer = talk.answer()
                self.assertIsNotNone(answer, line)
                answers += 1
                self.assertEqual(answer["seq"], answers)
                said = self.said(line)
                if said is None:
                    self.assertNotIn("ok", answer, line)
                elif "ok" in answer and said != ("stop",):
                    expected.append(said)
        # What came too late, or before a stop, is answered and not begun.
        left = iter(expected)
        made = [call[1:] for call in self.calls(talk) if call[1] != "stop"]
        self.assertTrue(all(call in left for call in made), "each call is of a valid line, in their order")
        self.assertGreater(len(made), answers / 100, "valid ones are among them")
        self.assertIn("state", talk.ask(do="read"))
        talk.end()


class SerialThermometer(Case):
    def start(self, path):
        talk = Talk([sys.executable, "-B", os.path.join(PROGRAMS, "serial_thermometer.py"), path, "--channels", "3"])
        self.addCleanup(talk.close)
        talk.ask(do="hello", protocol=1, role="thermometer", dead_man=10.0)
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
            self.wait(lambda: self.temperatures(talk) == [None, None, None])
            os.close(line)
            began = now()
            os.write(main, b"3.9 t0=2")
            os.write(main, b"3.5 t2=-5\r\nt1=\nt1=nan t0=9.4.1 t0=23.4x xt0=9 t0=1e3 t7=20.0\n\xff\xfe t1=--3\n")
            self.wait(lambda: self.temperatures(talk) == [296.65, None, 268.15])
            came = now()
            time.sleep(0.5)
            state = talk.ask(do="read")["state"]
            self.assertEqual(state["faults"], ["", "other", ""])
            self.assertTrue(0.5 <= state["age"] <= now() - began, state)

            def only_one_goes_on():
                os.write(main, b"t1=25.1\n")
                time.sleep(0.1)
                return self.temperatures(talk) == [None, 298.25, None]

            self.wait(only_one_goes_on)
            self.assertGreater(now() - began, 3.0)
            self.assertGreater(now() - came, 2.5)
            os.write(main, b"t1=-127.00\n")  # a sensor that is not there
            self.wait(lambda: self.temperatures(talk) == [None, None, None], 2.5)
            os.close(main)  # the plug is pulled
            self.wait(lambda: "error" in talk.ask(do="read"))
            main, line = os.openpty()
            os.remove(path)
            os.symlink(os.ttyname(line), path)
            os.write(main, b"t0=20\nt0=20\n")
            self.wait(lambda: (self.temperatures(talk) or [None])[0] == 293.15)
            self.assertEqual(talk.end(), 0)
            os.close(main)
            os.close(line)

    def test_random_bytes_are_no_temperatures(self):
        chance = random.Random(5)
        main, line = os.openpty()
        self.addCleanup(os.close, main)
        self.addCleanup(os.close, line)
        talk = self.start(os.ttyname(line))
        self.wait(lambda: self.temperatures(talk) is not None)
        for _ in range(200):
            os.write(main, bytes(chance.choice(b"t012=.-x \r\n\xff\x00") for _ in range(200)))
            for value in self.temperatures(talk):
                self.assertTrue(value is None or 213.1 < value < 1173.2, value)

    def test_a_speed_that_no_line_has(self):
        found = subprocess.run([sys.executable, "-B", os.path.join(PROGRAMS, "serial_thermometer.py"), "/dev/null",
                                "--baud", "12345"], capture_output=True, text=True, timeout=LONG)
        self.assertEqual(found.returncode, 2)
        self.assertIn("12345", found.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
