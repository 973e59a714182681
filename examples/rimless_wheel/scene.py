# SPDX-License-Identifier: MIT
"""A wheel of six spokes and no rim walks down a slope: each spoke in turn strikes the ground with its foot, without
restitution, and the wheel turns about it until the next one strikes (McGeer 1990)."""
from torsor.scene import Inertia, Scene, axis, cos, form, pi, quantity, shape, sin

scene = Scene("rimless_wheel", "Rimless wheel that walks down a slope")
spokes = 6

l = scene.parameter("l", "m", 1)
m = scene.parameter("m", "kg", 2)
J = scene.parameter("J", "kg m^2", 0.5)
g = scene.parameter("g", "m/s^2", 9.81)
slope = scene.run_time_parameter("slope", "rad", 0.15)
f = scene.run_time_parameter("f", "1", 1)

x = scene.coordinate("x", "m")
z = scene.coordinate("z", "m")
phi = scene.coordinate("phi", "rad")
# Both lowest feet are on the ground; it turns about the one ahead.
rate = quantity("1", "rad/s")
scene.initial(x, 0, l * cos(pi / spokes) * rate)
scene.initial(z, l * cos(pi / spokes), l * sin(pi / spokes) * rate)
scene.initial(phi, 0, rate)

# x runs down the slope, z is its normal, and the wheel turns from z to x.
slide = scene.prismatic("slide", scene.ground, axis.x, x)
lift = scene.prismatic("lift", slide, axis.z, z)
wheel = scene.revolute("wheel", lift, axis.y, phi)
scene.body("wheel", wheel, Inertia.general(m, J, J, J))
scene.gravity((g * sin(slope), 0, -g * cos(slope)))
for i in range(spokes):
    angle = pi * (2 * i + 1) / spokes
    foot = scene.point(f"foot{i + 1}", wheel, (-l * sin(angle), 0, -l * cos(angle)))
    scene.contact(f"step{i + 1}", shape.Point(foot), shape.Plane(scene.ground), friction=f)
    scene.show(wheel, form.Segment((0, 0, 0), (-l * sin(angle), 0, -l * cos(angle)), l / 50))

if __name__ == "__main__":
    scene.main()
