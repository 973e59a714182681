# SPDX-License-Identifier: MIT
"""Five equal balls hang side by side and touch without a force; the first is drawn aside and let go. Its threads stay tight and
count as rods. What the others do depends on the law of impact, of which the scene says nothing but e."""
from torsor.scene import Inertia, Scene, axis, shape

scene = Scene("newton_cradle", "Newton's cradle of five balls")
balls = 5

l = scene.parameter("l", "m", 1)
R = scene.parameter("R", "m", 0.05)
m = scene.parameter("m", "kg", 0.5)
g = scene.parameter("g", "m/s^2", 9.81)
e = scene.run_time_parameter("e", "1", 1)
scene.gravity((0, 0, -g))

before = scene.ground
for i in range(balls):
    a = scene.coordinate(f"a{i + 1}", "rad")
    if i == 0:
        scene.initial(a, 0.3)
    hook = scene.weld(f"hook{i + 1}", scene.ground, origin=(2 * i * R, 0, 0))
    # A positive angle draws the ball back, to -x.
    thread = scene.revolute(f"thread{i + 1}", hook, axis.y, a)
    ball = scene.weld(f"ball{i + 1}", thread, origin=(0, 0, -l))
    scene.body(f"ball{i + 1}", ball, Inertia.point(m))
    if i > 0:
        scene.contact(f"touch{i}", shape.Sphere(ball, R), shape.Sphere(before, R), restitution=e)
    before = ball

if __name__ == "__main__":
    scene.main()
