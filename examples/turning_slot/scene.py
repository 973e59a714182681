# SPDX-License-Identifier: MIT
"""A bead slides without friction in a straight slot that turns at a constant rate about a horizontal axis through it, in the
vertical plane x, y. The slot is no body: the bead has both coordinates, and a condition that depends on time holds it in the
line at the angle omega t from x. The slot's force N on the bead is across that line."""
from torsor.scene import Inertia, Scene, axis, cos, form, quantity, sin

scene = Scene("turning_slot", "Bead in a slot that turns in a vertical plane")

m = scene.parameter("m", "kg", 2)
g = scene.parameter("g", "m/s^2", 9.81)
omega = scene.run_time_parameter("omega", "rad/s", 2)

x = scene.coordinate("x", "m")
y = scene.coordinate("y", "m")
scene.initial(x, 0.5)
scene.initial(y, 0, quantity("0.5", "m") * omega)  # at rest in the slot

across = scene.prismatic("across", scene.ground, axis.x, x)
bead = scene.prismatic("bead", across, axis.y, y)
scene.body("bead", bead, Inertia.point(m))
scene.gravity((0, -g, 0))

turn = omega * scene.time
center = scene.point("center", bead, (0, 0, 0))
slot = scene.holonomic("slot", y * cos(turn) - x * sin(turn))
scene.reaction(slot, "N", body=bead, contact=center, direction=(-sin(turn), cos(turn), 0), axes=scene.ground)
end = quantity("1", "m")
scene.show(scene.ground, form.Segment((-end * cos(turn), -end * sin(turn), 0), (end * cos(turn), end * sin(turn), 0), end / 100))

if __name__ == "__main__":
    scene.main()
