"""A simulated robot of six axes, thermometer and hotplate as program drivers: the rig of an experiment without hardware.

    python3 simulated_devices.py --role robot --world FOLDER --experiment FILE.json [--moves steps]
    python3 simulated_devices.py --role thermometer --world FOLDER --experiment FILE.json
    python3 simulated_devices.py --role heater --world FOLDER --experiment FILE.json

Each is a process of its own. They know of one another by what they write into the folder: where the robot is and how hot
the plate is. The thermometer warms disks, whatever outline the experiment has, by the balance of docs/model.md without
air. It reads round sources, and radii, poses and materials as the shipped examples write them.
"""

import argparse
import json
import math
import os
import random
import threading
import time

import bask_device

SIGMA = 5.670374419e-8  # W/(m2 K4)
TICK = 0.02  # s


def quantity(values, name, default=None):
    """A length in m, an angle in rad or a temperature in K, in either of its spellings."""
    for suffix, factor, offset in (("_m", 1, 0), ("_cm", 0.01, 0), ("_mm", 0.001, 0), ("_rad", 1, 0),
                                   ("_deg", math.pi / 180, 0), ("_K", 1, 0), ("_degC", 1, 273.15)):
        if name + suffix in values:
            return values[name + suffix] * factor + offset
    if default is None:
        raise SystemExit("the experiment has no %s" % name)
    return default


def coordinates(values):
    return [quantity(values, axis, 0.0) for axis in bask_device.AXES]


class World:
    """What the processes know of one another: a number or a list under a name."""

    def __init__(self, folder):
        self.folder = folder
        os.makedirs(folder, exist_ok=True)

    def tell(self, name, value):
        path = os.path.join(self.folder, name)
        with open(path + ".new", "w") as file:
            json.dump(value, file)
        os.replace(path + ".new", path)

    def ask(self, name, default):
        try:
            with open(os.path.join(self.folder, name)) as file:
                return json.load(file)
        except (OSError, ValueError):
            return default


def keep_doing(tick):
    """Calls tick(dt) on a thread of its own, every TICK s."""
    def run():
        last = time.monotonic()
        while True:
            time.sleep(TICK)
            now = time.monotonic()
            tick(now - last)
            last = now
    threading.Thread(target=run, daemon=True).start()


class SimulatedArm(bask_device.Robot):
    name, serial = "Simulated arm", "SIM-6"
    axes = bask_device.AXES
    can_home = True
    limits = {axis: (-1.0, 1.0) for axis in bask_device.AXES[:3]}
    limits.update({axis: (-math.pi, math.pi) for axis in bask_device.AXES[3:]})

    def __init__(self, world, start, moves, is_sure):
        self.world, self.moves = world, moves
        self.lock = threading.Lock()
        self.start = start
        self.at = world.ask("robot", start)
        self.rates = [0.0] * 6
        self.goal, self.left = None, 0.0
        self.is_homing, self.is_sure = False, is_sure
        world.tell("robot", self.at)
        keep_doing(self.tick)

    def tick(self, dt):
        with self.lock:
            if self.goal is not None:
                share = min(1.0, dt / self.left) if self.left > 0.0 else 1.0
                self.at = [a + share * (g - a) for a, g in zip(self.at, self.goal)]
                self.left -= dt
                if share == 1.0:
                    self.goal = None
                    self.is_sure = self.is_sure or self.is_homing
                    self.is_homing = False
            else:
                self.at = [a + r * dt for a, r in zip(self.at, self.rates)]
            at = list(self.at)
        self.world.tell("robot", at)

    def read(self):
        with self.lock:
            return self.state(self.at, self.goal is not None or any(self.rates), self.is_sure, age=TICK)

    def velocity(self, rates):
        with self.lock:
            self.rates, self.goal = rates, None

    def step(self, to, duration):
        with self.lock:
            self.goal, self.left = to, duration

    def stop(self):
        with self.lock:
            self.is_sure = self.is_sure and not self.is_homing
            self.rates, self.goal, self.is_homing = [0.0] * 6, None, False

    def home(self):
        with self.lock:
            self.goal, self.left, self.is_homing, self.is_sure = list(self.start), 3.0, True, False

    def clear(self):
        with self.lock:
            self.is_sure = True


class SimulatedPlate(bask_device.Heater):
    name = "Simulated hotplate"
    max_temperature = 623.15
    watchdog = True  # there is nothing that could stay hot
    HEATING_TIME, COOLING_TIME = 2.0, 30.0  # s: towards the set point, towards the room

    def __init__(self, world, room):
        self.world, self.room = world, room
        self.lock = threading.Lock()
        self.temperature = world.ask("plate", room)
        self.set_point, self.is_on = room, False
        keep_doing(self.tick)

    def tick(self, dt):
        with self.lock:
            goal, wait = (self.set_point, self.HEATING_TIME) if self.is_on else (self.room, self.COOLING_TIME)
            self.temperature += (goal - self.temperature) * -math.expm1(-dt / wait)
            temperature = self.temperature
        self.world.tell("plate", temperature)

    def read(self):
        with self.lock:
            return self.state(self.temperature, self.is_on, self.set_point)

    def heat(self, set_point):
        with self.lock:
            self.set_point, self.is_on = set_point, True

    def off(self):
        with self.lock:
            self.is_on = False


