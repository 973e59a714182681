# SPDX-License-Identifier: MIT
"""Kernels as functions of numpy arrays."""

from __future__ import annotations

import ctypes
import math
import operator
from typing import Any, Callable, Mapping, NamedTuple, Sequence, Tuple

import numpy as np
from numpy.typing import ArrayLike

from . import _abi
from ._models import kernel_again

_ARGUMENTS = ("q", "v", "accelerations", "multipliers", "inputs")


class TorsorError(ArithmeticError):
    """A kernel cannot give the results of a state."""


class SingularError(TorsorError):
    """The mass matrix or the constraints of a state lose rank."""


class NotFiniteError(TorsorError):
    """A result is not a finite number."""


class Results(Tuple[np.ndarray, ...]):
    """Results of one call, by position and by name. Where the kernel can fail, ``ok`` has one bool for each state,
    ``statuses`` one number (0: ok, 1: singular, 2: not finite), and what failed is NaN."""

    _fields: tuple[str, ...] = ()
    ok: np.ndarray
    statuses: np.ndarray

    def __new__(cls, names: Sequence[str], values: Sequence[np.ndarray], statuses: np.ndarray) -> "Results":
        self = super().__new__(cls, values)  # type: ignore[arg-type]
        self._fields = tuple(names)
        self.statuses = statuses
        self.ok = statuses == 0
        return self

    def __getattr__(self, name: str) -> np.ndarray:
        try:
            return self[self.__dict__["_fields"].index(name)]
        except (KeyError, ValueError):
            raise AttributeError(f"no result {name!r}; there are {', '.join(self._fields)}") from None

    def __reduce__(self) -> tuple[Any, ...]:
        return Results, (self._fields, tuple(self), self.statuses)

    def _asdict(self) -> dict[str, np.ndarray]:
        return dict(zip(self._fields, self))

    def __repr__(self) -> str:
        return "Results(" + ", ".join(f"{name}={value!r}" for name, value in zip(self._fields, self)) + ")"

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._fields]


class Result(NamedTuple):
    """One result for one state: its shape is (), (rows,) or (rows, columns); columns 0: one for each order. ``unit`` is
    that of all its entries; where those of a vector differ, of each: "N, N m"; empty where those of a matrix differ."""

    name: str
    rows: int
    columns: int
    dimensions: int
    unit: str

    def shape(self, order: int) -> tuple[int, ...]:
        columns = order + 1 if self.columns == 0 else self.columns
        return (self.rows, columns)[:self.dimensions]


def as_columns(name: str, value: ArrayLike, size: int) -> np.ndarray:
    """``value`` as doubles with ``size`` numbers in its last dimension."""
    if isinstance(value, Mapping):
        raise TypeError(f"{name}: give an array of {size} numbers in the mechanism's order, not a {type(value).__name__}")
    if np.ma.is_masked(value):
        raise ValueError(f"{name}: masked values are no numbers; fill them, or leave their states out")
    array = np.asarray(value)
    if array.dtype != np.float64:
        array = array.astype(np.float64, casting="same_kind")
    if array.ndim == 0 or array.shape[-1] != size:
        raise ValueError(f"{name}: mismatch in its last dimension: shape {array.shape} is not (..., {size})")
    return array


def one_state(name: str, value: ArrayLike, size: int) -> np.ndarray:
    """As `as_columns`, of what takes a single state."""
    array = as_columns(name, value, size)
    if array.ndim != 1:
        raise ValueError(f"{name}: one state is asked for: shape {array.shape} is not ({size},)")
    return array


def note_copy(copied: list[tuple[np.ndarray, np.ndarray]], read: np.ndarray, given: Any) -> None:
    """Remembers that ``read`` holds the numbers of an array elsewhere."""
    if isinstance(given, np.ndarray) and not np.may_share_memory(read, given):
        copied.append((read, given))


