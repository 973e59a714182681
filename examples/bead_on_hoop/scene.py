# SPDX-License-Identifier: MIT
"""A bead slides without friction on a hoop that a motor turns about its vertical diameter at a constant rate. theta is measured
from the lowest point. The motor's torque is asked for by releasing the motion it imposes."""
from torsor.scene import Inertia, Rotation, Scene, axis, form

scene = Scene("bead_on_hoop", "Bead on a hoop that turns about its vertical diameter")

m = scene.parameter("m", "kg", 1)
R = scene.parameter("R", "m", 1)
g = scene.parameter("g", "m/s^2", 9.81)
omega = scene.run_time_parameter("omega", "rad/s", 5)

psi = scene.coordinate("psi", "rad")
theta = scene.coordinate("theta", "rad")
motor = scene.released_coordinate("motor", "rad")
scene.drive(psi, omega * scene.time)
scene.initial(theta, 0.1)

axle = scene.revolute("axle", scene.ground, axis.z, motor)
hoop = scene.revolute("hoop", axle, axis.z, psi)
bead = scene.revolute("bead", hoop, axis.y, theta)
scene.body("bead", bead, Inertia.point(m).at((0, 0, -R)))
scene.gravity((0, 0, -g))
scene.show(hoop, form.Torus(R, R / 60), rotation=Rotation.about(0, 6))
scene.show(hoop, form.Segment((0, 0, -6 * R / 5), (0, 0, 6 * R / 5), R / 90))

if __name__ == "__main__":
    scene.main()
