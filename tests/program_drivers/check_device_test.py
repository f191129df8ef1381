"""What `bask check-device` says of the programs in broken/, each with a single defect, and of honest.py with none.

    python3 check_device_test.py BASK

program_check_test.cpp has 27 more of them.
"""

import os
import subprocess
import sys
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "broken")
BASK = sys.argv.pop(1)

# Program, role, what names the defect. The longest first.
BROKEN = [
    ("heats_at_start", "heater", 'says "heating" 2 s after off'),
    ("never_heats", "heater", 'does not say "heating" within 2 s of heat'),
    ("step_goes_elsewhere", "robot", "x goes 4 mm, from 0 mm to 4 mm, where 2 mm were asked for"),
    ("step_beyond_limits", "robot", "does not refuse a step beyond the limits"),
    ("acts_on_nonsense", "robot", "one number too many"),
    ("clear_moves", "robot", "moves after clear"),
    ("moves_though_refused", "robot", "refuses velocity, and moves nevertheless"),
    ("second_axis_moves_third", "robot", "z moves, too, while only y was to move"),
    ("degrees_in_limits", "robot", "more than a turn: tell radians"),
    ("ignores_stop", "robot", "does not stand after stop"),
    ("homes_in_secret", "robot", '"moving" is false right after home'),
    ("no_off_at_end", "robot", "goes on after the end of its input"),
    ("no_off_at_end", "heater", "heats on after the end of its input"),
    ("other_device", "thermometer", "another name or serial number after a new start"),
    ("celsius", "thermometer", "tell kelvins"),
    ("no_name", "thermometer", 'the key "name" is missing'),
    ("unknown_axis", "robot", "hello.axes[2]"),
    ("ignores_valid_for", "heater", "heats on when valid_for is over"),
    ("other_set_point", "heater", "reads a set point of 150 K back"),
    ("answers_twice", "thermometer", "answer each request once"),
    ("clock_runs_fast", "thermometer", "its time is off by"),
    ("repeats_seq", "thermometer", "line 9 (seq) comes instead of line 10"),
    ("number_for_a_fault", "thermometer", "state.temperatures[1]: -999 is out of range"),
    ("unknown_fault", "thermometer", "state.faults[1]"),
    ("negative_age", "thermometer", "state.age: -0.2 is out of range"),
    ("channel_missing", "thermometer", "2 temperatures, but hello has 3 channels"),
    ("wrong_count", "robot", "a position of 2 numbers, but hello has 3 axes"),
]


def check(program, role, *options):
    """Returns the exit code, and all that check-device says."""
    with tempfile.TemporaryDirectory() as folder:  # of the device that outlives its program
        found = subprocess.run(
            [BASK, "check-device", "--role", role, *(["--home"] if program == "homes_in_secret" else []), "--",
             "python3", "-B", os.path.join(FOLDER, program + ".py"), *options],
            capture_output=True, text=True, timeout=100, env={**os.environ, "TMPDIR": folder})
    return found.returncode, found.stdout + found.stderr


class CheckDevice(unittest.TestCase):
    def test_names_each_defect(self):
        with ThreadPoolExecutor(2) as pool:
            for (program, role, words), (code, said) in zip(BROKEN, pool.map(lambda each: check(*each[:2]), BROKEN)):
                with self.subTest(program=program, role=role):
                    wrong = [line for line in said.splitlines() if line.startswith("WRONG")]
                    self.assertTrue(any(words in line for line in wrong), said)
                    self.assertEqual(code, 3, said)

    # Catches a check that finds fault with a program that has none.
    def test_finds_nothing_in_the_honest_one(self):
        roles = [("robot",), ("robot", "steps"), ("heater",), ("thermometer",)]
        with ThreadPoolExecutor(2) as pool:
            for role, (code, said) in zip(roles, pool.map(lambda each: check("honest", *each), roles)):
                if code != 0:  # a busy computer may be late once
                    code, said = check("honest", *role)
                with self.subTest(role=role):
                    self.assertEqual(code, 0, said)
                    self.assertIn("are kept", said)

    def test_each_program_is_tried(self):
        names = {name[:-3] for name in os.listdir(FOLDER) if name.endswith(".py")}
        self.assertEqual(names, {program for program, *_ in BROKEN} | {"honest"})


unittest.main(verbosity=2)
