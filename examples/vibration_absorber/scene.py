# SPDX-License-Identifier: MIT
"""Vibration absorber (Pommier, §6.2.4 and §7.2.2). A machine support slides along x on a spring; its rotor carries an unbalance
and turns at constant speed; a simple pendulum hangs from the support. z points down, y completes the frame. The pendulum's
centre is d z2 from the pivot, the unbalance R z3."""
from torsor.scene import Inertia, Scene, axis

scene = Scene("vibration_absorber", "Vibration absorber: unbalanced machine on a spring, with a pendulum")

M1 = scene.parameter("M1", "kg", 10)
M2 = scene.parameter("M2", "kg", 1)
M3 = scene.parameter("M3", "kg", 0.1)
R = scene.parameter("R", "m", 0.02)
g = scene.parameter("g", "m/s^2", 9.81)
K = scene.parameter("K", "N/m", 1000)
X0 = scene.parameter("X0", "m", 0.1)
# Tuned as they stand: omega^2 = g / d.
d = scene.run_time_parameter("d", "m", 0.0981)
omega = scene.run_time_parameter("omega", "rad/s", 10)

X = scene.coordinate("X", "m")
theta = scene.coordinate("theta", "rad")
phi = scene.coordinate("phi", "rad")
scene.drive(phi, omega * scene.time)
scene.initial(X, 0.11)
scene.initial(theta, 0.3)

support = scene.prismatic("support", scene.ground, axis.x, X)
pendulum = scene.revolute("pendulum", support, axis.y, theta)
rotor = scene.revolute("rotor", support, axis.y, phi)
scene.point("G1", support, (0, 0, 0))
scene.body("support", support, Inertia.point(M1))
scene.body("pendulum", pendulum, Inertia.point(M2).at((0, 0, d)))
scene.body("unbalance", rotor, Inertia.point(M3).at((0, 0, R)))

scene.gravity((0, 0, g))
scene.spring("support_spring", X, K, X0)

if __name__ == "__main__":
    scene.main()
