# SPDX-License-Identifier: MIT
from torsor.scene import Inertia, cos, euler, pi, quantity, sin, sqrt


def add_disk(scene, rho, m, g):
    """Thin heavy disk of radius rho whose centre G goes round a circle of radius R at the height h (Pommier, 8.3.2 exercise 2).
    Euler's angles psi, theta, phi about z, x1, z2; the axis of the disk is z2. Six coordinates, so that nothing is assumed of
    the plane."""
    x = scene.coordinate("x", "m")
    y = scene.coordinate("y", "m")
    z = scene.coordinate("z", "m")
    psi = scene.coordinate("psi", "rad")
    theta = scene.coordinate("theta", "rad")
    phi = scene.coordinate("phi", "rad")

    # The exercise's numbers: R = 10 m and h = 1 m = rho sin(theta). Question 1 of the page derives the rate of psi.
    R = quantity("10", "m")
    lean = pi / 6
    h, d = rho * sin(lean), rho * cos(lean)
    turning = sqrt(4 * g * d / (h * (6 * R + d)))
    scene.initial(x, 0, R * turning)
    scene.initial(y, -R)
    scene.initial(z, h)
    scene.initial(psi, 0, turning)
    scene.initial(theta, lean)
    scene.initial(phi, 0, -turning * (R + d) / rho)

    disk = scene.free("disk", scene.ground, euler, (x, y, z), (psi, theta, phi))
    scene.body("disk", disk, Inertia.disk(m, rho, 2))
    scene.gravity((0, 0, -g))
    return disk
