# SPDX-License-Identifier: MIT
from types import SimpleNamespace

from torsor.scene import Inertia, axis, cos, pi, quantity, sin, sqrt


def add_vehicle(scene, sliding):
    """Four-wheel vehicle (Pommier, 8.1 exercise 4). The chassis S moves in the plane, its centre C at (x, y), turned by psi; O1 =
    (a, b), O2 = (-a, b), O3 = (-a, -b), O4 = (a, -b) in its axes: it drives along its y. The wheel i is steered by the constant
    angle alpha_i about the vertical, turns by phi_i about its axis (Oi, x_i) and touches the ground at Pi.

    As the angles stand, the axes of the wheels meet at (b + b sqrt(3), -b): pi/4 and pi/6 in front, rear wheels straight, a =
    b (sqrt(3) - 1). With `sliding` wheels each may slide by s_i along its axis, so that the vehicle moves whatever the
    steering."""
    b = scene.parameter("b", "m", 1)
    a = scene.parameter("a", "m", b * (sqrt(3) - 1))
    r = scene.parameter("r", "m", 0.3)
    M = scene.parameter("M", "kg", 800)
    J = scene.parameter("J", "kg m^2", 900)  # of the chassis about the vertical through C
    m = scene.parameter("m", "kg", 20)  # of a wheel, and its moments: A across, C about its axis
    A = scene.parameter("A", "kg m^2", 0.5)
    C = scene.parameter("C", "kg m^2", 0.9)

    angles = (-pi / 4, -pi / 6, 0, 0)
    # Steered otherwise, wheels that do not slide leave no motion: two conditions would no longer repeat the others.
    steering = scene.run_time_parameter if sliding else scene.parameter
    alpha = [steering(f"alpha_{i + 1}", "rad", angles[i]) for i in range(4)]
    x = scene.coordinate("x", "m")
    y = scene.coordinate("y", "m")
    psi = scene.coordinate("psi", "rad")
    # Turns about the point where the axes meet, at 1 rad/s to the right.
    rate = quantity("-1", "rad/s")
    I_x, I_y = b * (1 + sqrt(3)), -b
    scene.initial(x, 0, rate * I_y)
    scene.initial(y, 0, -rate * I_x)
    scene.initial(psi, 0, rate)

    S = scene.planar("S", scene.ground, x, y, psi, origin=(0, 0, r))
    scene.body("chassis", S, Inertia.general(M, 0, 0, J))
    O = ((a, b), (-a, b), (-a, -b), (a, -b))
    vehicle = SimpleNamespace(phi=[scene.coordinate(f"phi_{i + 1}", "rad") for i in range(4)], steered=[], wheel=[], P=[])
    for i in range(4):
        number = str(i + 1)
        steered = scene.revolute("steered_" + number, S, axis.z, alpha[i], origin=(*O[i], 0))
        if sliding:
            s = scene.coordinate("s_" + number, "m")
            steered = scene.prismatic("axle_" + number, steered, axis.x, s)
        wheel = scene.revolute("wheel_" + number, steered, axis.x, vehicle.phi[i])
        scene.body("wheel_" + number, wheel, Inertia.general(m, C, A, A))
        vehicle.steered.append(steered)
        vehicle.wheel.append(wheel)
        vehicle.P.append(scene.point("P" + number, steered, (0, 0, -r)))
        # V(Pi) . y_i = V(Oi) . y_i + r phi_i' = 0.
        along_x, along_y = rate * (I_y - O[i][1]), rate * (O[i][0] - I_x)
        forwards = -sin(angles[i]) * along_x + cos(angles[i]) * along_y
        scene.initial(vehicle.phi[i], 0, -forwards / r)
    return vehicle
