# SPDX-License-Identifier: MIT
"""Press-loading robot (Pommier, 8.3.2 exercise 7), plane x0, y0 with y0 up. S1 turns about (Oo, z0) by alpha, driven by the
torque C01; S2 slides along (O1, x1) by x, driven by the force F12; S3 turns about (O2, z0) by beta relative to S2, driven by
the torque C23. Oo O1 = h y1, O1 G1 = L1 x1, O2 G2 = L2 x1, O2 G3 = -L3 x3. I1, I2, I3 are moments of inertia about (Oo, z0),
(O2, z0), (O2, z0), as the exercise gives them."""
from torsor.scene import Inertia, Scene, axis, form, quantity

scene = Scene("loading_robot", "Press-loading robot: motor actions and the transverse reaction Y12")

h = scene.parameter("h", "m", 0.5)
L1 = scene.parameter("L1", "m", 0.3)
L2 = scene.parameter("L2", "m", 0.4)
L3 = scene.parameter("L3", "m", 0.2)
m1 = scene.parameter("m1", "kg", 60)
m2 = scene.parameter("m2", "kg", 25)
m3 = scene.parameter("m3", "kg", 8)
I1 = scene.parameter("I1", "kg m^2", 30)
I2 = scene.parameter("I2", "kg m^2", 6)
I3 = scene.parameter("I3", "kg m^2", 0.5)
g = scene.parameter("g", "m/s^2", 9.81)

alpha = scene.coordinate("alpha", "rad")
x = scene.coordinate("x", "m")
beta = scene.coordinate("beta", "rad")
# The slide does not move along y1: this coordinate is held at zero, and the reaction against it is Y12.
Y12 = scene.released_coordinate("Y12", "m")
scene.initial(alpha, 0.4, quantity("0.2", "rad/s"))
scene.initial(x, 0.6, quantity("-0.1", "m/s"))
scene.initial(beta, 0.7)

S1 = scene.revolute("S1", scene.ground, axis.z, alpha)
guide = scene.prismatic("guide", S1, axis.y, Y12, origin=(0, h, 0))
S2 = scene.prismatic("S2", guide, axis.x, x)
S3 = scene.revolute("S3", S2, axis.z, beta)
# Where moments are taken to find one unknown at a time.
scene.point("Oo", scene.ground, (0, 0, 0))
scene.point("O2", S2, (0, 0, 0))
def plane(mass, about_z):
    """In a plane motion nothing but the moment about z matters, here moved to the centres of mass (Huygens)."""
    return Inertia.general(mass, 0, 0, about_z)


scene.body("S1", S1, plane(m1, I1 - m1 * (L1 * L1 + h * h)).at((L1, h, 0)))
scene.body("S2", S2, plane(m2, I2 - m2 * L2 * L2).at((L2, 0, 0)))
scene.body("S3", S3, plane(m3, I3 - m3 * L3 * L3).at((-L3, 0, 0)))

scene.gravity((0, -g, 0))
scene.motor("C01", alpha)
scene.motor("F12", x)
scene.motor("C23", beta)
# For pictures: the column with its rail, the slide, the arm.
scene.show(S1, form.Segment((0, 0, 0), (0, h, 0), h / 12))
scene.show(S1, form.Segment((-L1 / 2, h, 0), (2 * L1, h, 0), h / 30))
scene.show(S2, form.Segment((0, 0, 0), (2 * L2, 0, 0), h / 20))
scene.show(S3, form.Segment((0, 0, 0), (-2 * L3, 0, 0), h / 25))
scene.show(S3, form.Sphere(h / 12))

if __name__ == "__main__":
    scene.main()