def view_of(array: np.ndarray, batch: tuple[int, ...], tail: int,
            copied: list[tuple[np.ndarray, np.ndarray]] | None = None) -> tuple[_abi.View, np.ndarray]:
    """A view of an array whose last ``tail`` dimensions belong to a state, broadcast to a batch, and what keeps its
    numbers alive. A batch of several dimensions that no single step goes through is copied, and noted in ``copied``."""
    own = array.shape[array.ndim - tail:]
    wide = np.broadcast_to(array, batch + own)
    flat = wide if len(batch) == 1 else wide.reshape((math.prod(batch),) + own)
    if copied is not None and flat is not wide and not np.may_share_memory(flat, array):
        copied.append((flat.reshape(wide.shape), array))
    steps = flat.strides[1:] + (0, 0)
    return _abi.View(flat.ctypes.data, flat.strides[0], steps[0], steps[1]), flat


def thread_count(threads: int) -> int:
    number = operator.index(threads)
    if not 0 <= number < 2**31:
        raise ValueError(f"threads: {number} is no number of threads; 0 takes as many as there are cores")
    return number


def require_finite(arguments: Mapping[str, np.ndarray]) -> None:
    for name, array in arguments.items():
        if not np.isfinite(array).all():
            raise ValueError(f"{name}: array must not contain infs or NaNs")


class Bound:
    """A kernel with all its arrays: ``call()`` evaluates it for what they hold now, and returns ``call.result``, always
    the same arrays. For loops that cannot wait for anything else."""

    __slots__ = ("result", "statuses", "arguments", "_run", "_alive", "__weakref__")

    def __init__(self, run: Callable[..., Any], result: Any, statuses: np.ndarray, arguments: Mapping[str, np.ndarray],
                 alive: Any):
        self._run = run
        self.result = result
        self.statuses = statuses
        self.arguments = arguments
        self._alive = alive

    def __call__(self) -> Any:
        """`result`, for what the arrays hold now. Raises as the kernel itself does."""
        return self._run()


