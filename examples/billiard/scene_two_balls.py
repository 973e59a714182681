# SPDX-License-Identifier: MIT
"""Two equal billiard balls: the first, which slides or rolls along x at 2 m/s, strikes the second, at rest 30 degrees off its
way."""
from torsor.scene import Inertia, Scene, cos, pi, shape, sin

scene = Scene("billiard_two_balls", "Billiard ball that strikes another one")

R = scene.parameter("R", "m", 0.028575)
m = scene.parameter("m", "kg", 0.17)
g = scene.parameter("g", "m/s^2", 9.81)
f = scene.run_time_parameter("f", "1", 0.2)
e = scene.run_time_parameter("e", "1", 0.93)
between = scene.run_time_parameter("f_between", "1", 0.06)

x = scene.coordinate("x", "m")
y = scene.coordinate("y", "m")
z = scene.coordinate("z", "m")
turn = scene.attitude("turn")
x2 = scene.coordinate("x2", "m")
y2 = scene.coordinate("y2", "m")
z2 = scene.coordinate("z2", "m")
turn2 = scene.attitude("turn2")
scene.initial(x, -2 * R * cos(pi / 6), 2)
scene.initial(y, -2 * R * sin(pi / 6))
scene.initial(z, R)
scene.initial(z2, R)

ball = scene.free("ball", scene.ground, (x, y, z), turn)
ball2 = scene.free("ball2", scene.ground, (x2, y2, z2), turn2)
scene.body("ball", ball, Inertia.solid_sphere(m, R))
scene.body("ball2", ball2, Inertia.solid_sphere(m, R))
scene.gravity((0, 0, -g))
scene.contact("cloth", shape.Sphere(ball, R), shape.Plane(scene.ground), friction=f)
scene.contact("cloth2", shape.Sphere(ball2, R), shape.Plane(scene.ground), friction=f)
scene.contact("balls", shape.Sphere(ball, R), shape.Sphere(ball2, R), friction=between, restitution=e)

if __name__ == "__main__":
    scene.main()
