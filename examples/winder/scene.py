# SPDX-License-Identifier: MIT
"""Winder (Pommier, 8.3.2 exercise 4; w upwards). The arm Sigma turns about (O, w) at a constant rate, driven by a motor. A
cylindrical joint lets the bobbin S slide and turn freely on the axis (B, z) of the arm, OB = b i, its centre G at BG = lambda
z, its own turn phi. The thread pulls G towards the point A of the axis w, OA = a w, with the force m k GA. The figure is lost:
z is taken normal to i, turned by `slope` from w about i, so that 0 is an upright axis and pi/2 a level one."""
from torsor.scene import Inertia, Scene, axis, pi, quantity

scene = Scene("winder", "Winder: a bobbin on a turning arm")

m = scene.parameter("m", "kg", 0.5)
A = scene.parameter("A", "kg m^2", 0.0008)  # of the bobbin, across its axis and about it
C = scene.parameter("C", "kg m^2", 0.0005)
arm = scene.parameter("arm", "kg m^2", 0.02)  # of Sigma about (O, w)
b = scene.parameter("b", "m", 0.2)
a = scene.parameter("a", "m", 0.3)
k = scene.parameter("k", "s^-2", 400)
g = scene.parameter("g", "m/s^2", 9.81)
omega = scene.run_time_parameter("omega", "rad/s", 10)
slope = scene.run_time_parameter("slope", "rad", pi / 3)

theta = scene.coordinate("theta", "rad")
lambda_ = scene.coordinate("lambda", "m")
phi = scene.coordinate("phi", "rad")
motor = scene.released_coordinate("motor", "rad")
scene.drive(theta, omega * scene.time)
scene.initial(lambda_, 0.05)
scene.initial(phi, 0, quantity("5", "rad/s"))

axle = scene.revolute("axle", scene.ground, axis.z, motor)
sigma = scene.revolute("Sigma", axle, axis.z, theta)
scene.name_joint(sigma, "pivot_with_motor")
holder = scene.revolute("holder", sigma, axis.x, slope, origin=(b, 0, 0))
bobbin = scene.cylindrical("S", holder, axis=axis.z, displacement=lambda_, angle=phi)
scene.body("Sigma", sigma, Inertia.general(0, 0, 0, arm))
scene.body("S", bobbin, Inertia.general(m, A, A, C))
G = scene.point("G", bobbin, (0, 0, 0))
fixed = scene.point("fixed", sigma, (0, 0, a))
scene.spring("thread", a=G, b=fixed, stiffness=m * k)
scene.gravity((0, 0, -g))

if __name__ == "__main__":
    scene.main()