class Kernel:
    """One kernel of a mechanism; ``help(arm.mass_matrix)`` or ``arm.mass_matrix.__doc__`` say what it takes and gives."""

    def __init__(self, mechanism: Any, entry: _abi.KernelEntry):
        self._mechanism = mechanism
        self._evaluate = entry.evaluate
        self._address = ctypes.cast(entry.evaluate, ctypes.c_void_p).value
        self.__name__ = self.name = entry.name.decode()
        sizes = mechanism._sizes
        reads = {"accelerations": entry.reads_accelerations, "multipliers": entry.reads_multipliers,
                 "inputs": entry.reads_inputs}
        self.arguments: dict[str, int] = {name: sizes[name] for name in _ARGUMENTS if reads.get(name, True)}
        self.results = tuple(Result(r.name.decode(), r.rows, r.columns, r.dimensions, r.unit.decode())
                             for r in entry.results[:entry.result_count])
        self.has_status = bool(entry.has_status)
        self.takes_order = bool(entry.takes_order)
        self.__doc__ = self._documentation()

    def _documentation(self) -> str:
        m = self._mechanism
        units = {"q": m.coordinates, "v": m.velocities, "inputs": m.inputs, "multipliers": m.multipliers}
        optional = {"v": "zeros", "multipliers": "zeros", "inputs": "zeros"}
        words = [f"{name}=None" if name in optional else name for name in self.arguments]
        lines = [f"{self.name}({', '.join(words)}, *, time=0.0, {'order=12, ' if self.takes_order else ''}"
                 "parameters=None, out=None, threads=1)", "", f"Of {m.name}, for one state or many.", "", "Arguments:"]
        for name, size in self.arguments.items():
            quantities = units.get(name)
            what = "" if not quantities else ": " + ", ".join(f"{q} [{u}]" for q, u in quantities.items())
            default = f", {optional[name]} when absent" if name in optional else ""
            lines.append(f"    {name}: (..., {size}){default}{what}")
        lines += ["    time: (...) [s]", "", "Gives:"]
        for result in self.results:
            sizes = ["order + 1" if n == 0 and result.columns == 0 else str(n) for n in (result.rows, result.columns)]
            numbers = ", ".join(["...", *sizes[:result.dimensions]])
            lines.append(f"    {result.name}: ({numbers})" + (f" [{result.unit}]" if result.unit else ""))
        lines.append("Units are SI, angles in rad.")
        if self.has_status:
            lines += ["", "Raises SingularError or NotFiniteError for one state; of many, `ok` of the results tells those",
                      "that could be evaluated."]
        else:
            lines += ["", "Raises NotFiniteError for one state where a result is not a finite number; of many, what failed is NaN."]
        lines += ["", "Raises ValueError for shapes that do not fit and for numbers that are not finite."]
        return "\n".join(lines)

    def __reduce__(self) -> tuple[Any, ...]:
        return kernel_again, (self._mechanism, self.name)

    @property
    def unwrapped(self) -> bool:
        """Whether a call gives one array, and not `Results`."""
        return len(self.results) == 1 and not self.has_status

    def __repr__(self) -> str:
        return f"<kernel {self.name} of {self._mechanism.name}>"

    def __call__(self, q: ArrayLike, *arguments: ArrayLike | None, out: Any = None, threads: int = 1, time: ArrayLike = 0.0,
                 order: int | None = None, parameters: Mapping[str, float] | None = None, **named: ArrayLike) -> Any:
        """The results for these arguments, by position or by name; ``__doc__`` of each kernel has shapes and units.

        time: (...) [s]. order: the highest, of Taylor coefficients, 12 when absent.
        parameters: of those set at run time, by name.
        out: arrays to write to, one, a sequence or a mapping. threads: for many states; 0: as many as there are cores.
        """
        bound = self._bind(q, arguments, named, time, order, parameters, out, threads)  # holds what is read
        return bound._run(False)

    def bind(self, q: ArrayLike, *arguments: ArrayLike | None, out: Any = None, threads: int = 1, time: ArrayLike = 0.0,
             order: int | None = None, parameters: Mapping[str, float] | None = None, **named: ArrayLike) -> Bound:
        """The call with these arguments, to be made again and again for what the arrays hold then. Arrays of doubles are
        read where they are; those of other types, and those that no single step goes through, are copied at each call.
        Lists and numbers are read once."""
        return self._bind(q, arguments, named, time, order, parameters, out, threads)

    def _given(self, q: ArrayLike, arguments: Sequence[ArrayLike | None], named: Mapping[str, ArrayLike]) -> dict[str, Any]:
        names = list(self.arguments)
        if len(arguments) + 1 > len(names):
            raise TypeError(f"{self.name}() takes {len(names)} arguments ({', '.join(names)}) and got {len(arguments) + 1}")
        given: dict[str, Any] = dict(zip(names, (q, *arguments)))
        for name, value in named.items():
            if name not in self.arguments:
                raise TypeError(f"{self.name}() got an unexpected keyword argument {name!r}; it takes {', '.join(names)}")
            if given.get(name) is not None:
                raise TypeError(f"{self.name}() got multiple values for argument {name!r}")
            given[name] = value
        for name in ("q", "accelerations"):
            if name in self.arguments and given.get(name) is None:
                raise TypeError(f"{self.name}() missing 1 required argument: {name!r}")
        return given

    def _outputs(self, out: Any, batch: tuple[int, ...], order: int) -> list[np.ndarray]:
        shapes = [batch + r.shape(order) for r in self.results]
        if out is None:
            return [np.empty(shape) for shape in shapes]
        if isinstance(out, np.ndarray):
            out = (out,)
        elif isinstance(out, Mapping):
            names = [r.name for r in self.results]
            for name in out:
                if name not in names:
                    raise ValueError(f"out: {self.name} has no result {name!r}; there are {', '.join(names)}")
            out = tuple(out.get(name) for name in names)
        if len(out) != len(shapes):
            raise ValueError(f"out: {self.name} has {len(shapes)} results and got {len(out)} arrays")
        arrays = []
        for given, shape, result in zip(out, shapes, self.results):
            if given is None:
                given = np.empty(shape)
            if not isinstance(given, np.ndarray):
                raise TypeError("return arrays must be of ArrayType")
            if given.dtype != np.float64 or not given.dtype.isnative:
                raise TypeError(f"out: cannot cast {result.name} from dtype('float64') to {given.dtype!r}")
            if given.shape != shape:
                raise ValueError(f"non-broadcastable output operand with shape {given.shape} doesn't match the broadcast "
                                 f"shape {shape} of {result.name}")
            if not given.flags.writeable:
                raise ValueError("output array is read-only")
            arrays.append(given)
        return arrays

    def _bind(self, q: ArrayLike, positional: Sequence[ArrayLike | None], named: Mapping[str, ArrayLike], time: ArrayLike,
              order: int | None, parameters: Mapping[str, float] | None, out: Any, threads: int) -> Bound:
        m = self._mechanism
        if order is not None and not self.takes_order:
            raise ValueError(f"order: {self.name} has none, only Taylor coefficients do; leave it out")
        order = 12 if order is None else order
        given = self._given(q, positional, named)
        arrays: dict[str, np.ndarray] = {}
        copied: list[tuple[np.ndarray, np.ndarray]] = []  # what is read instead of what was given
        for name, size in self.arguments.items():
            value = given.get(name)
            if value is not None:
                arrays[name] = as_columns(name, value, size)
                note_copy(copied, arrays[name], value)
            elif name == "v":
                arrays[name] = np.zeros(size)
        times = np.asarray(time)
        if times.dtype != np.float64:
            times = times.astype(np.float64, casting="same_kind")
        note_copy(copied, times, time)
        batch = np.broadcast_shapes(times.shape, *(array.shape[:-1] for array in arrays.values()))
        count = int(np.prod(batch)) if batch else 1
        outputs = self._outputs(out, batch, order)
        if out is not None:  # a result may lie where an argument is read only if it is the argument
            for name, array in arrays.items():
                if any(np.may_share_memory(array, each) for each in outputs):
                    arrays[name] = array.copy()
                    copied.append((arrays[name], array))
        statuses = np.zeros(batch, dtype=np.int32)

        alive: list[Any] = [statuses]
        call = _abi.Call()
        model = m._model(parameters)
        alive.append(model)
        call.model = model.address
        call.states = count
        call.threads = thread_count(threads)
        call.order = order
        for name, array in arrays.items():
            view, flat = view_of(array, batch or (1,), 1, copied)
            setattr(call, name, view)
            alive.append(flat)
        if isinstance(time, np.ndarray) or times.ndim > 0 or times != 0.0:
            view, flat = view_of(times[..., None], batch or (1,), 1, copied)
            call.time = view
            alive.append(flat)
        views = (_abi.View * max(1, len(outputs)))()
        scattered: list[tuple[np.ndarray, np.ndarray]] = []
        for k, array in enumerate(outputs):
            flat = array.reshape((count,) + array.shape[len(batch):])
            if array.size > 0 and not np.may_share_memory(flat, array):  # gaps that no single step crosses
                flat = np.empty(flat.shape)
                scattered.append((array, flat))
            steps = flat.strides[1:] + (0, 0)
            views[k] = _abi.View(flat.ctypes.data if flat.size else None, flat.strides[0], steps[0], steps[1])
            alive.append(flat)
        call.results = views
        call.statuses = statuses.ctypes.data
        alive += [call, views, arrays, times, outputs]

        results: Any
        if self.unwrapped:
            results = outputs[0]
        else:
            results = Results([r.name for r in self.results], outputs, statuses)
        evaluate, pointer = self._evaluate, ctypes.addressof(call)

        def complain(failed: int) -> None:
            if failed < 0:
                raise {-3: MemoryError}.get(failed, ValueError)(
                    {-4: f"order: {order} is not among 1, ..., 30"}.get(failed, f"call of {self.name} failed: {failed}"))
            if call.worst == 3:
                require_finite({**arrays, "time": times})
            if not batch:
                error = {1: SingularError, 2: NotFiniteError}[call.worst]
                raise error(f"{self.name}: " + ("the state is singular: the mass matrix or the constraints lose rank"
                                                if call.worst == 1 else "a result is not a finite number"))
            bad = statuses != 0
            for each in outputs:
                each[bad] = np.nan
            if not self.unwrapped:
                results.ok = ~bad

        def run(again: bool = True) -> Any:
            if again:
                for into, array in copied:
                    into[...] = array
            failed = evaluate(pointer)
            for array, flat in scattered:
                array[...] = flat.reshape(array.shape)
            if failed:
                complain(failed)
            elif not self.unwrapped and not results.ok.all():
                results.ok = statuses == 0
            return results

        return Bound(run, results, statuses, arrays, alive)
