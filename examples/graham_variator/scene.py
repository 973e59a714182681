# SPDX-License-Identifier: MIT
"""Graham variator (Pommier, 8.3.2 exercise 6; its figure is lost, so that the places below are a reading of the text). The
carrier S1 turns by alpha about (O, x0), y0 pointing up. The satellite S2, a cone of apex C and half angle delta, turns by beta
about its axis (C, x2) on S1, (x1, x2) = delta, FC = c y1 with F on (O, x0). Its outer generatrix is parallel to x0: the ring
S4, of radius c, can be slid along the frame and touches it at A, at d along the axis: CD = -d x2, DA = d tan(delta) v, v
perpendicular to x2 in the plane x1, y1. A pinion of radius p on S2, at l along the axis, meets the internal rim of S3 at E: CE
= -l x2 + p v (p < 0 would be a sun inside). S3 turns by gamma about (O, x0). The slides of S4 set the ratio: d is a run-time
parameter. Torques C1 and C3 act on S1 and S3."""
from torsor.scene import Inertia, Rotation, Scene, axis, cos, form, pi, quantity, sin, tan

scene = Scene("graham_variator", "Graham variator: a cone rolling in a ring drives a third body")

c = scene.parameter("c", "m", 0.1)
d = scene.run_time_parameter("d", "m", 0.1)
delta = scene.parameter("delta", "rad", pi / 12)
l = scene.parameter("l", "m", 0.03)
p = scene.parameter("p", "m", 0.02)
b = scene.parameter("b", "m", 0.06)  # CG2 = -b x2
m2 = scene.parameter("m2", "kg", 1)
A1 = scene.parameter("A1", "kg m^2", 0.01)
A2 = scene.parameter("A2", "kg m^2", 0.0003)
B2 = scene.parameter("B2", "kg m^2", 0.0008)
A3 = scene.parameter("A3", "kg m^2", 0.02)
g = scene.parameter("g", "m/s^2", 9.81)

alpha = scene.coordinate("alpha", "rad")
beta = scene.coordinate("beta", "rad")
gamma = scene.coordinate("gamma", "rad")
# What the contacts demand of the rates: question 1 of the page.
rate = quantity("20", "rad/s")
r3 = c - l * sin(delta) + p * cos(delta)
beta_rate = -rate * c / (d * tan(delta))
scene.initial(alpha, 0, rate)
scene.initial(beta, 0, beta_rate)
scene.initial(gamma, 0, rate + beta_rate * p / r3)

S1 = scene.revolute("S1", scene.ground, axis.x, alpha)
inclined = scene.revolute("inclined", S1, axis.z, delta, origin=(0, c, 0))
S2 = scene.revolute("S2", inclined, axis.x, beta)
S3 = scene.revolute("S3", scene.ground, axis.x, gamma)
S4 = scene.weld("S4", scene.ground)
# S1 and S3 are balanced: only their moments about (O, x0) matter.
m = quantity("1", "kg")
scene.body("S1", S1, Inertia.general(m, A1, A1, A1))
scene.body("S2", S2, Inertia.general(m2, A2, B2, B2).at((-b, 0, 0)))
scene.body("S3", S3, Inertia.general(m, A3, A3, A3))

# At A and E the bodies move across the plane x1, y1 only: along x1 the condition of rolling is an identity.
contacts = scene.weld("contacts", S1, rotation=Rotation.about(0, 6))
A = scene.point("A", inclined, (-d, d * tan(delta), 0))
E = scene.point("E", inclined, (-l, p, 0))
at_A = scene.rolling("rolling_A", body=S2, on=S4, contact=A, tangents=contacts)
at_E = scene.rolling("rolling_E", body=S2, on=S3, contact=E, tangents=contacts)
scene.reaction(at_A[1], "T_A", body=S2, contact=A, direction=axis.z, axes=S1, other=S4)
scene.reaction(at_E[1], "T_E", body=S2, contact=E, direction=axis.z, axes=S1, other=S3)

# For pictures: the carrier, the cone with its pinion, spokes of S3 in the plane of E, the ring S4 in the plane of A.
along_x = Rotation.about(1, 6)  # z of a form along x
length = 3 * d / 2
thin = c / 40
scene.show(S1, form.Segment((0, 0, 0), (0, c, 0), thin))
scene.show(S2, form.Cone(length * tan(delta), length), origin=(-length, 0, 0), rotation=along_x, colour=(0.85, 0.6, 0.2))
scene.show(S2, form.Cylinder(p, p / 2), origin=(-l, 0, 0), rotation=along_x)
at_E_x = -l * cos(delta) - p * sin(delta)
at_A_x = -d / cos(delta)
for k in range(4):
    y, z = r3 * cos(pi / 4 * k), r3 * sin(pi / 4 * k)
    scene.show(S3, form.Segment((at_E_x, -y, -z), (at_E_x, y, z), thin))
scene.show(S4, form.Torus(c, thin), origin=(at_A_x, 0, 0), rotation=along_x)

scene.gravity((0, -g, 0))
scene.motor("C1", alpha)
scene.motor("C3", gamma)

if __name__ == "__main__":
    scene.main()
