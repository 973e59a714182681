# SPDX-License-Identifier: MIT
"""What a motion gives, and why it ended."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

MOTION_STATUSES = ("reached the end time", "stopped", "unusable options: times, tolerances or steps",
                   "the step fell below the resolution of time", "the step limit was met",
                   "the model could not be evaluated: its equations are singular there, a formula has no value (or, for the "
                   "method taylor, no series), or loops are at a dead centre of a friction",
                   "an implicit step did not converge",
                   "the method does not suit the model",
                   "no regimes fulfil the laws of contact: rigid bodies have no motion here (Painleve)",
                   "the impact law gave energy: choose another, or a smaller restitution",
                   "a contact starts below its surface", "the loops cannot be closed near the start",
                   "a contact has coefficients that no surface has", "there are too many events for their limit",
                   "an event of a contact could not be followed",
                   "the energetic law of impact is one of a single contact, and several touch", "no memory",
                   "a contact that slides jams: the equations become singular, and what follows is not determined",
                   "the constraints of loops lose rank here, a change point: a motion with contacts does not pass it",
                   "a contact has no single point or normal here, as a disc that lies flat, or its gap, or the rate of its gap, "
                   "falls by a jump",
                   "a quaternion of the start is zero: it has no direction",
                   "no impulses fulfil the law of impact, or its collisions have no end: choose another law, or a smaller "
                   "restitution",
                   "no regimes of contacts were found, and they are too many to try all: begin beside such a state")


class Motion(NamedTuple):
    """States at given times. With many motions, ``states`` is (..., times, n) and ``status`` (...)."""

    times: np.ndarray
    q: np.ndarray
    v: np.ndarray
    energy: np.ndarray | None
    """T - U at each time, where the mechanism has the kernel ``energy``."""
    ok: Any
    """Whether the last time was reached; what was not reached is NaN."""
    status: Any
    calls: Any
    """Evaluations of the equations of motion."""
    events: Any = ()
    """What happened to contacts: a tuple of ContactEvent; with many motions an array of such tuples."""
    regimes: np.ndarray | None = None
    """Of contacts, (..., times, contacts), in the order of `Mechanism.contact_descriptions`: 0 open, 1 sticks, 2 slides; -1
    where a time was not reached."""

    @property
    def states(self) -> np.ndarray:
        """(q, v) as one vector, (..., times, n)."""
        return np.concatenate([self.q, self.v], axis=-1)
