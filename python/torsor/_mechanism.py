# SPDX-License-Identifier: MIT
"""A mechanism: its kernels, its motions, and what is asked of its linearisation."""

from __future__ import annotations

import ctypes
import os
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Callable, Mapping, NamedTuple, Sequence

import numpy as np
from numpy.typing import ArrayLike

from . import _abi
from ._contacts import IMPACT_LAWS, Contact, ContactEvent, Told
from ._display import Displayed
from ._kernel import (Kernel, NotFiniteError, Results, SingularError, TorsorError, as_columns, one_state, require_finite,
                      thread_count, view_of)
from ._models import Model, Models, opened_again
from ._motion import MOTION_STATUSES, Motion
from ._task_inertia import TaskInertia, task_inertia


class State(NamedTuple):
    """Time [s], coordinates and velocities."""

    time: float
    q: np.ndarray
    v: np.ndarray


class Modes(NamedTuple):
    """Small motions x' = A x about a state: exp(eigenvalue t) times a column of ``shapes``."""

    eigenvalues: np.ndarray
    frequencies: np.ndarray
    """|eigenvalue| [rad/s]."""
    damping: np.ndarray
    """-Re(eigenvalue)/|eigenvalue|; 1 for eigenvalues that are zero."""
    shapes: np.ndarray


class Equilibrium(NamedTuple):
    """A rest: coordinates (nq,), multipliers of constraints (nm,)."""

    q: np.ndarray
    multipliers: np.ndarray
    residual: float
    """Largest generalised force that is left [N, N m]."""


def _quantities(entries: Any, count: int) -> Mapping[str, str]:
    return MappingProxyType({e.name.decode(): e.unit.decode() for e in entries[:count]})


