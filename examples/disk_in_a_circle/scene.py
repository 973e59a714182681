# SPDX-License-Identifier: MIT
"""The disk rolls without slipping on a horizontal plane, which it touches at I = G - rho y2. The plane's whole reaction is
known: the normal force N, and X along x1, the way it rolls, and Y along y1, towards the centre of the circle."""
from disk import add_disk

from torsor.scene import Scene, axis

scene = Scene("disk_in_a_circle", "Disk rolling without slipping while its centre goes round a circle")

rho = scene.run_time_parameter("rho", "m", 2)
m = scene.parameter("m", "kg", 1)
g = scene.parameter("g", "m/s^2", 9.81)
disk = add_disk(scene, rho, m, g)
I = scene.point("I", "disk.2", (0, -rho, 0))

contact = scene.point_in_plane("contact", I, scene.ground)
scene.reaction(contact, "N", body=disk, contact=I, direction=axis.z, axes="disk.1")
rolling = scene.rolling("rolling", body=disk, on=scene.ground, contact=I, tangents="disk.1")
scene.reaction(rolling[0], "X", body=disk, contact=I, direction=axis.x, axes="disk.1")
scene.reaction(rolling[1], "Y", body=disk, contact=I, direction=axis.y, axes="disk.1")

if __name__ == "__main__":
    scene.main()
