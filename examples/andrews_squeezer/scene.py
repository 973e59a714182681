# SPDX-License-Identifier: MIT
"""Andrews' squeezing mechanism (IVP Test Set; Hairer & Wanner, Solving Ordinary Differential Equations II; IFToMM benchmark
A03): seven bodies in a plane, three loops that meet in E, one freedom, driven by a constant torque. Coordinates as published:
angles of three chains from the ground, and of the bodies they carry."""
from torsor.scene import Inertia, Scene, axis, quantity

scene = Scene("andrews_squeezer", "Andrews' squeezing mechanism: seven bodies, three loops")


def length(name, value):
    return scene.parameter(name, "m", value)


d = length("d", 0.028)
da = length("da", 0.0115)
e = length("e", 0.02)
ea = length("ea", 0.01421)
rr = length("rr", 0.007)
ra = length("ra", 0.00092)
ss = length("ss", 0.035)
sa = length("sa", 0.01874)
sb = length("sb", 0.01043)
sc = length("sc", 0.018)
sd = length("sd", 0.02)
ta = length("ta", 0.02308)
tb = length("tb", 0.00916)
u = length("u", 0.04)
ua = length("ua", 0.01228)
ub = length("ub", 0.00449)
zf = length("zf", 0.02)
zt = length("zt", 0.04)
fa = length("fa", 0.01421)
mom = scene.parameter("mom", "N m", 0.033)


def angle(name, start):
    q = scene.coordinate(name, "rad")
    scene.initial(q, quantity(start, "rad"))
    return q


beta = angle("beta", "-0.06171389001427644963589484580009627")
Theta = angle("Theta", "0")
gamma = angle("gamma", "0.4552798191630703802559123824490657")
Phi = angle("Phi", "0.2226683901658858846744731856093545")
delta = angle("delta", "0.4873649795438425502255989535298482")
Omega = angle("Omega", "-0.2226683901658858846744731856093549")
epsilon = angle("epsilon", "1.230547444549821192497350155677741")

C = scene.point("C", scene.ground, (length("xc", 0.014), length("yc", 0.072), 0))
A = (length("xa", -0.06934), length("ya", -0.00227), 0)
B = (length("xb", -0.03635), length("yb", 0.03273), 0)
K1 = scene.revolute("K1", scene.ground, axis.z, beta)
K2 = scene.revolute("K2", K1, axis.z, Theta, origin=(rr, 0, 0))
K3 = scene.revolute("K3", scene.ground, axis.z, gamma, origin=B)
K5 = scene.revolute("K5", scene.ground, axis.z, delta, origin=A)
K4 = scene.revolute("K4", K5, axis.z, Phi, origin=(zt, 0, 0))
K7 = scene.revolute("K7", scene.ground, axis.z, epsilon, origin=A)
K6 = scene.revolute("K6", K7, axis.z, Omega, origin=(0, -u, 0))

for number, (frame, mass, inertia, center) in enumerate([
        (K1, 0.04325, 0.000002194, (ra, 0, 0)),
        (K2, 0.00365, 0.000000441, (-da, 0, 0)),
        (K3, 0.02373, 0.000005255, (sb, -sa, 0)),
        (K4, 0.00706, 0.0000005667, (0, ea - e, 0)),
        (K5, 0.0705, 0.00001169, (ta, tb, 0)),
        (K6, 0.00706, 0.0000005667, (zf - fa, 0, 0)),
        (K7, 0.05498, 0.00001912, (-ub, -ua, 0))], 1):
    m = scene.parameter(f"m{number}", "kg", mass)
    I = scene.parameter(f"I{number}", "kg m^2", inertia)
    scene.body(f"S{number}", frame, Inertia.general(m, 0, 0, I).at(center))

scene.torque("motor", K1, (0, 0, mom), scene.ground)
D = scene.point("D", K3, (sd, -sc, 0))
stiffness = scene.parameter("c0", "N/m", 4530)
scene.spring("spring", a=C, b=D, stiffness=stiffness, rest=length("l0", 0.07785))

E2, E3 = scene.point("E2", K2, (-d, 0, 0)), scene.point("E3", K3, (0, -ss, 0))
E4, E6 = scene.point("E4", K4, (0, -e, 0)), scene.point("E6", K6, (zf, 0, 0))
scene.point("F", K1, (rr, 0, 0))
for name, other in [("E3", E3), ("E4", E4), ("E6", E6)]:
    scene.closure(name + "_x", other, E2, axis.x)
    scene.closure(name + "_y", other, E2, axis.y)
scene.independent([beta])

if __name__ == "__main__":
    scene.main()
