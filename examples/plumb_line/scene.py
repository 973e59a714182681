# SPDX-License-Identifier: MIT
"""Plumb line on the turning earth (Pommier, §6.3.4). The earth, a sphere, turns at omega about z_g; at the latitude, at the
distance r from its centre O, n points upwards and t to the north (the pole), east completes them. A bob of mass m hangs on a
thread of length l from r n + l n: delta turns it towards the north in the meridian plane, epsilon sideways. The thread's
tension is asked for by releasing its length. The earth attracts with m K M_e / OG^2."""
from torsor.scene import Inertia, Scene, axis, pi, quantity

scene = Scene("plumb_line", "Plumb line on the turning earth")

K = scene.parameter("K", "N m^2/kg^2", quantity("6.67e-11", "N m^2/kg^2"))
earth = scene.parameter("M_e", "kg", quantity("5.9742e24", "kg"))
m = scene.parameter("m", "kg", 1)
l = scene.parameter("l", "m", 1)
omega = scene.parameter("omega", "rad/s", 2 * pi / quantity("86400", "s"))
r = scene.run_time_parameter("r", "m", 6371000)
latitude = scene.run_time_parameter("latitude", "rad", pi / 4)

theta = scene.coordinate("theta", "rad")
delta = scene.coordinate("delta", "rad")
epsilon = scene.coordinate("epsilon", "rad")
tension = scene.released_coordinate("tension", "m")
scene.drive(theta, omega * scene.time)
scene.initial(delta, 0.1)

# Axes of the place: x is n, y points east, z is t.
globe = scene.revolute("globe", scene.ground, axis.z, theta)
place = scene.revolute("place", globe, (0, -1, 0), latitude)
meridian = scene.revolute("meridian", place, axis.y, delta, origin=(r + l, 0, 0))
thread = scene.revolute("thread", meridian, axis.z, epsilon)
bob = scene.prismatic("bob", thread, axis.x, tension)
scene.body("bob", bob, Inertia.point(m).at((-l, 0, 0)))
O = scene.point("O", scene.ground, (0, 0, 0))
G = scene.point("G", bob, (-l, 0, 0))
scene.gravitation("attraction", O, G, K * earth * m)

if __name__ == "__main__":
    scene.main()
