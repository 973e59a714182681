# SPDX-License-Identifier: MIT
"""Segment AB of length l whose ends stay on a sphere of radius R > l/2 about O (Pommier, 8.1 exercise 1). Its middle I stays at
the distance d = sqrt(R^2 - l^2/4) from O and AB is normal to OI, so three angles place it: psi and theta for the direction z3
of OI, phi for that of AB = l x3 about it (Euler's angles). Here AB is a heavy rod that slides inside the sphere without
friction, z0 upwards."""
from torsor.scene import Inertia, Scene, axis, quantity, sqrt

scene = Scene("segment_in_sphere", "A rod slides inside a sphere")

R = scene.parameter("R", "m", 1)
l = scene.parameter("l", "m", 1.2)
m = scene.parameter("m", "kg", 1)
g = scene.parameter("g", "m/s^2", 9.81)
d = sqrt(R * R - l * l / 4)

psi = scene.coordinate("psi", "rad")
theta = scene.coordinate("theta", "rad")
phi = scene.coordinate("phi", "rad")
scene.initial(psi, 0, quantity("1", "rad/s"))
scene.initial(theta, 2)
scene.initial(phi, 0.5, quantity("3", "rad/s"))

first = scene.revolute("first", scene.ground, axis.z, psi)
second = scene.revolute("second", first, axis.x, theta)
rod = scene.revolute("rod", second, axis.z, phi)
scene.body("rod", rod, Inertia.rod(m, l, 0).at((0, 0, d)))
scene.point("A", rod, (-l / 2, 0, d))
scene.point("B", rod, (l / 2, 0, d))
scene.gravity((0, 0, -g))

if __name__ == "__main__":
    scene.main()
