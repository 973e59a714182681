# SPDX-License-Identifier: MIT
"""A block on a spring lies on a belt that runs at the velocity v0. Friction holds more than it brakes."""
from torsor.scene import Inertia, Scene, axis, shape

scene = Scene("stick_slip_belt", "Block on a spring, carried along by a belt until it slips")

m = scene.parameter("m", "kg", 2)
k = scene.parameter("k", "N/m", 50)
g = scene.parameter("g", "m/s^2", 9.81)
v0 = scene.run_time_parameter("v0", "m/s", 0.2)
f = scene.run_time_parameter("f", "1", 0.35)
f_static = scene.run_time_parameter("f_static", "1", 0.5)

x = scene.coordinate("x", "m")
z = scene.coordinate("z", "m")

slide = scene.prismatic("slide", scene.ground, axis.x, x)
block = scene.prismatic("block", slide, axis.z, z)
scene.body("block", block, Inertia.point(m))
scene.gravity((0, 0, -g))
scene.spring("spring", x, k)
scene.contact("belt", shape.Point(scene.point("foot", block)), shape.Plane(scene.ground, belt=(v0, 0)), friction=f,
              static_friction=f_static)

if __name__ == "__main__":
    scene.main()
