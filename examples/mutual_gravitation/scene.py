# SPDX-License-Identifier: MIT
"""Two point masses m1 = s m and m2 = (1 - s) m that attract each other, U = G m1 m2 / r (Pommier, §5.2.4), in the plane of
their motion. X and Y place their common centre of mass, r and phi the second as seen from the first: coordinates in which
momenta are cyclic. Units of its own: G = 1. They start at their closest on an ellipse of semi-major axis 1 and eccentricity
0.6, while the centre of mass drifts."""
from torsor.scene import Inertia, Scene, axis, quantity

scene = Scene("mutual_gravitation", "Two masses under their mutual gravitation")

G = scene.parameter("G", "m^3/(kg s^2)", 1)
m = scene.parameter("m", "kg", 4)
s = scene.parameter("s", "1", 0.75)

X = scene.coordinate("X", "m")
Y = scene.coordinate("Y", "m")
r = scene.coordinate("r", "m")
phi = scene.coordinate("phi", "rad")
scene.initial(X, 0, quantity("0.25", "m/s"))
scene.initial(Y, 0, quantity("-0.125", "m/s"))
scene.initial(r, 0.4)
scene.initial(phi, 0, quantity("10", "rad/s"))

drift = scene.prismatic("drift", scene.ground, axis.x, X)
center = scene.prismatic("center", drift, axis.y, Y)
line = scene.revolute("line", center, axis.z, phi)
first = scene.prismatic("first", line, axis.x, -(1 - s) * r)
second = scene.prismatic("second", line, axis.x, s * r)
scene.body("first", first, Inertia.point(s * m))
scene.body("second", second, Inertia.point((1 - s) * m))
P1 = scene.point("P1", first, (0, 0, 0))
P2 = scene.point("P2", second, (0, 0, 0))
scene.gravitation("attraction", P1, P2, G * s * m * (1 - s) * m)

if __name__ == "__main__":
    scene.main()
