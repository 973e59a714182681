# SPDX-License-Identifier: MIT
"""Planar double pendulum: two point masses on massless rods, both angles absolute, from the downward vertical. y points up and
the motion takes place in the plane x, y."""
from torsor.scene import Inertia, Scene, axis

scene = Scene("double_pendulum", "Planar double pendulum with absolute angles")

m1 = scene.parameter("m1", "kg", 1)
m2 = scene.parameter("m2", "kg", 1)
l1 = scene.parameter("l1", "m", 1)
l2 = scene.parameter("l2", "m", 1)
g = scene.parameter("g", "m/s^2", 9.81)

theta_1 = scene.coordinate("theta_1", "rad")
theta_2 = scene.coordinate("theta_2", "rad")
scene.initial(theta_1, 2)
scene.initial(theta_2, 2.5)

upper = scene.revolute("upper", scene.ground, axis.z, theta_1)
lower = scene.revolute("lower", upper, axis.z, theta_2 - theta_1, origin=(0, -l1, 0))
scene.body("first_mass", upper, Inertia.point(m1).at((0, -l1, 0)))
scene.body("second_mass", lower, Inertia.point(m2).at((0, -l2, 0)))
scene.gravity((0, -g, 0))

if __name__ == "__main__":
    scene.main()
