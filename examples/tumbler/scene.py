# SPDX-License-Identifier: MIT
"""Tumbler (Pommier, 8.1 exercise 3): its base is a half sphere of radius R about C, which rolls without slipping on a table.
Euler's angles psi, theta, phi about z0, x1, z2; z2 is its axis of revolution and C G = -a z2, so that it stands up again. Six
coordinates: the contact z = R is a constraint, whose multiplier is the normal force. These angles are singular upright, at
theta = 0: the tumbler starts away from it."""
from torsor.scene import Inertia, Scene, axis, euler, quantity, sin

scene = Scene("tumbler", "Tumbler: a weighted half sphere rolling on a table")

R = scene.parameter("R", "m", 0.05)
a = scene.run_time_parameter("a", "m", 0.02)
m = scene.parameter("m", "kg", 0.2)
# About the centre of mass: across the axis, and about it.
A = scene.parameter("A", "kg m^2", 0.0002)
B = scene.parameter("B", "kg m^2", 0.00015)
g = scene.parameter("g", "m/s^2", 9.81)

x = scene.coordinate("x", "m")
y = scene.coordinate("y", "m")
z = scene.coordinate("z", "m")
psi = scene.coordinate("psi", "rad")
theta = scene.coordinate("theta", "rad")
phi = scene.coordinate("phi", "rad")

# Pushed sideways from a lean of 1 rad; x' = R Omega_y and y' = -R Omega_x are what rolling demands.
lean = 1
psi_rate = quantity("5", "rad/s")
phi_rate = quantity("3", "rad/s")
scene.initial(x, 0, -R * sin(lean) * phi_rate)
scene.initial(z, R)
scene.initial(psi, 0, psi_rate)
scene.initial(theta, lean)
scene.initial(phi, 0, phi_rate)

tumbler = scene.free("tumbler", scene.ground, euler, (x, y, z), (psi, theta, phi))
I = scene.sphere_contact("I", tumbler, R, scene.ground)
scene.body("tumbler", tumbler, Inertia.general(m, A, A, B).at((0, 0, -a)))
scene.gravity((0, 0, -g))

contact = scene.point_in_plane("contact", I, scene.ground)
scene.reaction(contact, "N", body=tumbler, contact=I, direction=axis.z, axes=scene.ground)
rolling = scene.rolling("rolling", body=tumbler, on=scene.ground, contact=I, tangents=scene.ground)
scene.reaction(rolling[0], "X", body=tumbler, contact=I, direction=axis.x, axes=scene.ground)
scene.reaction(rolling[1], "Y", body=tumbler, contact=I, direction=axis.y, axes=scene.ground)

if __name__ == "__main__":
    scene.main()