def rotation(theta_x, theta_y, theta_z):
    """Rz(theta_z) Ry(theta_y) Rx(theta_x), as rows."""
    (cx, sx), (cy, sy), (cz, sz) = ((math.cos(t), math.sin(t)) for t in (theta_x, theta_y, theta_z))
    return ((cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx),
            (sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx),
            (-sy, cy * sx, cy * cx))


def view_factor(radius, place, normal):
    """Of a small surface at `place` that looks along `normal`, to a disk around the origin in the plane z = 0: the
    contour integral over the disk's edge. Right to 1e-4 where the surface sees the whole disk."""
    corners = 256
    total = [0.0, 0.0, 0.0]
    edge = [(radius * math.cos(2 * math.pi * i / corners) - place[0],
             radius * math.sin(2 * math.pi * i / corners) - place[1], -place[2]) for i in range(corners)]
    for a, b in zip(edge, edge[1:] + edge[:1]):
        cross = (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
        length = math.sqrt(sum(c * c for c in cross))
        angle = math.atan2(length, sum(p * q for p, q in zip(a, b)))
        for k in range(3):
            total[k] += angle * cross[k] / length
    return max(0.0, -sum(n * t for n, t in zip(normal, total)) / (2 * math.pi))


class Disk:
    """One object, thin and evenly warm."""

    def __init__(self, spec, room):
        material, mounting = spec["material"], coordinates(spec.get("mounting", {}))
        self.place, self.turn = mounting[:3], rotation(*mounting[3:])
        self.capacity = (material["specific_heat_J_kgK"] * material["density_kg_m3"] *
                         quantity(material, "thickness") * material.get("infill", 1.0))
        self.emittance, self.absorptance = material["emittance"], material["absorptance"]
        self.temperature = room
        self.factor = 0.0

    def look(self, at, radius):
        """The view factor from where the robot is."""
        turn = rotation(*at[3:])
        place = [at[i] + sum(turn[i][k] * self.place[k] for k in range(3)) for i in range(3)]
        normal = [-sum(turn[i][k] * self.turn[k][2] for k in range(3)) for i in range(3)]
        self.factor = view_factor(radius, place, normal) if place[2] > 0.0 else 0.0

    def warm(self, plate, emittance, room, dt):
        power = SIGMA * emittance * (plate ** 4 - room ** 4)
        loss = self.emittance * SIGMA * (self.temperature ** 4 - room ** 4)
        self.temperature += dt * (self.absorptance * self.factor * power - loss) / self.capacity


class SimulatedThermometer(bask_device.Thermometer):
    name = "Simulated thermometer"

    def __init__(self, world, experiment, room):
        source = experiment["source"]
        self.world, self.room = world, room
        self.radius, self.emittance = quantity(source["contour"], "radius"), source["emittance"]
        self.disks = [Disk(spec, room) for spec in experiment["objects"]]
        self.channels = len(self.disks)
        self.noise = experiment.get("simulation", {}).get("sensor_noise_K", 0.02)
        self.lock = threading.Lock()
        keep_doing(self.tick)

    def tick(self, dt):
        at = self.world.ask("robot", None)
        plate = self.world.ask("plate", self.room)
        with self.lock:
            for disk in self.disks:
                if at is not None:
                    disk.look(at, self.radius)
                disk.warm(plate, self.emittance, self.room, dt)

    def read(self):
        with self.lock:
            true = [disk.temperature for disk in self.disks]
        self.world.tell("objects", true)
        return self.state([t + random.gauss(0.0, self.noise) for t in true],
                          uncertainties=[self.noise] * self.channels)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--role", choices=("robot", "thermometer", "heater"), required=True)
    parser.add_argument("--world", required=True, metavar="FOLDER")
    parser.add_argument("--experiment", required=True, metavar="FILE.json")
    parser.add_argument("--moves", choices=("velocity", "steps"), default="velocity")
    parser.add_argument("--unsure", action="store_true", help="the robot must be homed first")
    wanted = parser.parse_args()
    with open(wanted.experiment) as file:
        experiment = json.load(file)
    world = World(wanted.world)
    room = quantity(experiment.get("environment", {}), "temperature", 298.15)
    if wanted.role == "robot":
        start = coordinates(experiment["robot"].get("start", {}))
        device = SimulatedArm(world, start, wanted.moves, not wanted.unsure)
    elif wanted.role == "heater":
        device = SimulatedPlate(world, room)
    else:
        device = SimulatedThermometer(world, experiment, room)
    bask_device.run(device)


main()
