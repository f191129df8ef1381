"""Any device, with nothing wrong: in one thread, from docs/program-driver.md alone, without bask_device.py.

Every other program in this folder is this one with a single defect. The device outlives the program, as a real
one does: what it does is kept in a file, so that the next start finds a plate that was left hot and a robot that
was left moving.
"""

import json
import math
import os
import select
import signal
import sys
import tempfile
import time
from pathlib import Path

AXES = ["x", "y", "z"]
LIMITS = {"x": [-0.3, 0.3], "y": [-0.3, 0.3], "z": [0.0, 0.5]}
ROOM = 295.0
HOTTEST = 600.0


def finite(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) < 1e300


def finite_list(values):
    return isinstance(values, list) and len(values) == len(AXES) and all(map(finite, values))


class Device:
    """An arm and a hot plate, kept in a file from one program to the next."""

    def __init__(self):
        self._file = Path(tempfile.gettempdir()) / f"bask-{Path(sys.argv[0]).stem}-{os.getuid()}.json"
        self.at, self.position, self.rates = time.monotonic(), [0.0, 0.0, 0.2], [0.0] * 3
        self.to, self.left = None, 0.0
        self.temperature, self.set_point, self.heating = ROOM, ROOM, False
        try:
            last = json.loads(self._file.read_text(encoding="utf-8"))
            if 0.0 <= self.at - last["at"] < 10.0:
                self.__dict__.update(last)
        except (OSError, ValueError, KeyError):
            pass

    def advance(self):
        dt, self.at = time.monotonic() - self.at, time.monotonic()
        self.position = [p + rate * dt for p, rate in zip(self.position, self.rates)]
        if self.to is not None:
            share = min(1.0, dt / self.left)
            self.position = [p + share * (q - p) for p, q in zip(self.position, self.to)]
            self.left -= dt
            if share == 1.0:
                self.to = None
        if self.heating:
            self.temperature += min(3.0 * dt, max(0.0, self.set_point - self.temperature))
        else:
            self.temperature += (ROOM - self.temperature) * -math.expm1(-dt / 60.0)
        self.keep()

    def keep(self):
        kept = {key: value for key, value in self.__dict__.items() if not key.startswith("_")}
        new = self._file.with_suffix(f".{os.getpid()}")
        new.write_text(json.dumps(kept), encoding="utf-8")
        os.replace(new, self._file)

    def moving(self):
        return self.to is not None or any(self.rates)

    def stop(self):
        self.advance()
        self.rates, self.to = [0.0] * 3, None
        self.keep()

    def off(self):
        self.advance()
        self.heating = False
        self.keep()


