# SPDX-License-Identifier: MIT
"""Watt's governor, turned at a constant rate: four massless arms of length L make a rhombus, hinged to the shaft at its upper
corner and to a sleeve on the shaft at its lower one; the balls are at the other two. theta is the angle of the upper arms with
the vertical. Without a sleeve's mass the balls hang as on two simple arms."""
from torsor.scene import Inertia, Scene, axis, cos

scene = Scene("watt_governor", "Watt's governor at a given speed")

g = scene.parameter("g", "m/s^2", 9.81)
m = scene.run_time_parameter("m", "kg", 1)  # of each ball
M = scene.run_time_parameter("M", "kg", 2)  # of the sleeve
L = scene.run_time_parameter("L", "m", 0.5)
omega = scene.run_time_parameter("omega", "rad/s", 12)

psi = scene.coordinate("psi", "rad")
theta = scene.coordinate("theta", "rad")
motor = scene.released_coordinate("motor", "rad")
scene.drive(psi, omega * scene.time)
scene.initial(theta, 1)

axle = scene.revolute("axle", scene.ground, axis.z, motor)
shaft = scene.revolute("shaft", axle, axis.z, psi)
arm_1 = scene.revolute("arm_1", shaft, axis.y, theta)
arm_2 = scene.revolute("arm_2", shaft, axis.y, -theta)
sleeve = scene.prismatic("sleeve", shaft, axis.z, -2 * L * cos(theta))
scene.body("ball_1", arm_1, Inertia.point(m).at((0, 0, -L)))
scene.body("ball_2", arm_2, Inertia.point(m).at((0, 0, -L)))
scene.body("sleeve", sleeve, Inertia.point(M))
scene.gravity((0, 0, -g))

if __name__ == "__main__":
    scene.main()
