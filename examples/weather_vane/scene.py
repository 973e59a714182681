# SPDX-License-Identifier: MIT
"""Weather vane (Pommier, 8.2 exercise 1): a thin quarter disk in the plane x, y1 of its axes turns by theta about (O, x), one
of the two radii that bound it; x is vertical. A wind along y turns it round and the hinge holds it back a little. The other
five directions of the hinge are released virtually: nothing else acts on the plate, so that the hinge's reactions in them are
the components of the dynamic screw in O."""
from torsor.scene import Inertia, Scene, axis, cos, quantity

scene = Scene("weather_vane", "Weather vane: a quarter disk turning about one of its radii")

R = scene.parameter("R", "m", 0.3)
m = scene.parameter("m", "kg", 2)
C = scene.parameter("C", "N m", 0.4)
c = scene.parameter("c", "N m s", 0.02)

theta = scene.coordinate("theta", "rad")
scene.initial(theta, 2, quantity("1", "rad/s"))
# Force of the ground on the hinge along x, y, z and its moment in O about y and z.
X = scene.released_coordinate("X", "m")
Y = scene.released_coordinate("Y", "m")
Z = scene.released_coordinate("Z", "m")
M_y = scene.released_coordinate("M_y", "rad")
M_z = scene.released_coordinate("M_z", "rad")

along_x = scene.prismatic("along_x", scene.ground, axis.x, X)
along_y = scene.prismatic("along_y", along_x, axis.y, Y)
along_z = scene.prismatic("along_z", along_y, axis.z, Z)
about_y = scene.revolute("about_y", along_z, axis.y, M_y)
about_z = scene.revolute("about_z", about_y, axis.z, M_z)
vane = scene.revolute("vane", about_z, axis.x, theta)

scene.body("vane", vane, Inertia.quarter_disk(m, R, 2))
# The wind would have the plate along y: U = C cos(theta).
scene.force_function("wind", C * cos(theta))
scene.damper("hinge", theta, c)

if __name__ == "__main__":
    scene.main()
