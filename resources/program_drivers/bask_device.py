"""Drives a device for Bask: the protocol of program drivers, version 1.

Copy this file beside your own program; it needs nothing but Python 3.9. A whole robot:

    import bask_device

    class MyArm(bask_device.Robot):
        name, serial = "My arm", "A-17"
        axes = ["x", "y", "z"]
        moves = "velocity"

        def read(self):
            return self.state(position=arm.position(), moving=arm.is_moving(), sure=arm.is_homed())

        def velocity(self, rates):
            arm.set_velocity(rates)

        def stop(self):
            arm.set_velocity([0, 0, 0])

    bask_device.run(MyArm())

All quantities are in SI units: metres, radians, kelvins, seconds.

What this file does for you: it reads and checks the requests, counts and times the answers, ends a velocity or a heat
whose time is over, keeps the dead-man rule (stop and off when Bask has been silent for a second), and stops and ends at
the end of its input and at SIGTERM. An exception in one of your methods refuses the request in its own words; if it was
a command, stop() or off() is called.

Your methods are called one at a time, but for stop() and off(): if another method has not returned within 0.2 s when
the device must be made safe, they are called beside it. They must bear that, and return soon. Where Python itself does
not run (SIGSTOP, a library that holds its lock, a dead computer) nothing here helps: the device needs a watchdog of its
own.

Importing this file takes the standard input and output: what you print goes to the standard error, where people read
it, and input() finds nothing. So import it before a library that prints.
"""

import io
import json
import math
import os
import queue
import select
import signal
import sys
import threading
import time
import traceback

PROTOCOL = 1
LONGEST_LINE = 65536
AXES = ("x", "y", "z", "theta_x", "theta_y", "theta_z")
FAULTS = ("", "open", "short", "out_of_range", "other")

# As Bask's clock: it runs on while the computer is asleep.
_now = (lambda: time.clock_gettime(time.CLOCK_BOOTTIME)) if hasattr(time, "CLOCK_BOOTTIME") else time.monotonic

_SIGNALS = (signal.SIGTERM, signal.SIGINT, signal.SIGHUP)  # to end

_WATCH = 0.02  # s between two looks at the times to live, and at the input
_WAIT_FOR_METHOD = 0.2  # s; then the device is made safe beside it
_AGAIN = 0.1  # s; then stop() or off() is called again where it has failed
_END_WITHIN = 0.8  # s from the end of the input


class _Console(io.BufferedIOBase):
    """The standard error. Words that nobody reads are lost: else a print() in stop() would wait or fail when Bask has
    died, and the robot would go on."""

    lock = threading.Lock()

    def writable(self):
        return True

    def fileno(self):
        return 2

    def write(self, data):
        data = bytes(data)
        with self.lock:
            try:
                for begin in range(0, len(data), select.PIPE_BUF):  # a pipe that has room takes so much at once
                    if select.select([], [2], [], 0)[1]:
                        os.write(2, data[begin:begin + select.PIPE_BUF])
            except OSError:
                pass
        return len(data)


def _take_streams():
    """Returns the standard input and output. Libraries and child processes find nothing and the standard error instead."""
    requests, answers = os.dup(0), os.dup(1)
    if not os.isatty(0):  # a person may try this file by hand
        with open(os.devnull) as nothing:
            os.dup2(nothing.fileno(), 0)
    os.dup2(2, 1)
    sys.stdout = sys.stderr = io.TextIOWrapper(_Console(), "utf-8", "backslashreplace", line_buffering=True)
    return requests, answers


_REQUESTS, _ANSWERS = _take_streams()


class Refused(Exception):
    """Raise it to refuse a request, with words for the operator: Refused("the door is open")."""


class Device:
    """What all roles have in common."""

    role = ""
    name = ""  # the kind of the device, 1 to 80 characters
    serial = ""  # tells it from others of its kind

    def read(self):
        """Returns self.state(...), within 0.5 s. Read a slow device in a thread of its own, and give its age."""
        raise NotImplementedError

    def close(self):
        """Called at the end, after the device was made safe."""

    def _needed(self):
        return ["read"]

    def _hello(self):
        return {"protocol": PROTOCOL, "role": self.role, "name": self.name, "serial": self.serial}

    def _make_safe(self):
        pass


