# SPDX-License-Identifier: MIT
"""Rotor of four blades (Pommier, 8.2 exercise 2): thin homogeneous rectangles of mass m, at right angles around z, each turned
by alpha about its span out of the plane A, x, y. A blade reaches from s to s + l from A, its chord is w. The rotor turns in any
way about A, placed by the unit quaternion e: its mass matrix is its inertia operator in A."""
from torsor.scene import Inertia, Rotation, Scene, axis, quantity

scene = Scene("four_blade_rotor", "Rotor of four blades set at a pitch, turning about its centre")

m = scene.parameter("m", "kg", 30)
s = scene.parameter("s", "m", 0.5)
l = scene.parameter("l", "m", 5)
w = scene.parameter("w", "m", 0.4)
alpha = scene.run_time_parameter("alpha", "rad", 0.2)

e = scene.attitude("e")
scene.initial(e, (1, 0, 0, 0), (quantity("0.4", "rad/s"), quantity("0.3", "rad/s"), quantity("5", "rad/s")))

rotor = scene.spherical("rotor", scene.ground, e)
for i in range(4):
    arm = scene.weld(f"arm_{i + 1}", rotor, rotation=Rotation.about(2, 6 * i))
    blade = scene.revolute(f"blade_{i + 1}", arm, axis.x, alpha)
    scene.body(f"blade_{i + 1}", blade, Inertia.plate(m, l, w).at((s + l / 2, 0, 0)))

if __name__ == "__main__":
    scene.main()
