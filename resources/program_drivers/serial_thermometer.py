"""A thermometer on a serial line that prints lines such as "t0=23.4 t1=25.1" (degrees Celsius) by itself.

    python3 serial_thermometer.py /dev/ttyUSB0 --channels 2 [--baud 115200]

Needs nothing but Python: the line is set up by termios. Another form of line is one change, in values_in().
"""

import argparse
import os
import re
import termios
import threading
import time

import bask_device

FRESH = 3.0  # s; an older value is none


def values_in(line):
    """The channels in a line: {0: 23.4, 1: 25.1}."""
    return {int(channel): float(value) for channel, value in re.findall(r"\bt(\d+)=(-?\d+(?:\.\d+)?)\b", line)}


def open_line(path, baud):
    """A serial line of 8 bits without parity, as the bytes come."""
    line = os.open(path, os.O_RDONLY | os.O_NOCTTY)
    speed = getattr(termios, "B%d" % baud)
    control = termios.tcgetattr(line)[6]
    control[termios.VMIN], control[termios.VTIME] = 1, 0
    termios.tcsetattr(line, termios.TCSANOW,
                      [0, 0, termios.CS8 | termios.CREAD | termios.CLOCAL, 0, speed, speed, control])
    return os.fdopen(line, "rb", buffering=0)


class SerialThermometer(bask_device.Thermometer):
    name = "Thermometer on a serial line"

    def __init__(self, path, baud, channels):
        self.channels = channels
        self.values = {}  # by channel: (K, when it came)
        self.error = None
        self.line = open_line(path, baud)
        threading.Thread(target=self.listen, daemon=True).start()

    def listen(self):
        kept = b""
        try:
            while True:
                more = self.line.read(256)
                if not more:
                    raise OSError("the line was closed")
                *whole, kept = (kept + more)[-4096:].split(b"\n")
                for line in whole:
                    for channel, value in values_in(line.decode("ascii", "replace")).items():
                        self.values[channel] = (value + 273.15, time.monotonic())
        except OSError as error:
            self.error = error

    def read(self):
        if self.error:
            raise bask_device.Refused("the serial line has failed: %s" % self.error)
        now = time.monotonic()
        known = [self.values.get(channel, (None, -FRESH)) for channel in range(self.channels)]
        fresh = [(value, now - came) for value, came in known if value is not None and now - came < FRESH]
        return self.state([value if value is not None and now - came < FRESH else None for value, came in known],
                          age=max((age for _, age in fresh), default=0.0))  # the oldest of them


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("path")
    parser.add_argument("--channels", type=int, default=1)
    parser.add_argument("--baud", type=int, default=115200)
    wanted = parser.parse_args()
    bask_device.run(SerialThermometer(wanted.path, wanted.baud, wanted.channels))
