# SPDX-License-Identifier: MIT
"""The rolling hoop of scene.cpp with a parametrisation that the contact does not allow (Pommier, §6.5.5, second illustration):
six coordinates, z among them. The hoop may slip and leave the plane virtually, so the contact force X_F x1 + Y_F y1 + N z
works, and its three components are unknowns beside the accelerations."""
from torsor.scene import Inertia, Scene, axis, cos, euler, form, quantity, sin

scene = Scene("rolling_hoop_contact_forces", "Hoop rolling without slipping: six coordinates, the three contact forces")

m = scene.parameter("m", "kg", 1)
R = scene.parameter("R", "m", 1)
g = scene.parameter("g", "m/s^2", 9.81)
A = scene.run_time_parameter("A", "kg m^2", m * R * R / 2)
C = scene.run_time_parameter("C", "kg m^2", m * R * R)

x = scene.coordinate("x", "m")
y = scene.coordinate("y", "m")
z = scene.coordinate("z", "m")
psi = scene.coordinate("psi", "rad")
theta = scene.coordinate("theta", "rad")
phi = scene.coordinate("phi", "rad")

lean = 1.2
psi_rate = quantity("0.5", "rad/s")
theta_rate = quantity("-0.3", "rad/s")
phi_rate = quantity("-4", "rad/s")
scene.initial(x, 0, -R * (phi_rate + psi_rate * cos(lean)))
scene.initial(y, R * cos(lean), -R * theta_rate * sin(lean))
scene.initial(z, R * sin(lean), R * theta_rate * cos(lean))
scene.initial(psi, 0, psi_rate)
scene.initial(theta, lean, theta_rate)
scene.initial(phi, 0, phi_rate)

hoop = scene.free("hoop", scene.ground, euler, (x, y, z), (psi, theta, phi))
contact = scene.point("I", "hoop.2", (0, -R, 0))
scene.body("hoop", hoop, Inertia.general(m, A, A, C))
scene.gravity((0, 0, -g))
along_x1 = scene.no_slip("along_x1", body=hoop, contact=contact, direction=axis.x, axes="hoop.1")
along_y1 = scene.no_slip("along_y1", body=hoop, contact=contact, direction=axis.y, axes="hoop.1")
touching = scene.holonomic("touching", z - R * sin(theta))
scene.reaction(along_x1, "X_F", body=hoop, contact=contact, direction=axis.x, axes="hoop.1")
scene.reaction(along_y1, "Y_F", body=hoop, contact=contact, direction=axis.y, axes="hoop.1")
scene.reaction(touching, "N", body=hoop, contact=contact, direction=axis.z, axes=scene.ground)
# For pictures: the hoop with two diameters, which show how it turns.
scene.show(hoop, form.Torus(R, R / 30))
scene.show(hoop, form.Segment((-R, 0, 0), (R, 0, 0), R / 80))
scene.show(hoop, form.Segment((0, -R, 0), (0, R, 0), R / 80))

if __name__ == "__main__":
    scene.main()
