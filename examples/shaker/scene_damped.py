# SPDX-License-Identifier: MIT
"""Not in the course: the same mass with a damper beside the spring. Their action has no force function for another reason than
that of scene_free_support.cpp: it depends on the velocity."""
from torsor.scene import Inertia, Scene, axis, sin

scene = Scene("shaker_damped", "Mass on a spring and a damper from a shaken support")

M = scene.parameter("M", "kg", 1)
k = scene.parameter("k", "N/m", 400)
c = scene.run_time_parameter("c", "N s/m", 4)
l0 = scene.parameter("l0", "m", 0.2)
g = scene.parameter("g", "m/s^2", 9.81)
h = scene.parameter("h", "m", 0.01)
omega = scene.run_time_parameter("omega", "rad/s", 15)

y = scene.coordinate("y", "m")
scene.initial(y, l0 - M * g / k)

scene.body("mass", scene.prismatic("mass", scene.ground, axis.y, y), Inertia.point(M))
scene.gravity((0, -g, 0))
length = y - h * sin(omega * scene.time)
scene.spring("spring", length, k, l0)
scene.damper("damper", length, c)

if __name__ == "__main__":
    scene.main()
