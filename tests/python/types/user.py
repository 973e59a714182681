# SPDX-License-Identifier: GPL-3.0-or-later
"""What a type checker says to somebody who uses the package. A remark `type: ignore` that is not needed is an error too:
each of them marks a mistake that must be found. Never run."""

from fractions import Fraction

import numpy as np

import torsor
from torsor import scene as ts

arm: torsor.Mechanism = torsor.load("arm.urdf", kernels=["inverse_dynamics"])
q = np.zeros(7)
torque = arm.inverse_dynamics(q, q, q, parameters={"m": 2.0})
motion = arm.simulate(np.linspace(0.0, 1.0, 11), q, q)
angles: np.ndarray = motion.q  # type: ignore[type-arg]
arm.inverse_dynamics(q, q, q, threads="two")  # type: ignore[arg-type]
arm.simulate(1.0, method=3)  # type: ignore[arg-type]
felt: torsor.TaskInertia = arm.task_inertia("hand", q, rows="translation", pseudo_inverse=True)
arm.task_inertia(3, q)  # type: ignore[arg-type]
torsor.load(7)  # type: ignore[arg-type]

pendulum = ts.Scene("pendulum")
a = pendulum.coordinate("a", "rad")
pendulum.initial(a, Fraction(1, 3))
rod = pendulum.revolute("rod", pendulum.ground, ts.axis.y, a)
described: torsor.Mechanism = torsor.load(pendulum)
pendulum.revolute("rod", pendulum.ground)  # type: ignore[call-arg]
pendulum.body("rod", rod, 3)  # type: ignore[arg-type]