class Program:
    moves = "steps" if "steps" in sys.argv else "velocity"

    def __init__(self):
        self.device = Device()
        self.role, self.dead_man = None, 1.0
        self.seq = 0
        self.silent_at, self.expires_at = math.inf, math.inf
        self.rest = b""
        self.empty = time.monotonic()  # when nothing was there to be read: what is read next came after it

    # What goes out

    def clock(self):
        return time.clock_gettime(time.CLOCK_BOOTTIME)

    def next_seq(self):
        self.seq += 1
        return self.seq

    def write(self, data):
        sys.stdout.buffer.write(data)
        sys.stdout.buffer.flush()

    def send(self, **words):
        self.write(json.dumps(words).encode() + b"\n")

    def answer(self, request, **what):
        self.send(id=request["id"], seq=self.next_seq(), time=self.clock(), **what)

    # What comes in

    def run(self):
        signal.signal(signal.SIGTERM, self.on_term)
        while True:
            looked = time.monotonic()
            if looked >= self.silent_at:
                self.on_silence()
            if looked >= self.expires_at:
                self.on_expired()
            if select.select([0], [], [], 0.0)[0]:
                data = os.read(0, 65536)
                if not data:
                    break
                self.take(data)
            else:
                self.empty = looked
                select.select([0], [], [], 0.02)
        self.on_end()

    def on_term(self, *_):
        self.on_end()
        os._exit(0)

    def take(self, data):
        *lines, self.rest = (self.rest + data).split(b"\n")
        for line in lines:
            self.take_line(line)
        self.rest = self.rest[:65536]  # a line that is too long

    def take_line(self, line):
        try:
            request = json.loads(line.decode("utf-8"))
            if not isinstance(request["id"], int) or len(line) >= 65536:
                raise ValueError
        except (ValueError, KeyError, TypeError, RecursionError):
            self.send(id=None, seq=self.next_seq(), time=self.clock(), error="that is no request")
            return
        self.silent_at = self.empty + self.dead_man
        self.device.advance()
        self.do(request)

    def do(self, request):
        do = str(request.get("do"))
        known = {"robot": ["velocity" if self.moves == "velocity" else "step", "stop", "home", "clear"],
                 "heater": ["heat", "off"], "thermometer": [], None: []}[self.role]
        if do == "hello":
            self.on_hello(request)
        elif do == "read" and self.role:
            self.on_read(request)
        elif do in known and do not in ("stop", "off") and self.is_late(request):
            self.answer(request, ok=True)
        elif do in known:
            getattr(self, f"on_{do}")(request)
        else:
            self.on_unknown(request)

    def is_late(self, request):
        return time.monotonic() > self.empty + min(self.dead_man, self.valid_for(request))

    def on_unknown(self, request):
        self.answer(request, error="that is not known here")

    def on_hello(self, request):
        if request.get("protocol") != 1 or request.get("role") not in ("robot", "thermometer", "heater"):
            return self.answer(request, error="only protocol 1 is spoken here")
        self.role, self.dead_man = request["role"], request["dead_man"]
        self.silent_at = time.monotonic() + self.dead_man
        self.answer(request, hello=self.hello())

    def hello(self):
        words = {"protocol": 1, "role": self.role, "name": Path(sys.argv[0]).stem, "serial": "1"}
        if self.role == "robot":
            words.update(axes=AXES, moves=self.moves, can_home=True, limits=LIMITS)
        elif self.role == "thermometer":
            words.update(channels=3)
        else:
            words.update(max_temperature=HOTTEST)
        return words

    def on_read(self, request):
        self.answer(request, state=self.state())

    def state(self):
        device = self.device
        if self.role == "robot":
            return {"position": device.position, "moving": device.moving(), "sure": True, "alarm": ""}
        if self.role == "thermometer":
            return {"temperatures": [295.2, None, 301.7], "faults": ["", "open", ""]}
        return {"temperature": device.temperature, "heating": device.heating, "set_point": device.set_point}

    def valid_for(self, request):
        """Returns for how long the request is valid, infinite where it does not say so."""
        seconds = request.get("valid_for")
        return seconds if finite(seconds) and seconds > 0.0 else math.inf

    def on_velocity(self, request):
        rates, expires_at = request.get("rates"), self.empty + self.valid_for(request)
        if not finite_list(rates) or expires_at == math.inf:
            return self.answer(request, error="rates or valid_for are no numbers")
        self.device.rates, self.device.to, self.expires_at = rates, None, expires_at
        self.answer(request, ok=True)

    def on_step(self, request):
        to, duration = request.get("to"), request.get("duration")
        if not finite_list(to) or not finite(duration) or duration <= 0.0:
            return self.answer(request, error="to or duration are no numbers")
        if not all(LIMITS[axis][0] <= q <= LIMITS[axis][1] for axis, q in zip(AXES, to)):
            return self.answer(request, error="that is beyond the limits")
        self.begin_step(to, duration)
        self.answer(request, ok=True)

    def begin_step(self, to, duration):
        self.device.rates, self.device.to, self.device.left = [0.0] * 3, to, duration
        self.expires_at = math.inf

    def on_home(self, request):
        self.begin_step([0.0, 0.0, 0.2], 1.0)
        self.answer(request, ok=True)

    def on_clear(self, request):
        self.answer(request, ok=True)

    def on_stop(self, request):
        self.device.stop()
        self.answer(request, ok=True)

    def on_heat(self, request):
        set_point, expires_at = request.get("set_point"), self.empty + self.valid_for(request)
        if not finite(set_point) or set_point <= 0.0 or expires_at == math.inf:
            return self.answer(request, error="set_point or valid_for are no numbers")
        if set_point > HOTTEST:
            return self.answer(request, error="that is too hot")
        self.device.set_point, self.device.heating, self.expires_at = set_point, True, expires_at
        self.answer(request, ok=True)

    def on_off(self, request):
        self.device.off()
        self.answer(request, ok=True)

    # What happens by itself

    def halt(self):
        self.device.stop()
        self.device.off()

    def on_silence(self):
        self.silent_at = math.inf
        self.halt()

    def on_expired(self):
        self.expires_at = math.inf
        self.halt()

    def on_end(self):
        self.halt()


if __name__ == "__main__":
    Program().run()