class Mechanism(Displayed):
    """A mechanism from a shared library. Its kernels are its attributes: ``arm.inverse_dynamics(q, v, a)``.

    ``coordinates``, ``velocities``, ``inputs``, ``multipliers`` give names with units; ``parameters`` names with values;
    ``contact_descriptions`` the contacts that `simulate` moves it by from event to event. Kernels are those of the mechanism
    with its contacts open, and so is `ode`.
    """

    if TYPE_CHECKING:
        kinematics: Kernel
        mass_matrix: Kernel
        bias: Kernel
        inverse_dynamics: Kernel
        forward_dynamics: Kernel
        energy: Kernel
        first_integrals: Kernel
        constraints: Kernel
        reactions: Kernel
        contacts: Kernel
        contact_coefficients: Kernel
        delassus: Kernel
        impact: Kernel
        linearisation: Kernel
        inverse_dynamics_derivatives: Kernel
        forward_dynamics_derivatives: Kernel
        regressor: Kernel
        jets: Kernel
        sparse_constraint_jacobian: Kernel
        residual: Kernel
        residual_jacobian: Kernel
        inverse_dynamics_second_derivatives: Kernel
        forward_dynamics_second_derivatives: Kernel
        inverse_dynamics_sensitivities: Kernel
        forward_dynamics_sensitivities: Kernel
        gravity: Kernel
        centroidal_momentum: Kernel
        frames: Kernel
        operational_inertia: Kernel
        poses: Kernel
        coordinate_rates: Kernel
        state_derivative: Kernel

    def __init__(self, path: str | os.PathLike[str], source: Any = None):
        self._library, table = _abi.open_library(os.fspath(path))
        self._table = table
        self._source = source
        self.path = os.path.abspath(os.fspath(path))
        self.name: str = table.name.decode()
        self.fingerprint: int = table.fingerprint
        self.coordinates = _quantities(table.coordinates, table.coordinate_count)
        self.velocities = _quantities(table.velocities, table.velocity_count)
        self.inputs = _quantities(table.inputs, table.input_count)
        self.multipliers = _quantities(table.multipliers, table.multiplier_count)
        self.parameter_units = _quantities(table.parameters, table.parameter_count)
        self.contact_descriptions: Mapping[str, Contact] = MappingProxyType(
            {c.name.decode(): Contact(c.gap_unit.decode(), c.reaction_unit.decode(), c.normal + c.tangents)
             for c in table.contacts[:table.contact_count]})
        self.quaternions = tuple(table.quaternions[:table.quaternion_count])
        self._sizes = {"q": table.coordinate_count, "v": table.velocity_count, "accelerations": table.velocity_count,
                       "multipliers": table.multiplier_count, "inputs": table.input_count}
        self.parameters: Mapping[str, float] = MappingProxyType(
            dict(zip(self.parameter_units, table.default_parameters[:table.parameter_count])))
        self._models = Models()
        self.methods = tuple(method.name.decode() for method in table.methods[:table.method_count])
        self._fixed_step = {method.name.decode() for method in table.methods[:table.method_count] if method.fixed_step}
        self.kernels: Mapping[str, Kernel] = MappingProxyType(
            {entry.name.decode(): Kernel(self, entry) for entry in table.kernels[:table.kernel_count]})
        self._own = self._models.get(self, self.parameters)

    def __getattr__(self, name: str) -> Kernel:
        kernels = self.__dict__.get("kernels", {})
        if name in kernels:
            self.__dict__[name] = kernels[name]
            return kernels[name]
        raise AttributeError(f"{self.__dict__.get('name', 'the mechanism')} has no kernel or attribute {name!r}; its kernels "
                             f"are {', '.join(kernels)}. Some are made by name only: load(..., kernels='all,gravity')")

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.kernels]

    def __repr__(self) -> str:
        return f"<torsor.Mechanism {self.name}: {len(self.coordinates)} coordinates, kernels {', '.join(self.kernels)}>"

    # Parameters

    def with_parameters(self, **values: float) -> "Mechanism":
        """The same mechanism with other run-time parameters as those that calls take by default."""
        other = object.__new__(Mechanism)
        other.__dict__.update({k: v for k, v in self.__dict__.items() if k != "_own" and not isinstance(v, Kernel)})
        other._models = Models()
        other.parameters = MappingProxyType(self._merged(values))
        other.kernels = MappingProxyType(
            {entry.name.decode(): Kernel(other, entry) for entry in self._table.kernels[:self._table.kernel_count]})
        other._own = other._models.get(other, other.parameters)
        return other

    def _merged(self, values: Mapping[str, float] | None) -> dict[str, float]:
        merged = dict(self.parameters)
        if values is not None and not hasattr(values, "items"):
            raise TypeError(f"parameters: give a mapping of names to numbers, not a {type(values).__name__}")
        for name, value in (values or {}).items():
            if name not in merged:
                raise KeyError(f"{self.name} has no run-time parameter {name!r}; there are "
                               f"{', '.join(merged) or 'none: name them when it is built, run_time='}")
            number = np.asarray(value).astype(np.float64, casting="same_kind")
            if number.ndim != 0:
                raise ValueError(f"parameter {name}: only a number, not an array of shape {number.shape}")
            if not np.isfinite(number):
                raise ValueError(f"parameter {name}: array must not contain infs or NaNs")
            merged[name] = float(number)
        return merged

    def _model(self, parameters: Mapping[str, float] | None) -> Model:
        """What calls read; `_own` of the mechanism's own parameters."""
        values = self.parameters if parameters is None else self._merged(parameters)
        for name, value in values.items():
            if value != value:
                raise ValueError(f"{self.name}: the parameter {name!r} has no value: give it, as parameters={{{name!r}: ...}} of "
                                 f"this call, or to a mechanism with it, with_parameters({name}=...)")
        return self._own if parameters is None else self._models.get(self, values)

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickled as the path of its library, with its parameters; a scene in Python stays behind."""
        source = None if hasattr(self._source, "equations") else self._source
        return opened_again, (type(self), self.path, source, self.fingerprint, dict(self.parameters))

    # States and motions

    def initial_state(self, parameters: Mapping[str, float] | None = None) -> State:
        """The state in which the scene starts: time, q (nq,), v (nv,)."""
        model = self._model(parameters)
        time, q, v = np.zeros(1), np.zeros(self._sizes["q"]), np.zeros(self._sizes["v"])
        pointers = [a.ctypes.data_as(ctypes.POINTER(ctypes.c_double)) for a in (time, q, v)]
        self._table.initial_state(model.address, *pointers)
        return State(float(time[0]), q, v)

    def _closed_start(self, parameters: Mapping[str, float] | None) -> State:
        """`initial_state`, put on its constraints, which parameters may have left: where `simulate` starts."""
        start = self.initial_state(parameters)
        if not self.multipliers or self.contact_descriptions or any(k not in self.kernels for k in self._kernels_of_motion()):
            return start
        motion = self.simulate([start.time], parameters=parameters)
        return State(start.time, motion.q[0], motion.v[0])

    def ode(self, inputs: ArrayLike | Callable[[float, np.ndarray, np.ndarray], ArrayLike] | None = None,
            parameters: Mapping[str, float] | None = None) -> Callable[[float, np.ndarray], np.ndarray]:
        """The right side f(t, y) of y' = f, y = (q, v) of shape (n,) or (n, states), as `scipy.integrate.solve_ivp` asks
        for it (``vectorized=True`` is allowed). `inputs`: (inputs,), or a function of t, q, v."""
        nq = self._sizes["q"]

        def f(t: float, y: np.ndarray) -> np.ndarray:
            rows = np.asarray(y).T
            q, v = rows[..., :nq], rows[..., nq:]
            u = inputs(t, q, v) if callable(inputs) else inputs
            return self.state_derivative(q, v, u, time=t, parameters=parameters)[0].T

        return f

    def simulate(self, times: ArrayLike = 10.0, q: ArrayLike | None = None, v: ArrayLike | None = None, *,
                 start_time: ArrayLike | None = None,
                 inputs: ArrayLike | Callable[[float, np.ndarray, np.ndarray], ArrayLike] | None = None,
                 method: str = "dormand_prince_853", relative_tolerance: float = 1e-9, absolute_tolerance: float = 1e-12,
                 step: float | None = None, first_step: float = 0.0, largest_step: float = 0.0, step_limit: int = 0,
                 project: bool = True, impact_law: str = "newton_moreau",
                 parameters: Mapping[str, float] | None = None, threads: int = 1) -> Motion:
        """Integrates motions from (q, v) at `start_time`; what is absent is that of the scene. Constraints are held.
        With contacts it goes from event to event, forward in time, and `events` of the result tells of each.
        `project=False` leaves constraints without contacts to drift.

        times: (T,) [s], in one direction; a number: 1,001 equal times up to it.
        q, v: (nq,), (nv,), or (..., nq), (..., nv): as many motions, on `threads` threads.
        inputs: (..., inputs), constant along a motion; or a function of t, q (nq,), v (nv,).
        method: one of `methods`; `step` is for those with a fixed step, tolerances for the others.
        impact_law: of contacts; "newton_moreau", "poisson", "energetic" (of one contact) or "sequential".

        One motion that fails raises TorsorError; of many, `ok` tells those that reached the end.
        """
        scene = self.initial_state(parameters)
        begin = np.asarray(scene.time if start_time is None else start_time).astype(np.float64, casting="same_kind")
        grid = np.asarray(times).astype(np.float64, casting="same_kind")
        if grid.ndim == 0:
            if begin.ndim != 0:
                raise ValueError("times: give an array where motions start at several times")
            require_finite({"times": grid})
            grid = np.linspace(float(begin), float(grid), 1001)
        if grid.ndim != 1:
            raise ValueError(f"times: shape {grid.shape} is not (T,)")
        grid = np.ascontiguousarray(grid)
        if self.contact_descriptions and len(grid) > 0 and (np.any(np.diff(grid) < 0) or np.any(grid[0] < begin)):
            raise ValueError("times: with contacts a motion goes forward in time; give times that do not decrease, none before "
                             "start_time")
        if not self.methods:
            raise ValueError(f"{self.name} cannot be integrated: it lacks kernels; build it with "
                             f"{', '.join(self._kernels_of_motion())}")
        if self.contact_descriptions and not project:
            raise ValueError("project: False does nothing with contacts, whose gaps and loops are always held; leave it out")
        missing = [] if self.contact_descriptions else [k for k in self._kernels_of_motion() if k not in self.kernels]
        if project and missing:
            raise ValueError(f"{self.name}: its constraints are held by kernels that it lacks: build it with "
                             f"{', '.join(missing)}, or give project=False, and they drift")
        if impact_law not in IMPACT_LAWS:
            raise ValueError(f"no impact law {impact_law!r}; there are {', '.join(IMPACT_LAWS)}")
        if method not in self.methods:
            raise ValueError(f"no method {method!r}; there are {', '.join(self.methods)}")
        if method in self._fixed_step and step is None:
            raise ValueError(f"{method} has a fixed step: give step=")
        if method not in self._fixed_step and step is not None:
            raise ValueError(f"step: {method} chooses its own steps; leave it out, or give largest_step= or one of the methods "
                             f"with a fixed step: {', '.join(m for m in self.methods if m in self._fixed_step)}")
        start = {"q": as_columns("q", scene.q if q is None else q, self._sizes["q"]),
                 "v": as_columns("v", scene.v if v is None else v, self._sizes["v"])}
        law = None if inputs is None or callable(inputs) else as_columns("inputs", inputs, self._sizes["inputs"])
        require_finite({**start, "times": grid, "start_time": begin, **({} if law is None else {"inputs": law})})
        batch = np.broadcast_shapes(begin.shape, *(a.shape[:-1] for a in start.values()),
                                    () if law is None else law.shape[:-1])
        count = int(np.prod(batch)) if batch else 1
        y = np.ascontiguousarray(np.concatenate(
            [np.broadcast_to(a, batch + a.shape[-1:]) for a in start.values()], axis=-1))
        n = y.shape[-1]
        y = y.reshape(count, n)
        states = np.empty((count, len(grid), n))
        statuses, calls = np.zeros(count, dtype=np.int32), np.zeros(count, dtype=np.int64)

        whole, model = _abi.ContactMotion(), self._model(parameters)
        motion = whole.motion  # the same bytes
        motion.model, motion.motions, motion.threads = model.address, count, thread_count(threads)
        motion.method, motion.unprojected = self.methods.index(method), 0 if project else 1
        motion.step = 0.0 if step is None else step
        motion.relative_tolerance, motion.absolute_tolerance = relative_tolerance, absolute_tolerance
        motion.first_step, motion.largest_step, motion.step_limit = first_step, largest_step, step_limit
        alive: list[Any] = []
        motion.time, kept = view_of(begin[..., None], batch or (1,), 1)
        alive.append(kept)
        motion.start = _abi.View(y.ctypes.data, y.strides[0], y.strides[1], 0)
        if law is not None:
            motion.inputs, kept = view_of(law, batch or (1,), 1)
            alive.append(kept)
        raised: list[BaseException] = []
        odd: list[float] = []
        if callable(inputs):
            motion.law = self._law(inputs, raised, odd)
            alive.append(motion.law)
        motion.times, motion.time_count = grid.ctypes.data, len(grid)
        motion.states = _abi.View(states.ctypes.data, *states.strides)
        motion.statuses, motion.calls = statuses.ctypes.data, calls.ctypes.data
        names = tuple(self.contact_descriptions)
        told = Told(self, count, raised)
        regimes, ended = np.empty((count, len(grid), len(names)), dtype=np.int32), np.full(count, -1, dtype=np.int32)
        if names:
            whole.impact_law, whole.observer = IMPACT_LAWS.index(impact_law), told.observer
            whole.regimes, whole.contacts = regimes.ctypes.data, ended.ctypes.data
            failed = self._table.integrate_contacts(ctypes.addressof(whole))
        else:
            failed = self._table.integrate(ctypes.addressof(motion))
        if raised:
            raise raised[0]
        if failed < 0:
            raise TorsorError(f"{self.name}: the library refuses the call: {failed}")
        if not batch and failed:
            at = f"; contact {names[ended[0]]}" if ended[0] >= 0 else ""
            at += f"; inputs at t = {odd[0]:.6g} s are no finite numbers" if odd else ""
            raise TorsorError(f"{self.name}: the motion ends early: {MOTION_STATUSES[statuses[0]]}{at}")
        result = self._motion(grid, states.reshape(batch + states.shape[1:]), statuses.reshape(batch),
                              calls.reshape(batch), parameters)
        if not names:
            return result
        return result._replace(events=self._events(told, batch), regimes=regimes.reshape(batch + regimes.shape[1:]))

    def _kernels_of_motion(self) -> list[str]:
        constraints = ["constraints"] if self.multipliers else []
        if not self.contact_descriptions:
            return ["forward_dynamics", *(["mass_matrix"] if constraints else []), *constraints]
        return ["mass_matrix", "bias", "contacts", "contact_coefficients", *constraints,
                *(["forward_dynamics"] if self.inputs else [])]

    @staticmethod
    def _events(told: Told, batch: tuple[int, ...]) -> Any:
        if not batch:
            return tuple(told.events[0])
        events = np.empty(len(told.events), dtype=object)
        for k, each in enumerate(told.events):
            events[k] = tuple(each)
        return events.reshape(batch)

    def _motion(self, grid: np.ndarray, states: np.ndarray, statuses: np.ndarray, calls: np.ndarray,
                parameters: Mapping[str, float] | None) -> Motion:
        nq = self._sizes["q"]
        q, v = states[..., :nq], states[..., nq:]
        energy = None
        if "energy" in self.kernels:
            reached = np.isfinite(states).all(axis=-1)
            energy = np.full(reached.shape, np.nan)
            at = np.broadcast_to(grid, reached.shape)[reached]
            if len(at):
                parts = self.energy(q[reached], v[reached], time=at, parameters=parameters)
                energy[reached] = parts.kinetic - parts.force_function
        if statuses.ndim == 0:
            return Motion(grid, q, v, energy, True, int(statuses), int(calls))
        return Motion(grid, q, v, energy, statuses == 0, statuses, calls)

    def _law(self, inputs: Callable[[float, np.ndarray, np.ndarray], ArrayLike], raised: list[BaseException],
             odd: list[float]) -> Any:
        nq, n, m = self._sizes["q"], self._sizes["q"] + self._sizes["v"], self._sizes["inputs"]

        def law(_: Any, time: float, y: Any, result: Any) -> None:
            into = np.ctypeslib.as_array(result, (m,)) if m else np.empty(0)
            try:
                if raised:
                    raise raised[0]
                state = np.ctypeslib.as_array(y, (n,)).copy()
                into[...] = as_columns("inputs", inputs(time, state[:nq], state[nq:]), m)
                if not odd and not np.isfinite(into).all():
                    odd.append(time)
            except BaseException as error:  # nothing may be thrown through C: the motion ends by what is no number
                raised.append(error)
                into[...] = np.nan

        return _abi.InputLaw(law)

    # About one state

    def linearise(self, q: ArrayLike | None = None, v: ArrayLike | None = None, *, accelerations: ArrayLike | None = None,
                  inputs: ArrayLike | None = None, time: float | None = None,
                  parameters: Mapping[str, float] | None = None) -> Results:
        """M e'' + C e' + K e = F + E du about a state and its own motion (or given accelerations), and where there are,
        x' = A x + B du with x = (e, e'). What is absent is the start of the motion (on its constraints); without
        accelerations, those of the motion with these inputs. Along an attitude e is a turn in its moving axes, e' and e''
        stand for w and w', and w = de/dt + omega x e: A says so. Matrices as `linearisation.__doc__` says."""
        scene = self._closed_start(parameters) if q is None else self.initial_state(parameters)
        q = scene.q if q is None else q
        v = scene.v if v is None else v
        at = scene.time if time is None else time
        multipliers = None
        if accelerations is None:
            solved = self.forward_dynamics(q, v, inputs, time=at, parameters=parameters)
            accelerations, multipliers = solved[0], solved[1]
        given: dict[str, Any] = {"accelerations": accelerations, "multipliers": multipliers, "inputs": inputs}
        return self.linearisation(q, v, time=at, parameters=parameters,
                                  **{k: a for k, a in given.items() if k in self.linearisation.arguments and a is not None})

    def task_inertia(self, point: str, q: ArrayLike, *, rows: str | Sequence[int] = "all", axes: ArrayLike | None = None,
                     pseudo_inverse: bool = False, length: float = 1.0, tolerance: float | None = None,
                     **options: Any) -> TaskInertia:
        """The inertia in operational space of a task at a named point: force F along its rows changes its velocities by
        dv/dt = inertia^-1 F. Of the kernel `operational_inertia`, whose options follow (`v`, `time`, `parameters`, `threads`).

        rows: "all", "translation", "rotation", or numbers from 0 (x), 1, 2, 3 (about x), 4, 5. Other rows are free.
        axes: (..., 3, 3), the axes of rows in the ground's, in columns: those of the ground, or `frames(q, v).POINT_rotation`.
        length: usual length of the mechanism [m], `tolerance` of eigenvalues: what is rounding; see docs/kernels.md.

        Where the arm cannot move the task in some direction, one state raises SingularError; of many, `ok` is False there and
        the inertia NaN. With `pseudo_inverse` it is the pseudo-inverse instead, which asks for no force there."""
        every = self.operational_inertia(q, **options)
        name = point + "_inverse_inertia"
        if name not in every._fields:
            points = ", ".join(field.removesuffix("_inverse_inertia") for field in every._fields)
            raise KeyError(f"{self.name} has no named point {point!r}; there are {points}")
        task = task_inertia(getattr(every, name), rows, axes, length, tolerance)
        if task.ok.all() or pseudo_inverse:
            return task
        if task.ok.ndim == 0:
            raise SingularError(f"{self.name}: {point} moves in {int(task.rank)} independent ways, and the task has "
                                f"{task.inertia.shape[-1]} rows: take fewer, or pseudo_inverse=True")
        return task._replace(inertia=np.where(task.ok[..., None, None], task.inertia, np.nan))

    def modes(self, q: ArrayLike | None = None, v: ArrayLike | None = None, **options: Any) -> Modes:
        """Eigenvalues of the state matrix A of `linearise` at one state, slowest first. v is zero when absent."""
        at = None if q is None else one_state("q", q, self._sizes["q"])
        zeros = np.zeros(self._sizes["v"]) if v is None else one_state("v", v, self._sizes["v"])
        matrix = self.linearise(at, zeros, **options).A
        values, shapes = np.linalg.eig(matrix)
        order = np.lexsort((values.imag, np.abs(values)))
        values, shapes = values[order], shapes[:, order]
        size = np.abs(values)
        with np.errstate(invalid="ignore", divide="ignore"):
            damping = np.where(size > 0, -values.real / size, 1.0)
        return Modes(values, size, damping, shapes)

    def equilibria(self, q: ArrayLike | None = None, *, inputs: ArrayLike | None = None, time: float | None = None,
                   tolerance: float = 1e-12, steps: int = 50, parameters: Mapping[str, float] | None = None) -> Equilibrium:
        """The equilibrium that Newton's method finds from q (the scene's start when absent): no velocity, no acceleration,
        no generalised force left above `tolerance` of the largest stiffness, or of 1 in SI units. Raises TorsorError where
        it finds none. Constraints are met, with their multipliers."""
        scene = self.initial_state(parameters)
        at = scene.time if time is None else time
        q = one_state("q", scene.q if q is None else q, self._sizes["q"]).copy()
        nv, nm = self._sizes["v"], self._sizes["multipliers"]
        rest, multipliers = np.zeros(nv), np.zeros(nm)
        common: dict[str, Any] = {"time": at, "parameters": parameters}
        for _ in range(steps):
            arguments: dict[str, Any] = {"accelerations": rest, "multipliers": multipliers, "inputs": inputs}
            linear = self.linearisation(q, rest, **common, **{k: a for k, a in arguments.items()
                                                              if k in self.linearisation.arguments and a is not None})
            matrix, right = linear.K, linear.F
            if nm:
                of = self.constraints(q, rest, **common)
                jacobian = of.jacobian.reshape(nm, nv)
                matrix = np.block([[matrix, -jacobian.T], [jacobian, np.zeros((nm, nm))]])
                right = np.concatenate([right, -of.value.reshape(nm)])
            size = max(1.0, float(np.abs(matrix).max())) if matrix.size else 1.0
            change = np.linalg.lstsq(matrix, right, rcond=1e-12)[0]
            left = float(np.abs(right).max()) if right.size else 0.0
            if left <= tolerance * size and np.abs(change).max() <= 1e-9 * (1.0 + np.abs(q).max()):
                return Equilibrium(q, multipliers, left)
            longest = np.abs(change[:nv]).max()
            share = min(1.0, 0.5 / longest) if longest > 0 else 1.0  # of a turn or a metre: Newton's method from afar
            q, multipliers = self._displaced(q, share * change[:nv]), multipliers + change[nv:]
        raise TorsorError(f"{self.name}: no equilibrium found from there in {steps} steps; start nearer to one")

    def equilibria_from(self, starts: ArrayLike, *, apart: float = 1e-6, **options: Any) -> list[Equilibrium]:
        """The distinct equilibria that `equilibria` finds from these starts (k, nq), in their order; of one that several lead
        to, what the first finds. Coordinates that differ by less than `apart`, relative to 1 and more, are the same, and
        quaternions of opposite signs are; angles that differ by a turn are not. Options are those of `equilibria`. A start
        from which none is found is passed over; raises TorsorError where that is so of all. Each search is local: that there
        are no more equilibria is not said."""
        found: list[Equilibrium] = []
        rows = np.atleast_2d(as_columns("starts", starts, self._sizes["q"]))
        for start in rows:
            try:
                one = self.equilibria(start, **options)
            except TorsorError:
                continue
            if not any(self._same(one.q, other.q, apart) for other in found):
                found.append(one)
        if not found:
            raise TorsorError(f"{self.name}: no equilibrium found from any of {len(rows)} starts; start nearer to one")
        return found

    def _same(self, q: np.ndarray, other: np.ndarray, apart: float) -> bool:
        other = other.copy()
        for first in self.quaternions:
            other[first:first + 4] *= 1.0 if q[first:first + 4] @ other[first:first + 4] >= 0 else -1.0
        return bool((np.abs(q - other) <= apart * (1.0 + np.abs(q))).all())

    def _displaced(self, q: np.ndarray, change: np.ndarray) -> np.ndarray:
        if "coordinate_rates" not in self.kernels:
            return q + change
        q = q + self.coordinate_rates(q, change)
        for first in self.quaternions:
            q[first:first + 4] /= np.linalg.norm(q[first:first + 4])
        return q
