# SPDX-License-Identifier: MIT
"""Contacts of a motion: what is told of their events."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Mapping, NamedTuple

import numpy as np

from . import _abi

if TYPE_CHECKING:
    from ._mechanism import Mechanism

REGIMES = ("open", "sticks", "slides")
EVENT_KINDS = ("impact", "opens", "slips", "slip ends", "accumulation")
IMPACT_LAWS = ("newton_moreau", "poisson", "energetic", "sequential")


class Contact(NamedTuple):
    """A contact that opens and closes, a stop, or dry friction."""

    gap_unit: str
    """Empty where there is no gap: dry friction, resistance to turning."""
    reaction_unit: str
    rows: int
    """Of its reactions: the normal one first, where it has a gap, then one for each tangent."""


class ContactEvent(NamedTuple):
    """What happened to a contact of a motion."""

    kind: str
    """"impact", "opens", "slips", "slip ends", or "accumulation": bounces without end are over."""
    time: float
    """[s]; of an accumulation that to which its bounces tend."""
    contact: str
    """The one that caused it."""
    regimes: Mapping[str, str]
    """Of each contact, afterwards: "open", "sticks" or "slides". Without friction a closed contact slides."""
    energy_lost: float
    """[J]"""
    impulses: Mapping[str, np.ndarray]
    """Of each contact, N first; zero but of impacts and accumulations."""
    before: np.ndarray
    """(q, v) before it, and after."""
    after: np.ndarray


class Told:
    """Events that a call of the library tells, motion by motion."""

    def __init__(self, mechanism: "Mechanism", motions: int, raised: list[BaseException]):
        self.events: list[list[ContactEvent]] = [[] for _ in range(motions)]
        self._mechanism, self._raised = mechanism, raised
        self.observer = _abi.ContactObserver(self._tell)

    def _tell(self, _: Any, event: Any) -> int:
        try:
            told = event.contents
            names = tuple(self._mechanism.contact_descriptions)
            regimes = {name: REGIMES[told.regimes[k]] for k, name in enumerate(names)}
            impulses, row = {}, 0
            for name, contact in self._mechanism.contact_descriptions.items():
                impulses[name] = np.array(told.impulses[row:row + contact.rows])
                row += contact.rows
            n = len(self._mechanism.coordinates) + len(self._mechanism.velocities)
            self.events[told.motion].append(
                ContactEvent(EVENT_KINDS[told.kind], told.time, names[told.contact], regimes, told.energy_lost, impulses,
                             np.array(told.before[:n]), np.array(told.after[:n])))
        except BaseException as error:  # nothing may be thrown through C: the motion ends
            self._raised.append(error)
        return 1 if self._raised else 0
