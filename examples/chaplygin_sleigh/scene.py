# SPDX-License-Identifier: MIT
"""Chaplygin's sleigh: a body slides on a horizontal plane without friction, on a knife edge at C that lets it run along the
blade x1 but not across it. The centre of mass lies a x1 ahead of C."""
from torsor.scene import Inertia, Scene, axis, form, quantity

scene = Scene("chaplygin_sleigh", "Chaplygin's sleigh: a knife edge on a smooth plane")

m = scene.parameter("m", "kg", 1)
J = scene.parameter("J", "kg m^2", 0.5)  # about the vertical through the centre of mass
a = scene.parameter("a", "m", 0.5)

x = scene.coordinate("x", "m")
y = scene.coordinate("y", "m")
phi = scene.coordinate("phi", "rad")
scene.initial(phi, 0, quantity("2", "rad/s"))

along_x = scene.prismatic("along_x", scene.ground, axis.x, x)
along_y = scene.prismatic("along_y", along_x, axis.y, y)
sleigh = scene.revolute("sleigh", along_y, axis.z, phi)
C = scene.point("C", sleigh, (0, 0, 0))
# In a plane motion nothing but the moment about z matters.
scene.body("sleigh", sleigh, Inertia.general(m, 0, 0, J).at((a, 0, 0)))
edge = scene.no_slip("knife_edge", body=sleigh, contact=C, direction=axis.y, axes=sleigh)
scene.reaction(edge, "N", body=sleigh, contact=C, direction=axis.y, axes=sleigh)
# For pictures: the sleigh, and the blade below its end.
scene.show(sleigh, form.Box((2 * a, a, a / 6)), origin=(3 * a / 4, 0, a / 4))
scene.show(sleigh, form.Box((a / 2, a / 40, a / 5)), origin=(0, 0, a / 10))

if __name__ == "__main__":
    scene.main()
