# SPDX-License-Identifier: MIT
"""Kapitza's pendulum: a simple pendulum whose pivot is shaken along the vertical by a cos(omega t). theta is measured from the
upward vertical. The force that shakes the pivot is asked for by releasing the motion it imposes."""
from torsor.scene import Inertia, Scene, axis, cos

scene = Scene("kapitza_pendulum", "Pendulum kept upside down by shaking its pivot")

m = scene.parameter("m", "kg", 1)
L = scene.parameter("L", "m", 1)
g = scene.parameter("g", "m/s^2", 9.81)
a = scene.run_time_parameter("a", "m", 0.1)
omega = scene.run_time_parameter("omega", "rad/s", 100)

height = scene.coordinate("height", "m")
theta = scene.coordinate("theta", "rad")
shaker = scene.released_coordinate("shaker", "m")
scene.drive(height, a * cos(omega * scene.time))
scene.initial(theta, 0.2)

table = scene.prismatic("table", scene.ground, axis.z, shaker)
pivot = scene.prismatic("pivot", table, axis.z, height)
pendulum = scene.revolute("pendulum", pivot, axis.y, theta)
scene.body("pendulum", pendulum, Inertia.point(m).at((0, 0, L)))
scene.gravity((0, 0, -g))

if __name__ == "__main__":
    scene.main()
