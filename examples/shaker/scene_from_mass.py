# SPDX-License-Identifier: MIT
"""The same mass alone, in the absolute frame: y is its height, and the spring is an outside action on it with the force
function U = -k (y - h sin(omega t) - l0)²/2 (Pommier, §6.5.3, where the square is lost in dU/dy). U is no potential energy: its
part dU/dt at constant y is no power of anything that acts on the mass."""
from torsor.scene import Inertia, Scene, axis, sin

scene = Scene("shaker_from_mass", "Mass on a spring from a shaken support, seen from the mass alone")

M = scene.parameter("M", "kg", 1)
k = scene.parameter("k", "N/m", 400)
l0 = scene.parameter("l0", "m", 0.2)
g = scene.parameter("g", "m/s^2", 9.81)
h = scene.parameter("h", "m", 0.01)
omega = scene.run_time_parameter("omega", "rad/s", 15)

y = scene.coordinate("y", "m")
scene.initial(y, l0 - M * g / k)

scene.body("mass", scene.prismatic("mass", scene.ground, axis.y, y), Inertia.point(M))
scene.gravity((0, -g, 0))
scene.force_function("spring", -k / 2 * (y - h * sin(omega * scene.time) - l0)**2)

if __name__ == "__main__":
    scene.main()
