# SPDX-License-Identifier: MIT
"""A uniform rod OB that hangs from a hinge at O is struck across by a ball at the depth d below O (Pommier, 7.6.4). The hinge's
reaction has a coordinate of its own, held at zero, so that its impulse is known."""
from torsor.scene import Inertia, Rotation, Scene, axis, shape

scene = Scene("struck_mechanism", "Hanging rod struck by a ball")

L = scene.parameter("L", "m", 1.2)
m = scene.parameter("m", "kg", 2)
m_ball = scene.parameter("m_ball", "kg", 0.3)
r = scene.parameter("r", "m", 0.05)
g = scene.parameter("g", "m/s^2", 9.81)
d = scene.run_time_parameter("d", "m", 0.9)
e = scene.run_time_parameter("e", "1", 0.5)

theta = scene.coordinate("theta", "rad")
x = scene.coordinate("x", "m")
z = scene.coordinate("z", "m")
hinge_x = scene.coordinate("hinge_x", "m")
scene.initial(x, -r, 4)
scene.initial(z, -d)

# The rod lies along -z of its frame, and the ball comes from x < 0: the line is the rod's side whose normal is -x.
hinge = scene.prismatic("hinge", scene.ground, axis.x, hinge_x)
rod = scene.revolute("rod", hinge, (0, -1, 0), theta)
side = scene.weld("side", rod, rotation=Rotation.about(1, -6))
slide = scene.prismatic("slide", scene.ground, axis.x, x)
ball = scene.prismatic("ball", slide, axis.z, z)
scene.body("rod", rod, Inertia.rod(m, L, 2).at((0, 0, -L / 2)))
scene.body("ball", ball, Inertia.point(m_ball))
scene.gravity((0, 0, -g))
scene.holonomic("hinge_holds", hinge_x)
scene.contact("blow", shape.Sphere(ball, r), shape.Plane(side), restitution=e)

if __name__ == "__main__":
    scene.main()
