# SPDX-License-Identifier: MIT
"""A clock with a recoil escapement. A weight on a cord drives a wheel with round pins, and an anchor on the pendulum carries two
round pallets. Each pin that pushes a pallet out of its way gives the pendulum some energy, until it comes free and another pin
falls onto the other pallet, without restitution. The cord counts as tight."""
from torsor.scene import Inertia, Scene, axis, cos, form, pi, shape, sin, sqrt

scene = Scene("clock_escapement", "A weight, a wheel of pins, an anchor and a pendulum: a clock")
pins = 10

R = scene.parameter("R", "m", 0.03)
r_pin = scene.parameter("r_pin", "m", 0.0016)
r_pallet = scene.parameter("r_pallet", "m", 0.005)
# How far the pallets' centres are outside the circle of the pins' while the pendulum is upright.
clear = scene.parameter("clear", "m", 0.0046)
r_drum = scene.parameter("r_drum", "m", 0.0015)
m_wheel = scene.parameter("m_wheel", "kg", 0.01)
J_wheel = scene.parameter("J_wheel", "kg m^2", 5e-6)
l = scene.parameter("l", "m", 0.25)
m_bob = scene.parameter("m_bob", "kg", 0.2)
d = scene.parameter("d", "N m s/rad", 0.0015)
g = scene.parameter("g", "m/s^2", 9.81)
weight = scene.run_time_parameter("weight", "kg", 0.1)
f = scene.run_time_parameter("f", "1", 0.1)

# Both turn clockwise for who looks along y, as hands of a clock do.
psi = scene.coordinate("psi", "rad")
theta = scene.coordinate("theta", "rad")
scene.initial(psi, -pi / 36)
scene.initial(theta, 0.12)

wheel = scene.revolute("wheel", scene.ground, axis.y, psi)
hung = scene.prismatic("hung", scene.ground, axis.z, -r_drum * psi, origin=(r_drum, 0, -2 * R))
# The pivot is where tangents at 45 degrees on both sides of the wheel's top meet, so that pallets move along its radii.
anchor = scene.revolute("anchor", scene.ground, axis.y, theta, origin=(0, 0, sqrt(2) * R))
scene.body("wheel", wheel, Inertia.general(m_wheel, J_wheel, J_wheel, J_wheel))
scene.body("weight", hung, Inertia.point(weight))
scene.body("bob", anchor, Inertia.point(m_bob).at((0, 0, -l)))
scene.damper("air", theta, d)
scene.gravity((0, 0, -g))

aside = (R + clear) / sqrt(2)
above = aside - sqrt(2) * R
entry = scene.weld("entry", anchor, origin=(-aside, 0, above))
exit_ = scene.weld("exit", anchor, origin=(aside, 0, above))
for i in range(pins):
    angle = 2 * pi * i / pins
    pin = scene.weld(f"pin{i + 1}", wheel, origin=(R * sin(angle), 0, R * cos(angle)))
    scene.contact(f"entry{i + 1}", shape.Sphere(pin, r_pin), shape.Sphere(entry, r_pallet), friction=f)
    scene.contact(f"exit{i + 1}", shape.Sphere(pin, r_pin), shape.Sphere(exit_, r_pallet), friction=f)
    scene.show(wheel, form.Segment((0, 0, 0), (R * sin(angle), 0, R * cos(angle)), r_pin / 2))
    scene.show(pin, form.Sphere(r_pin))
scene.show(entry, form.Sphere(r_pallet))
scene.show(exit_, form.Sphere(r_pallet))
scene.show(anchor, form.Segment((0, 0, 0), (-aside, 0, above), r_pin))
scene.show(anchor, form.Segment((0, 0, 0), (aside, 0, above), r_pin))
scene.show(anchor, form.Segment((0, 0, 0), (0, 0, -l), r_pin / 2))
scene.show(anchor, form.Sphere(4 * r_pallet), origin=(0, 0, -l))
scene.show(hung, form.Cylinder(2 * r_pallet, 4 * r_pallet))

if __name__ == "__main__":
    scene.main()
