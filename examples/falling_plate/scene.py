# SPDX-License-Identifier: MIT
"""Plate of any shape with its straight edge AB on a smooth level plane (Pommier, 8.3.2 exercise 1). alpha turns it about the
vertical, beta about its edge: beta is the angle of its plane with the ground (of its normal z with z_g); the centre of mass is
at HG = b y from the edge, at the height b sin(beta). x and y are the horizontal coordinates of G. The released coordinates lift
the edge off the plane, and tilt it: the reactions are the force N of the plane and its moment about the horizontal through H
normal to AB. As it stands, a right-angled triangle, its right angle at A."""
from torsor.scene import Inertia, Scene, axis, cos, form

scene = Scene("falling_plate", "A plate falls with its edge on a smooth plane")

M = scene.parameter("M", "kg", 1)
edge = scene.parameter("edge", "m", 0.6)  # AB
height = scene.parameter("height", "m", 0.9)  # of the triangle
g = scene.parameter("g", "m/s^2", 9.81)
b = scene.run_time_parameter("b", "m", height / 3)
# Inertia operator at G in the plate's axes: [A F 0; F B 0; 0 0 A+B], A and B the integrals of y² and x², F that of
# -x y, counted from G.
A = scene.run_time_parameter("A", "kg m^2", M * height * height / 18)
B = scene.run_time_parameter("B", "kg m^2", M * edge * edge / 18)
F = scene.run_time_parameter("F", "kg m^2", M * edge * height / 36)

x = scene.coordinate("x", "m")
y = scene.coordinate("y", "m")
alpha = scene.coordinate("alpha", "rad")
beta = scene.coordinate("beta", "rad")
N = scene.released_coordinate("N", "m")
moment = scene.released_coordinate("moment", "rad")
scene.initial(beta, 1.4)

along_x = scene.prismatic("along_x", scene.ground, axis.x, x)
along_y = scene.prismatic("along_y", along_x, axis.y, y)
lift = scene.prismatic("lift", along_y, axis.z, N)
turned = scene.revolute("turned", lift, axis.z, alpha)
# The foot H of G on the plane's edge: -b cos(beta) along the horizontal normal to the edge.
foot = scene.prismatic("foot", turned, axis.y, -b * cos(beta))
tilted = scene.revolute("tilted", foot, axis.y, moment)
plate = scene.revolute("plate", tilted, axis.x, beta)
scene.body("plate", plate, Inertia.general(M, A, B, A + B, F).at((0, b, 0)))
scene.gravity((0, 0, -g))
# For pictures: the plate's edges. The right angle is at A.
at_A, at_B, top = (-edge / 3, 0, 0), (2 * edge / 3, 0, 0), (-edge / 3, height, 0)
for start, end in ((at_A, at_B), (at_B, top), (top, at_A)):
    scene.show(plate, form.Segment(start, end, edge / 60))

if __name__ == "__main__":
    scene.main()
