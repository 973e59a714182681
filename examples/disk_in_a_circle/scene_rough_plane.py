# SPDX-License-Identifier: MIT
"""The disk on a plane of friction f, and nothing assumed of the contact: it rolls round its circle while f suffices, slips
where it does not, and leaves the plane where that does not press."""
from disk import add_disk

from torsor.scene import Scene, axis, shape

scene = Scene("disk_in_a_circle_rough_plane", "Disk in a circle on a plane whose friction may not suffice")

rho = scene.parameter("rho", "m", 2)
m = scene.parameter("m", "kg", 1)
g = scene.parameter("g", "m/s^2", 9.81)
f = scene.run_time_parameter("f", "1", 1.2)
disk = add_disk(scene, rho, m, g)
scene.contact("plane", shape.Disc(disk, axis.z, rho), shape.Plane(scene.ground), friction=f)

if __name__ == "__main__":
    scene.main()
