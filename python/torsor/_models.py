# SPDX-License-Identifier: MIT
"""Parameters of a mechanism with what depends on them, and pickling of what holds addresses of a library."""

from __future__ import annotations

import ctypes
import threading
from collections import OrderedDict
from typing import TYPE_CHECKING, Any, Mapping

import numpy as np

if TYPE_CHECKING:
    from ._kernel import Kernel
    from ._mechanism import Mechanism


class Model:
    """Parameters with what depends on them; freed with its last user."""

    def __init__(self, mechanism: Mechanism, parameters: np.ndarray):
        table = mechanism._table
        self._destroy, self._library = table.destroy, mechanism._library
        self.address = table.create(parameters.ctypes.data_as(ctypes.POINTER(ctypes.c_double)))
        if not self.address:
            raise MemoryError("no memory for the parameters of a mechanism")
        knows = table.size >= ctypes.sizeof(table)  # libraries of before do not
        fault = table.impossible(self.address) if knows else None
        if fault is not None:
            usual = table.default_parameters[:table.parameter_count]
            given = [f"{name}={value:g}" for name, value, default in zip(mechanism.parameter_units, parameters, usual)
                     if value != default and value == value]
            because = f"; that is so with {', '.join(given)}: give another value" if given else ""
            raise ValueError(f"{mechanism.name}: {fault.decode()}{because}")

    def __del__(self) -> None:
        if getattr(self, "address", None):
            self._destroy(self.address)


class Models:
    """Those used last, by their parameters. Threads may ask at once: one that is used outlives its place here."""

    LIMIT = 64

    def __init__(self) -> None:
        self._models: OrderedDict[tuple[float, ...], Model] = OrderedDict()
        self._lock = threading.Lock()

    def get(self, mechanism: Mechanism, parameters: Mapping[str, float]) -> Model:
        key = tuple(parameters.values())
        with self._lock:
            model = self._models.get(key)
            if model is None:
                model = self._models[key] = Model(mechanism, np.array(key if key else (0.0,)))
            self._models.move_to_end(key)
            if len(self._models) > self.LIMIT:
                self._models.popitem(last=False)
            return model


def opened_again(kind: type[Mechanism], path: str, source: Any, fingerprint: int, parameters: dict[str, float]) -> Mechanism:
    """What a pickled mechanism becomes: its library is opened where it was, and must still be that mechanism's."""
    mechanism = kind(path, source)
    if mechanism.fingerprint != fingerprint:
        raise OSError(f"{path} holds another mechanism now than the one that was pickled: load it again")
    changed = {name: value for name, value in parameters.items()
               if value != mechanism.parameters[name] and value == value}  # one without a value is no number here as there
    return mechanism.with_parameters(**changed) if changed else mechanism


def kernel_again(mechanism: Mechanism, name: str) -> Kernel:
    return mechanism.kernels[name]
