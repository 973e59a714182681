# SPDX-License-Identifier: MIT
"""Rigid body left to itself, its centre of mass at rest (Euler and Poinsot). Its orientation is a unit quaternion, its
velocities are the components of the angular velocity along its own axes: no orientation is singular."""
from torsor.scene import Inertia, Scene, quantity

scene = Scene("torque_free_body", "Rigid body without any torque")

m = scene.parameter("m", "kg", 1)
I1 = scene.run_time_parameter("I1", "kg m^2", 1)
I2 = scene.run_time_parameter("I2", "kg m^2", 2)
I3 = scene.run_time_parameter("I3", "kg m^2", 3)

e = scene.attitude("e")
rate = quantity("1", "rad/s")
scene.initial(e, (1, 0, 0, 0), (rate, 0, rate))

body = scene.spherical("body", scene.ground, e)
scene.body("body", body, Inertia.general(m, I1, I2, I3))

if __name__ == "__main__":
    scene.main()
