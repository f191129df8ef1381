"""A Universal Robots arm by its maker's protocol and the library ur_rtde (pip install ur_rtde).

NEVER TRIED on a real arm: it shows how a robot behind a vendor's library is driven. Try it with the arm's own simulator
(URSim) and `bask check-device` first, with the speed slider at its least, beside the arm's own emergency stop.

    python3 vendor_robot.py 192.168.1.40

The end-effector's pose is that of the tool centre point in the frame of the arm's base. The arm gives its rotation as a
rotation vector; Bask's angles are those of Rz(theta_z) Ry(theta_y) Rx(theta_x).
"""

import math
import sys

import bask_device

ACCELERATION = 0.3  # m/s2
STANDS = 1e-4  # m/s or rad/s


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

    def read(self):
        pose, speed = self.receive.getActualTCPPose(), self.receive.getActualTCPSpeed()
        alarm = ""
        if self.receive.isEmergencyStopped():
            alarm = "its emergency stop is pressed"
        elif self.receive.isProtectiveStopped():
            alarm = "it is in a protective stop"
        return self.state(list(pose[:3]) + angles_of(pose[3:]), moving=max(map(abs, speed)) > STANDS,
                          sure=True, alarm=alarm)

    def velocity(self, rates):
        angles = angles_of(self.receive.getActualTCPPose()[3:])
        # The arm ends it by itself after 0.5 s, should this program die.
        self.control.speedL(list(rates[:3]) + turning_of(angles, rates[3:]), ACCELERATION, 0.5)

    def stop(self):
        self.control.speedStop()

    def close(self):
        self.control.stopScript()


if __name__ == "__main__":
    bask_device.run(UniversalRobot(sys.argv[1]))