class Robot(Device):
    """A robot. Positions are those of the end-effector in the robot's own frame, m and rad; the rotation of
    theta_x, theta_y, theta_z is Rz(theta_z) Ry(theta_y) Rx(theta_x)."""

    role = "robot"
    axes = ()  # some of AXES, in the order of all lists below
    moves = "velocity"  # or "steps": write velocity() or step()
    can_home = False  # write home(), if it can
    limits = {}  # {"x": (-0.3, 0.3)}: the least and the greatest position of an axis, m or rad

    def velocity(self, rates):
        """Moves each axis at this rate, m/s or rad/s, until the next call of this or of stop()."""
        raise NotImplementedError

    def step(self, to, duration):
        """Begins to go straight to this position, m and rad, in about `duration` s, and stands there. A new step
        replaces it. Does not wait for its end."""
        raise NotImplementedError

    def stop(self):
        """Stands still, as soon as it can."""
        raise NotImplementedError

    def home(self):
        """Begins to find its position by its switches. Does not wait; read() tells that it moves until it is done."""
        raise Refused("this robot cannot home")

    def clear(self):
        """Clears its alarm, and takes its place for sure, after a person has looked. Never moves."""

    def state(self, position, moving, sure, alarm="", age=None):
        """position: one number an axis, m or rad. moving: until it stands. sure: False while it may not know where it
        is: after a start without homing, if it counts its steps. alarm: in words, why it does not move. age: s since the
        position was measured, if it was before this call of read()."""
        return {"position": [float(p) for p in position], "moving": _flag(moving, "moving"),
                "sure": _flag(sure, "sure"), "alarm": _words(alarm), **_age(age)}

    def _needed(self):
        return super()._needed() + ["stop", "velocity" if self.moves == "velocity" else "step"]

    def _hello(self):
        hello = {**super()._hello(), "axes": list(self.axes), "moves": self.moves, "can_home": self.can_home}
        if self.limits:
            hello["limits"] = {axis: list(pair) for axis, pair in self.limits.items()}
        return hello

    def _make_safe(self):
        self.stop()


class Thermometer(Device):
    """Sensors that are read together."""

    role = "thermometer"
    channels = 1

    def state(self, temperatures, faults=None, uncertainties=None, age=None):
        """temperatures: K, None where there is none. faults: "", "open", "short", "out_of_range" or "other" of each.
        uncertainties: standard uncertainties, K. age: s since they were measured, if it was before this call of read()."""
        out = {"temperatures": [None if t is None else float(t) for t in temperatures], **_age(age)}
        if faults is not None:
            out["faults"] = list(faults)
        if uncertainties is not None:
            out["uncertainties"] = [float(u) for u in uncertainties]
        return out

    def _hello(self):
        return {**super()._hello(), "channels": self.channels}


class Heater(Device):
    """A heat source."""

    role = "heater"
    max_temperature = 373.15  # K, the highest set point that it takes
    watchdog = False  # True if the device itself switches off when this program dies

    def heat(self, set_point):
        """Heats towards the set point, K, until the next call of this or of off()."""
        raise NotImplementedError

    def off(self):
        """Switches its heat off."""
        raise NotImplementedError

    def state(self, temperature, heating, set_point=None, age=None):
        """temperature: of the hot surface, K, None if it is not known. heating: whether its heat is switched on, as the
        device says, not as it was told. set_point: as it is read back, K. age: s since they were measured, if it was
        before this call of read()."""
        return {"temperature": None if temperature is None else float(temperature),
                "heating": _flag(heating, "heating"),
                "set_point": None if set_point is None else float(set_point), **_age(age)}

    def _needed(self):
        return super()._needed() + ["heat", "off"]

    def _hello(self):
        return {**super()._hello(), "max_temperature": self.max_temperature, "watchdog": self.watchdog}

    def _make_safe(self):
        self.off()


def _flag(value, key):
    if value not in (True, False):  # a word such as "OFF" would count as true
        raise ValueError("%s is neither True nor False" % key)
    return bool(value)


def _age(age):
    return {} if age is None else {"age": float(age)}  # without it Bask takes the time at which it asked


def _words(text):
    """Bask refuses a line with more than 1000 bytes of them."""
    return str(text).encode("utf-8", "replace")[:900].decode("utf-8", "ignore")


def _number(request, key, least=-math.inf, greatest=math.inf):
    value = request.get(key)
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
        raise Refused('"%s" is not a finite number' % key)
    if not least <= value <= greatest:
        raise Refused('"%s" is %g, allowed are %g to %g' % (key, value, least, greatest))
    return float(value)


def _numbers(request, key, count):
    values = request.get(key)
    if not isinstance(values, list) or len(values) != count:
        raise Refused('"%s" is not a list of %d numbers' % (key, count))
    return [_number({key: value}, key) for value in values]


def _no_constant(word):
    raise ValueError("%s is no number" % word)


