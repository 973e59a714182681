# SPDX-License-Identifier: MIT
"""Equations of motion of mechanisms, as fast as they are in C++, on numpy arrays.

>>> arm = torsor.load("arm.urdf")
>>> forces = arm.inverse_dynamics(q, v, a)          # (n,) or (..., n), broadcast
>>> motion = arm.simulate(10.0, q)                  # times, states, energy

The interface is that of runtime/abi.h: `torsor.open` takes any library made by `torsor build`.
"""

from __future__ import annotations

import os
from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._contacts import Contact, ContactEvent
    from ._kernel import Bound, Kernel, NotFiniteError, Results, SingularError, TorsorError
    from ._load import LoadError, load
    from ._mechanism import Equilibrium, Mechanism, Modes, State
    from ._motion import Motion
    from ._task_inertia import TaskInertia

__version__ = "0.1.0"

__all__ = ["Bound", "Contact", "ContactEvent", "Equilibrium", "Kernel", "LoadError", "Mechanism", "Modes", "Motion",
           "NotFiniteError", "Results", "SingularError", "State", "TaskInertia", "TorsorError",
           "load", "open"]

_HOMES = {name: home for home, names in {
    "_contacts": ("Contact", "ContactEvent"),
    "_kernel": ("Bound", "Kernel", "NotFiniteError", "Results", "SingularError", "TorsorError"),
    "_load": ("LoadError", "load"),
    "_mechanism": ("Equilibrium", "Mechanism", "Modes", "State"),
    "_motion": ("Motion",),
    "_task_inertia": ("TaskInertia",)}.items() for name in names}


def _home(name: str) -> Any:
    try:
        return import_module(f".{name}", __name__)
    except ModuleNotFoundError as missing:
        if missing.name != "numpy":
            raise
        raise ModuleNotFoundError("torsor works on arrays of numpy, which this Python lacks: install it "
                                  "(Debian: python3-numpy, for /usr/bin/python3)", name="numpy") from None


def __getattr__(name: str) -> Any:
    """Imported when it is asked for: `torsor.scene` needs no numpy."""
    if name not in _HOMES:
        raise AttributeError(f"module 'torsor' has no attribute '{name}'")
    globals()[name] = value = getattr(_home(_HOMES[name]), name)
    return value


def __dir__() -> list[str]:
    return sorted(set(globals()) | set(__all__))


def open(path: str | os.PathLike[str]) -> Mechanism:  # noqa: A001 - torsor.open("libarm.so")
    """The mechanism of a library made by `torsor build` or `torsor_add_mechanism(... SHARED)`.

    Raises OSError where the file is no such library, or has another version of the interface."""
    mechanism: Mechanism = _home("_mechanism").Mechanism(path)
    return mechanism
