"""A thermometer on a serial line that prints lines such as "t0=23.4 t1=25.1" (degrees Celsius) by itself.

    python3 serial_thermometer.py /dev/ttyUSB0 --channels 2 [--baud 115200]

Needs nothing but Python: the line is set up by termios. Another form of line is one change, in values_in().
"""

import argparse
import math
import os
import re
import termios
import threading
import time

import bask_device

FRESH = 3.0  # s; an older value is none
LEAST, GREATEST = -60.0, 900.0  # degC; beyond them it is no temperature: many devices print -127 or 999 for a fault


def values_in(line):
    """The channels in a line: {0: 23.4, 1: 25.1}."""
    # Whole words only: of a damaged "t0=23.4x" it takes nothing, and not 23.
    words = re.findall(r"(?<!\S)t(\d{1,3})=(-?\d{1,4}(?:\.\d+)?)(?!\S)", line, re.ASCII)
    return {int(channel): float(value) for channel, value in words}


def open_line(path, baud):
    """A serial line of 8 bits without parity, as the bytes come."""
    line = open(os.open(path, os.O_RDONLY | os.O_NOCTTY | os.O_NONBLOCK), "rb", buffering=0)
    try:
        speed = getattr(termios, "B%d" % baud)
        control = termios.tcgetattr(line)[6]
        control[termios.VMIN], control[termios.VTIME] = 1, 0
        termios.tcsetattr(line, termios.TCSANOW,
                          [0, 0, termios.CS8 | termios.CREAD | termios.CLOCAL, 0, speed, speed, control])
        os.set_blocking(line.fileno(), True)  # only the opening does not wait, for a modem that is not there
    except BaseException:
        line.close()
        raise
    return line


class SerialThermometer(bask_device.Thermometer):
    name = "Thermometer on a serial line"

    def __init__(self, path, baud, channels):
        self.path, self.baud, self.channels = path, baud, channels
        self.values = {}  # by channel: (K, when it came)
        self.error = "it is not open yet"
        threading.Thread(target=self.listen, daemon=True).start()

    def listen(self):
        """Opens the line, and opens it anew after the plug was pulled."""
        while True:
            try:
                with open_line(self.path, self.baud) as line:
                    self.error = ""
                    self.follow(line)
            except (OSError, termios.error) as error:
                self.error = str(error)
            time.sleep(0.5)

    def follow(self, line):
        kept = b""
        while True:
            more = line.read(256)
            if not more:
                raise OSError("it was closed")
            *whole, kept = (kept + more)[-4096:].split(b"\n")
            for text in whole:
                for channel, value in values_in(text.decode("ascii", "replace")).items():
                    self.values[channel] = (value + 273.15 if LEAST <= value <= GREATEST else None, time.monotonic())

    def read(self):
        if self.error:
            raise bask_device.Refused("%s: %s" % (self.path, self.error))
        now = time.monotonic()
        known = [self.values.get(channel, (None, -math.inf)) for channel in range(self.channels)]
        fresh = [value if now - came < FRESH else None for value, came in known]
        ages = [now - came for value, (_, came) in zip(fresh, known) if value is not None]
        return self.state(fresh, faults=["other" if value is None else "" for value in fresh],
                          age=max(ages, default=0.0))  # the oldest of them


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("path")
    parser.add_argument("--channels", type=int, default=1)
    parser.add_argument("--baud", type=int, default=115200)
    wanted = parser.parse_args()
    if not hasattr(termios, "B%d" % wanted.baud):
        parser.error("no serial line has %d baud" % wanted.baud)
    bask_device.run(SerialThermometer(wanted.path, wanted.baud, wanted.channels))