def _check_finite(value):
    if isinstance(value, float) and not math.isfinite(value):
        raise ValueError("the state has a number that is not finite")
    for part in value.values() if isinstance(value, dict) else value if isinstance(value, list) else ():
        _check_finite(part)


class _Runner:
    def __init__(self, device):
        self.device = device
        self.requests = queue.SimpleQueue()
        self.seq = 0
        self.method = threading.Lock()  # one of the device's methods is called
        self.watching = threading.Lock()  # for what follows
        self.heard = _now()
        self.count = 0  # of the lines that came
        self.void = 0  # a motion or heat of a line up to this one is not begun any more
        self.dead_man = 1.0
        # Of a velocity or a heat; math.inf: of what ends by itself, or what an earlier start has left; None: it is safe
        self.active_until = math.inf
        self.ending = threading.Event()

    # --- Lines ---

    def write(self, line):
        text = json.dumps({**line, "seq": self.seq + 1, "time": _now()}, allow_nan=False)
        self.seq += 1  # only of a line that is written
        left = memoryview(text.encode() + b"\n")
        while left:
            left = left[os.write(_ANSWERS, left):]

    def read_lines(self, wake):
        """A line came when it was last seen that there was none: it may have waited while this process was held up."""
        poll = select.poll()
        poll.register(_REQUESTS, select.POLLIN)
        poll.register(wake, select.POLLIN)
        empty, rest = _now(), b""
        try:
            while True:
                looked = _now()
                ready = [end for end, _ in poll.poll(0)]
                if wake in ready and not set(os.read(wake, 64)).isdisjoint(_SIGNALS):
                    break
                if _REQUESTS not in ready:
                    empty = looked
                    poll.poll(1000 * _WATCH)
                    continue
                data = os.read(_REQUESTS, LONGEST_LINE)
                if not data:
                    break
                *lines, rest = (rest + data).split(b"\n")
                rest = rest[:LONGEST_LINE + 1]  # still too long when its end comes
                for line in lines:
                    self.hear(line, empty)
        finally:
            self.end()

    def hear(self, line, came):
        with self.watching:
            self.count += 1
            is_stop = b'"stop"' in line or b'"off"' in line
            if is_stop:
                self.void = self.count
            # Not behind what is under way: the watch acts if that does not return.
            if is_stop or (self.active_until is not None and came - self.heard > self.dead_man):
                self.active_until = 0.0
            self.heard = came
            self.requests.put((line, came, self.count))

    # --- Requests ---

    def take(self, line, came, count):
        self.came, self.number = came, count
        try:
            if len(line) > LONGEST_LINE:
                raise ValueError("the line is too long")
            request = json.loads(line, parse_constant=_no_constant)
            number = request["id"]
            if isinstance(number, bool) or not isinstance(number, int):
                raise ValueError("id is no whole number")
            what = request["do"]
        except (ValueError, KeyError, TypeError, RecursionError) as error:
            self.write({"id": None, "error": "not a request: %s" % error})
            return
        try:
            answer = self.obey(what, request)
            _check_finite(answer)
            self.write({"id": number, **answer})
        except Refused as refused:
            self.write({"id": number, "error": _words(refused)})
        except Exception as error:  # the user's code: whatever it is, Bask is told
            traceback.print_exc()
            self.write({"id": number, "error": _words("%s: %s" % (type(error).__name__, error))})

    def obey(self, what, request):
        device = self.device
        if what == "hello":
            if request.get("protocol") != PROTOCOL:
                raise Refused("this program speaks protocol %d" % PROTOCOL)
            if request.get("role") != device.role:
                raise Refused("this program drives a %s" % device.role)
            self.dead_man = _number({"dead_man": request.get("dead_man", 1.0)}, "dead_man", 0.05, 60.0)
            return {"hello": device._hello()}
        if what == "read":
            with self.method:
                return {"state": device.read()}
        if device.role == "robot" and what in ("velocity", "step", "stop", "home", "clear"):
            self.command_robot(what, request)
        elif device.role == "heater" and what in ("heat", "off"):
            self.command_heater(what, request)
        else:
            raise Refused('a %s does not know "%s"' % (device.role, what))
        return {"ok": True}

    def command_robot(self, what, request):
        device = self.device
        if what == "velocity":
            if device.moves != "velocity":
                raise Refused("this robot takes steps")
            rates = _numbers(request, "rates", len(device.axes))
            valid_for = _number(request, "valid_for", 0.0, 60.0)
            self.act(lambda: device.velocity(rates), valid_for)
        elif what == "step":
            if device.moves != "steps":
                raise Refused("this robot takes velocities")
            to = _numbers(request, "to", len(device.axes))
            for axis, position in zip(device.axes, to):
                least, greatest = device.limits.get(axis, (-math.inf, math.inf))
                _number({axis: position}, axis, least, greatest)
            duration = _number(request, "duration", 0.0, 60.0)
            self.act(lambda: device.step(to, duration), math.inf)
        elif what == "stop":
            self.act(device.stop, None)
        elif what == "home":
            if not device.can_home:
                raise Refused("this robot cannot home")
            self.act(device.home, math.inf)
        else:
            with self.method:
                device.clear()

    def command_heater(self, what, request):
        if what == "heat":
            set_point = _number(request, "set_point", 0.0, self.device.max_temperature)
            valid_for = _number(request, "valid_for", 0.0, 60.0)
            self.act(lambda: self.device.heat(set_point), valid_for)
        else:
            self.act(self.device.off, None)

    def act(self, method, valid_for):
        """The device is active for this time since the request came; None: it is not."""
        with self.method:
            if self.ending.is_set():
                raise Refused("the program ends")
            with self.watching:
                if valid_for is None:
                    self.active_until = 0.0  # until it is: the watch acts if the method does not return
                elif self.number <= self.void or _now() - self.came > min(valid_for, self.dead_man):
                    return  # its time is over, behind a slow request, or a stop has come after it
                else:  # before the method is called: what it begins is to be ended even if it never returns
                    self.active_until = self.came + valid_for
            try:
                method()
            except BaseException:  # it may have begun something, or ended nothing
                with self.watching:
                    self.active_until = 0.0
                raise
            if valid_for is None:
                with self.watching:
                    self.active_until = None

    # --- What ends by itself ---

    def is_due(self):
        now = _now()
        with self.watching:
            return self.active_until is not None and (
                now > self.active_until or now - self.heard > self.dead_man)

    def watch(self):
        while not self.ending.wait(_WATCH):
            if self.is_due() and not self.make_safe():
                self.ending.wait(_AGAIN)

    def make_safe(self):
        """Returns false if it has failed."""
        is_alone = self.method.acquire(timeout=_WAIT_FOR_METHOD)
        try:
            if not self.is_due() and not self.ending.is_set():
                return True  # it is safe, or was told anew
            with self.watching:
                self.active_until = 0.0
            self.device._make_safe()
            if is_alone:  # else the other method may still begin something, and it is made safe once more
                with self.watching:
                    self.active_until = None
            return True
        except BaseException:
            traceback.print_exc()
            return False
        finally:
            if is_alone:
                self.method.release()

    def end(self):
        self.ending.set()
        self.requests.put(None)

    def run(self):
        wake, signalled = os.pipe()
        os.set_blocking(signalled, False)
        for number in _SIGNALS:
            signal.signal(number, lambda *_: None)
        # Written at once, while such a function waits until a method returns from a library in C.
        signal.set_wakeup_fd(signalled, warn_on_full_buffer=False)
        for work in (lambda: self.read_lines(wake), self.watch, self.end_in_time):
            threading.Thread(target=work, daemon=True).start()
        for request in iter(self.requests.get, None):
            if self.ending.is_set():
                break
            try:
                self.take(*request)
            except OSError:  # nobody reads the answers any more
                break
            except BaseException:  # the user's code has called sys.exit()
                traceback.print_exc()
                break
        self.ending.set()
        time.sleep(2.0 * _END_WITHIN)  # the other thread ends the program

    def end_in_time(self):
        self.ending.wait()
        ended = threading.Timer(_END_WITHIN, os._exit, (1,))
        ended.daemon = True
        ended.start()
        while not self.make_safe():
            time.sleep(_AGAIN)
        if self.method.acquire(timeout=0.4):  # a method that was under way may have begun something
            self.method.release()
            self.make_safe()
        try:
            self.device.close()
        except Exception:
            traceback.print_exc()
        sys.stderr.flush()
        os._exit(0)


def run(device):
    """Speaks with Bask until the end of the input. Never returns."""
    if not isinstance(device, (Robot, Thermometer, Heater)):
        raise TypeError("a Robot, a Thermometer or a Heater is wanted")
    missing = (Device.read, Robot.velocity, Robot.step, Robot.stop, Heater.heat, Heater.off)
    for method in device._needed():  # better now than when it is to stop
        if getattr(getattr(device, method), "__func__", None) in missing:
            raise ValueError("a %s needs %s()" % (device.role, method))
    if isinstance(device, Robot) and (not device.axes or set(device.axes) - set(AXES)):
        raise ValueError("axes are some of %s" % ", ".join(AXES))
    _Runner(device).run()
