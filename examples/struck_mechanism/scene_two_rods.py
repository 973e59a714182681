# SPDX-License-Identifier: MIT
"""Two equal uniform rods AB and BC, jointed at B and free in the plane x, z, lie in one line along x. A ball that moves along z
strikes A. Both rods are free bodies: B is a joint that closes a loop, so that its impulse is known."""
from torsor.scene import Inertia, Rotation, Scene, axis, shape

scene = Scene("struck_mechanism_two_rods", "Two jointed rods struck by a ball")

l = scene.parameter("l", "m", 1)
m = scene.parameter("m", "kg", 1)
m_ball = scene.parameter("m_ball", "kg", 0.5)
r = scene.parameter("r", "m", 0.05)
e = scene.run_time_parameter("e", "1", 0.5)

x1 = scene.coordinate("x1", "m")
z1 = scene.coordinate("z1", "m")
w1 = scene.coordinate("w1", "rad")
x2 = scene.coordinate("x2", "m")
z2 = scene.coordinate("z2", "m")
w2 = scene.coordinate("w2", "rad")
z = scene.coordinate("z", "m")
scene.initial(x1, l / 2)
scene.initial(x2, 3 * l / 2)
scene.initial(z, -r, 1)

def free_rod(name, x, z, w):
    """Turns are counted from x to z, that is about -y."""
    slide = scene.prismatic(name + "_slide", scene.ground, axis.x, x)
    lift = scene.prismatic(name + "_lift", slide, axis.z, z)
    rod = scene.revolute(name, lift, (0, -1, 0), w)
    scene.body(name, rod, Inertia.rod(m, l, 0))
    return rod


ab, bc = free_rod("ab", x1, z1, w1), free_rod("bc", x2, z2, w2)
b1 = scene.point("B1", ab, (l / 2, 0, 0))
b2 = scene.point("B2", bc, (-l / 2, 0, 0))
scene.closure("B_x", b1, b2, axis.x)
scene.closure("B_z", b1, b2, axis.z)

# The ball comes from below: the normal of the rod's lower side is -z.
lower = scene.weld("lower", ab, rotation=Rotation.about(0, 12))
ball = scene.prismatic("ball", scene.ground, axis.z, z)
scene.body("ball", ball, Inertia.point(m_ball))
scene.contact("blow", shape.Sphere(ball, r), shape.Plane(lower), restitution=e)

if __name__ == "__main__":
    scene.main()
