# SPDX-License-Identifier: MIT
"""Mass M on a spring from a support that a shaker moves along the vertical by h sin(omega t) (Pommier, §6.5.3). The coordinate
x is the height of the mass above the support: both ends of the spring are seen and -k (x - l0)²/2 is a force function with a
potential energy. The force of the shaker is asked for by releasing the motion it imposes."""
from torsor.scene import Inertia, Scene, axis, sin

scene = Scene("shaker", "Mass on a spring from a shaken support")

M = scene.parameter("M", "kg", 1)
k = scene.parameter("k", "N/m", 400)
l0 = scene.parameter("l0", "m", 0.2)
g = scene.parameter("g", "m/s^2", 9.81)
h = scene.parameter("h", "m", 0.01)
omega = scene.run_time_parameter("omega", "rad/s", 15)

height = scene.coordinate("height", "m")
x = scene.coordinate("x", "m")
drive = scene.released_coordinate("drive", "m")
scene.drive(height, h * sin(omega * scene.time))
# At rest in the ground, where the spring carries the weight: the support starts at h omega below the mass.
scene.initial(x, l0 - M * g / k, -h * omega)

table = scene.prismatic("table", scene.ground, axis.y, drive)
support = scene.prismatic("support", table, axis.y, height)
scene.body("mass", scene.prismatic("mass", support, axis.y, x), Inertia.point(M))
scene.gravity((0, -g, 0))
scene.spring("spring", x, k, l0)

if __name__ == "__main__":
    scene.main()
