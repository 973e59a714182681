# SPDX-License-Identifier: MIT
"""Two friction wheels (Pommier, §3.4.4). S1 turns about (O, z), S2 about (A, z), OA = (r1 + r2) y; they roll on each other
without slipping at I, OI = r1 y. A motor turns S1, a viscous load holds S2 back. T is the force of S2 on S1 along x."""
from torsor.scene import Inertia, Rotation, Scene, axis, cos, form, quantity, sin

scene = Scene("friction_wheels", "Two friction wheels rolling on each other without slipping")

r1 = scene.parameter("r1", "m", 0.1)
r2 = scene.parameter("r2", "m", 0.3)
m1 = scene.parameter("m1", "kg", 2)
m2 = scene.parameter("m2", "kg", 18)
c = scene.parameter("c", "N m s", 0.9)

theta_1 = scene.coordinate("theta_1", "rad")
theta_2 = scene.coordinate("theta_2", "rad")
rate = quantity("6", "rad/s")
scene.initial(theta_1, 0, rate)
scene.initial(theta_2, 0, -r1 / r2 * rate)

S1 = scene.revolute("S1", scene.ground, axis.z, theta_1)
S2 = scene.revolute("S2", scene.ground, axis.z, theta_2, origin=(0, r1 + r2, 0))
scene.body("S1", S1, Inertia.disk(m1, r1, 2))
scene.body("S2", S2, Inertia.disk(m2, r2, 2))
I = scene.point("I", scene.ground, (0, r1, 0))
# The same place seen from either wheel: its velocity is that of the wheel's own point there.
scene.point("I1", S1, (r1 * sin(theta_1), r1 * cos(theta_1), 0))
scene.point("I2", S2, (-r2 * sin(theta_2), -r2 * cos(theta_2), 0))
# The normal at I is the line of centres. Along the axes z the wheels cannot slip: that condition is an identity.
contact = scene.weld("contact", scene.ground, rotation=Rotation.about(0, -6))
rolling = scene.rolling("rolling", body=S1, on=S2, contact=I, tangents=contact)
scene.reaction(rolling[0], "T", body=S1, contact=I, direction=axis.x, axes=scene.ground, other=S2)

# For pictures: the wheels, each with a spoke.
for wheel, radius in ((S1, r1), (S2, r2)):
    scene.show(wheel, form.Cylinder(radius, r1 / 4))
    scene.show(wheel, form.Segment((0, 0, r1 / 8), (0, radius, r1 / 8), r1 / 30), colour=(0.9, 0.9, 0.9))

scene.motor("C1", theta_1)
scene.rotational_drag("load", S2, c)

if __name__ == "__main__":
    scene.main()
