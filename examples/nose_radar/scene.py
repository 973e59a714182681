# SPDX-License-Identifier: MIT
"""Radar on the nose of an aircraft in straight level flight along x (Pommier, 8.1 exercise 5). Unit (1) turns about (P, z) by
alpha; unit (2), the antenna, about (H, y1) by beta, PH = h x1. Its centre of mass G is at a x2 from H. The released coordinates
let the antenna slide along x and along x2: the forces against them are those that its acceleration takes, m Gamma.x and m
Gamma.x2."""
from torsor.scene import Inertia, Scene, axis, quantity

scene = Scene("nose_radar", "Radar on the nose of an aircraft")

h = scene.parameter("h", "m", 0.4)
a = scene.parameter("a", "m", 0.25)
m = scene.parameter("m", "kg", 12)  # of the antenna
across = scene.parameter("across", "kg m^2", 0.5)  # its moments about G
along = scene.parameter("along", "kg m^2", 0.9)
C1 = scene.parameter("C1", "kg m^2", 0.3)  # of unit (1) about (P, z)
M = scene.parameter("M", "kg", 9000)  # of aircraft and unit (1)

x = scene.coordinate("x", "m")
alpha = scene.coordinate("alpha", "rad")
beta = scene.coordinate("beta", "rad")
F_x = scene.released_coordinate("F_x", "m")
F_x2 = scene.released_coordinate("F_x2", "m")
scene.initial(x, 0, quantity("200", "m/s"))
scene.initial(alpha, 0.3, quantity("1.5", "rad/s"))
scene.initial(beta, -0.4, quantity("2", "rad/s"))

aircraft = scene.prismatic("aircraft", scene.ground, axis.x, x)
carriage = scene.prismatic("carriage", aircraft, axis.x, F_x)
unit_1 = scene.revolute("unit_1", carriage, axis.z, alpha)
hinge = scene.revolute("hinge", unit_1, axis.y, beta, origin=(h, 0, 0))
antenna = scene.prismatic("antenna", hinge, axis.x, F_x2)
scene.body("aircraft", aircraft, Inertia.point(M))
scene.body("unit_1", unit_1, Inertia.general(0, 0, 0, C1))
scene.body("antenna", antenna, Inertia.general(m, along, across, across).at((a, 0, 0)))
scene.motor("thrust", x)
scene.motor("azimuth", alpha)
scene.motor("elevation", beta)

if __name__ == "__main__":
    scene.main()
