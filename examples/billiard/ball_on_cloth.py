# SPDX-License-Identifier: MIT
from torsor.scene import Inertia, Scene, shape


def ball_on_cloth(name, title, law):
    """A uniform ball that flies, slides and rolls over its cloth, z = 0 (Pommier, 8.3.2 exercise 3), of which `law` says what it is
    made of. Nothing is assumed of the contact. It starts as the exercise's ball: struck in its middle, it slides."""
    scene = Scene(name, title)

    R = scene.parameter("R", "m", 0.028575)
    m = scene.parameter("m", "kg", 0.17)
    g = scene.parameter("g", "m/s^2", 9.81)
    cloth = law(scene)

    x = scene.coordinate("x", "m")
    y = scene.coordinate("y", "m")
    z = scene.coordinate("z", "m")
    turn = scene.attitude("turn")
    scene.initial(x, 0, 2)
    scene.initial(z, R)

    ball = scene.free("ball", scene.ground, (x, y, z), turn)
    scene.body("ball", ball, Inertia.solid_sphere(m, R))
    scene.gravity((0, 0, -g))
    scene.contact("cloth", shape.Sphere(ball, R), shape.Plane(scene.ground), **cloth)
    return scene
