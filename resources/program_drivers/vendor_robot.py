"""A Universal Robots arm by its maker's protocol and the library ur_rtde (pip install ur_rtde).

NEVER TRIED on a real arm: it shows how a robot behind a vendor's library is driven. Try it with the arm's own simulator
(URSim) and `bask check-device` first, with the speed slider at its least, beside the arm's own emergency stop. Try also
what the arm does when this program is killed (kill -9) while it moves: the library's script on the arm repeats the last
velocity for ever, and only its watchdog, which is set below, ends it.

    python3 vendor_robot.py 192.168.1.40

The end-effector's pose is that of the tool centre point in the frame of the arm's base. The arm gives its rotation as a
rotation vector; Bask's angles are those of Rz(theta_z) Ry(theta_y) Rx(theta_x).
"""

import math
import sys
import threading
import time

import bask_device

ACCELERATION = 0.3  # m/s2
STANDS = 1e-4  # m/s or rad/s
WATCHDOG = 4.0  # Hz: the arm ends its script when it has not been kicked for 1 / WATCHDOG s


def matrix_of(vector):
    """The rotation matrix of a rotation vector, as rows (Rodrigues)."""
    angle = math.sqrt(sum(v * v for v in vector))
    if angle < 1e-12:
        return [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    x, y, z = (v / angle for v in vector)
    c, s = math.cos(angle), math.sin(angle)
    return [[c + x * x * (1 - c), x * y * (1 - c) - z * s, x * z * (1 - c) + y * s],
            [y * x * (1 - c) + z * s, c + y * y * (1 - c), y * z * (1 - c) - x * s],
            [z * x * (1 - c) - y * s, z * y * (1 - c) + x * s, c + z * z * (1 - c)]]


def angles_of(vector):
    """theta_x, theta_y, theta_z of a rotation vector."""
    m = matrix_of(vector)
    return [math.atan2(m[2][1], m[2][2]), math.asin(max(-1.0, min(1.0, -m[2][0]))), math.atan2(m[1][0], m[0][0])]


def turning_of(angles, rates):
    """The angular velocity in the base's frame of angles that change at these rates."""
    _, ty, tz = angles
    rx, ry, rz = rates
    return [math.cos(tz) * math.cos(ty) * rx - math.sin(tz) * ry,
            math.sin(tz) * math.cos(ty) * rx + math.cos(tz) * ry,
            -math.sin(ty) * rx + rz]


class UniversalRobot(bask_device.Robot):
    name = "Universal Robots arm"
    axes = bask_device.AXES
    moves = "velocity"

    def __init__(self, host):
        import rtde_control  # here, so that the functions above can be tried without it
        import rtde_receive
        self.receive = rtde_receive.RTDEReceiveInterface(host)
        self.control = rtde_control.RTDEControlInterface(host)
        self.lock = threading.Lock()
        self.command(self.control.setWatchdog, WATCHDOG)
        threading.Thread(target=self.keep_kicking, daemon=True).start()

    def keep_kicking(self):
        """As long as this program lives. Silence of Bask is not the watchdog's: bask_device.py stops the arm then."""
        while True:
            time.sleep(0.2 / WATCHDOG)
            with self.lock:
                if self.control.isProgramRunning():
                    self.control.kickWatchdog()

    def command(self, method, *values):
        """The library says False where the arm has not taken a command, and raises nothing."""
        with self.lock:
            is_done = method(*values)
        if not is_done:
            raise bask_device.Refused("the arm does not take commands: look at its panel, then start this program anew")

    def read(self):
        if not self.receive.isConnected():  # else the library tells the last pose again and again, as if it were new
            raise bask_device.Refused("the arm is not connected")
        pose, speed = self.receive.getActualTCPPose(), self.receive.getActualTCPSpeed()
        alarm = ""
        if self.receive.isEmergencyStopped():
            alarm = "its emergency stop is pressed"
        elif self.receive.isProtectiveStopped():
            alarm = "it is in a protective stop"
        elif not self.control.isProgramRunning():
            alarm = "its script has ended, by its watchdog or at its panel: start this program anew"
        return self.state(list(pose[:3]) + angles_of(pose[3:]), moving=max(map(abs, speed)) > STANDS,
                          sure=True, alarm=alarm)

    def velocity(self, rates):
        angles = angles_of(self.receive.getActualTCPPose()[3:])
        speeds = list(rates[:3]) + turning_of(angles, rates[3:])
        self.command(self.control.speedL, speeds, ACCELERATION, 0.01)  # s until it looks for another velocity

    def stop(self):
        self.command(self.control.speedStop)

    def close(self):
        self.control.stopScript()


if __name__ == "__main__":
    bask_device.run(UniversalRobot(sys.argv[1]))
