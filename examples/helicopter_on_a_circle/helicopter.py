# SPDX-License-Identifier: MIT
from types import SimpleNamespace

from torsor.scene import Inertia, Rotation, axis, quantity


def add_helicopter(scene):
    """A helicopter goes round a circle at constant speed (Pommier, 8.2 exercise 3) and carries the rotor of four_blade_rotor. The
    cell turns by psi = omega t about (O, z0); its x1 points outwards, y1 the way it flies; A lies at R x1 and the rotor's axis
    leans by theta towards the centre. The rotor turns by phi about its axis (A, z), driven by a motor.

    Six directions are released virtually: A along x1, y1, z0, and turning of the whole rotor about x, y, z of the tilted cell.
    Without gravity the reactions are the components of the rotor's dynamic screw in A."""
    m = scene.parameter("m", "kg", 30)  # of a blade; where it begins, its length and its chord
    s = scene.parameter("s", "m", 0.5)
    l = scene.parameter("l", "m", 5)
    w = scene.parameter("w", "m", 0.4)
    R = scene.parameter("R", "m", 100)
    theta = scene.run_time_parameter("theta", "rad", 0.3)
    omega = scene.run_time_parameter("omega", "rad/s", 0.2)
    alpha = scene.run_time_parameter("alpha", "rad", 0.2)  # pitch of the blades

    psi = scene.coordinate("psi", "rad")
    phi = scene.coordinate("phi", "rad")
    scene.drive(psi, omega * scene.time)
    scene.initial(phi, 0, quantity("30", "rad/s"))
    X, Y, Z = (scene.released_coordinate(name, "m") for name in ("X", "Y", "Z"))
    M_x, M_y, M_z = (scene.released_coordinate(name, "rad") for name in ("M_x", "M_y", "M_z"))

    turning = scene.revolute("turning", scene.ground, axis.z, psi)
    outwards = scene.prismatic("outwards", turning, axis.x, X, origin=(R, 0, 0))
    forwards = scene.prismatic("forwards", outwards, axis.y, Y)
    upwards = scene.prismatic("upwards", forwards, axis.z, Z)
    cell = scene.revolute("cell", upwards, axis.y, -theta)
    roll = scene.revolute("roll", cell, axis.x, M_x)
    pitch = scene.revolute("pitch", roll, axis.y, M_y)
    yaw = scene.revolute("yaw", pitch, axis.z, M_z)
    rotor = scene.revolute("rotor", yaw, axis.z, phi)
    scene.point("A", rotor, (0, 0, 0))
    arm = [scene.weld(f"arm_{i + 1}", rotor, rotation=Rotation.about(2, 6 * i)) for i in range(4)]
    scene.motor("C", phi)
    return SimpleNamespace(m=m, s=s, l=l, w=w, alpha=alpha, phi=phi, arm=arm)


def add_blade(scene, helicopter, i, angle):
    """Blade i = 1 to 4, a thin rectangle turned by `angle` about its span: its operator is the sum of a rod's along the span, which
    does not feel the pitch and whose parts cancel exactly among the four, and of m w^2/12 across its chord."""
    m, s, l, w = helicopter.m, helicopter.s, helicopter.l, helicopter.w
    span = helicopter.arm[i - 1]
    scene.body(f"span_{i}", span, Inertia.rod(m, l, 0).at((s + l / 2, 0, 0)))
    blade = scene.revolute(f"blade_{i}", span, axis.x, angle)
    across = m * w * w / 12
    scene.body(f"blade_{i}", blade, Inertia.general(0, across, 0, across))
