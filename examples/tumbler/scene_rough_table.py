# SPDX-License-Identifier: MIT
"""The tumbler on a table of friction f, and nothing assumed of the contact: it rolls while f suffices, slips where it does not,
and jumps where the table does not press."""
from torsor.scene import Inertia, Scene, axis, cos, euler, quantity, shape, sin

scene = Scene("tumbler_rough_table", "Tumbler on a table whose friction may not suffice")

R = scene.parameter("R", "m", 0.05)
a = scene.parameter("a", "m", 0.02)
m = scene.parameter("m", "kg", 0.2)
A = scene.parameter("A", "kg m^2", 0.0002)
B = scene.parameter("B", "kg m^2", 0.00015)
g = scene.parameter("g", "m/s^2", 9.81)
f = scene.run_time_parameter("f", "1", 0.5)

x = scene.coordinate("x", "m")
y = scene.coordinate("y", "m")
z = scene.coordinate("z", "m")
psi = scene.coordinate("psi", "rad")
theta = scene.coordinate("theta", "rad")
phi = scene.coordinate("phi", "rad")

lean = 1
psi_rate = quantity("5", "rad/s")
phi_rate = quantity("3", "rad/s")
# x, y and z are the centre of mass: about the centre of the sphere gravity would have a moment that inertia takes away
# again in free flight, to rounding only. The sphere's centre stands above it by a along the tumbler's axis.
scene.initial(x, 0, -R * sin(lean) * phi_rate - a * sin(lean) * psi_rate)
scene.initial(y, a * sin(lean))
scene.initial(z, R - a * cos(lean))
scene.initial(psi, 0, psi_rate)
scene.initial(theta, lean)
scene.initial(phi, 0, phi_rate)

tumbler = scene.free("tumbler", scene.ground, euler, (x, y, z), (psi, theta, phi))
scene.body("tumbler", tumbler, Inertia.general(m, A, A, B))
scene.gravity((0, 0, -g))
sphere = scene.weld("sphere", tumbler, origin=(0, 0, a))
scene.contact("table", shape.Sphere(sphere, R), shape.Plane(scene.ground), friction=f)

if __name__ == "__main__":
    scene.main()
