# SPDX-License-Identifier: MIT
"""Deployment of the two arms of a satellite (Pommier, 8.3.2 exercise 5), z0 up. The body S1 turns freely about (O, z0) by psi;
the arms S2 and S3 turn about y1 by theta_2 and theta_3 (from z1 to z2 and z3), hinged at a2 x1 and -a3 x1, with a torsion
spring, a viscous torque and a motor each. Centres at b1 z1, b2 z2, b3 z3; Ai, Bi, Ci are the principal moments about xi, yi, zi
at the centres. The springs are at rest when the arms point outwards."""
from torsor.scene import Inertia, Scene, axis, pi, quantity

scene = Scene("satellite_arms", "Deployment of the arms of a satellite")

a2 = scene.parameter("a2", "m", 0.3)
a3 = scene.parameter("a3", "m", 0.35)
b1 = scene.parameter("b1", "m", 0.1)
b2 = scene.parameter("b2", "m", 0.5)
b3 = scene.parameter("b3", "m", 0.45)
m1 = scene.parameter("m1", "kg", 20)
m2 = scene.parameter("m2", "kg", 2)
m3 = scene.parameter("m3", "kg", 2.5)
A1 = scene.parameter("A1", "kg m^2", 0.8)
B1 = scene.parameter("B1", "kg m^2", 0.7)
C1 = scene.parameter("C1", "kg m^2", 0.9)
A2 = scene.parameter("A2", "kg m^2", 0.17)
B2 = scene.parameter("B2", "kg m^2", 0.168)
C2 = scene.parameter("C2", "kg m^2", 0.004)
A3 = scene.parameter("A3", "kg m^2", 0.18)
B3 = scene.parameter("B3", "kg m^2", 0.176)
C3 = scene.parameter("C3", "kg m^2", 0.005)
K2 = scene.parameter("K2", "N m", 30)
K3 = scene.parameter("K3", "N m", 35)
v2 = scene.parameter("v2", "N m s", 5)
v3 = scene.parameter("v3", "N m s", 6)
g = scene.parameter("g", "m/s^2", 9.81)

psi = scene.coordinate("psi", "rad")
theta_2 = scene.coordinate("theta_2", "rad")
theta_3 = scene.coordinate("theta_3", "rad")
# Arms folded upwards on a spinning body.
scene.initial(psi, 0, quantity("3", "rad/s"))
scene.initial(theta_2, 0.05)
scene.initial(theta_3, -0.05)

S1 = scene.revolute("S1", scene.ground, axis.z, psi)
S2 = scene.revolute("S2", S1, axis.y, theta_2, origin=(a2, 0, 0))
S3 = scene.revolute("S3", S1, axis.y, theta_3, origin=(-a3, 0, 0))
# Where moments are taken to find one motion at a time.
scene.point("O", scene.ground, (0, 0, 0))
scene.point("O2", S2, (0, 0, 0))
scene.point("O3", S3, (0, 0, 0))
scene.body("S1", S1, Inertia.general(m1, A1, B1, C1).at((0, 0, b1)))
scene.body("S2", S2, Inertia.general(m2, A2, B2, C2).at((0, 0, b2)))
scene.body("S3", S3, Inertia.general(m3, A3, B3, C3).at((0, 0, b3)))

scene.gravity((0, 0, -g))
scene.spring("hinge_spring_2", theta_2, K2, pi / 2)
scene.spring("hinge_spring_3", theta_3, K3, -pi / 2)
scene.damper("hinge_friction_2", theta_2, v2)
scene.damper("hinge_friction_3", theta_3, v3)
scene.motor("Cm2", theta_2)
scene.motor("Cm3", theta_3)

if __name__ == "__main__":
    scene.main()
