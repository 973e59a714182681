# SPDX-License-Identifier: GPL-3.0-or-later
"""An importer of FMI 2.0 and of FMI 3.0 of our own: a unit's description, its binary, and instances of it."""

import ctypes
import subprocess
import xml.etree.ElementTree as ElementTree
import zipfile
from ctypes import POINTER, byref, c_bool, c_char_p, c_double, c_int, c_size_t, c_uint, c_void_p

import numpy as np
from scipy.integrate import DOP853

from conftest import command

OK, DISCARD, ERROR = 0, 2, 3
MODEL_EXCHANGE, CO_SIMULATION = 0, 1


def doubles(values):
    values = np.ascontiguousarray(values, dtype=float)
    return values.ctypes.data_as(POINTER(c_double)), values


class Unit:
    """What both versions have; components are addresses, answers those of the unit."""

    def __init__(self, name, folder, *options):
        path = folder / f"{name}.fmu"
        subprocess.run(command(name, "fmu", "--fmi", str(self.version), *options, "-o", path), check=True)
        with zipfile.ZipFile(path) as archive:
            assert archive.testzip() is None
            archive.extractall(folder)
            self.names = archive.namelist()
        self.folder = folder
        self.description = ElementTree.parse(folder / "modelDescription.xml").getroot()
        binary, = [each for each in self.names if each.startswith("binaries/")]
        self.library = ctypes.CDLL(str(folder / binary))
        self.variables = self.read_variables()
        self.reference = {v["name"]: int(v["valueReference"]) for v in self.variables}
        self.by_reference = {int(v["valueReference"]): v for v in self.variables}
        self.states = [self.state_of(v) for v in self.variables if "derivative" in v]
        self.derivatives = [int(v["valueReference"]) for v in self.variables if "derivative" in v]
        self.n = len(self.states)
        self.messages = []
        self.categories = {each.attrib["name"].encode() for each in self.description.find("LogCategories")}

    def __getattr__(self, name):
        function = getattr(self.library, f"fmi{self.version}{name}")
        return lambda component, *arguments: function(c_void_p(component), *arguments)

    def log(self, status, message, category):
        assert b"%" not in message and category in self.categories
        assert category == (b"logStatusDiscard" if status == DISCARD else b"logStatusError")
        self.messages.append((status, message))

    def references(self, names):
        return (c_uint * len(names))(*[self.reference[n] if isinstance(n, str) else n for n in names])

    def initialised(self, kind, start=0.0, tolerance=None):
        component = self.instantiate(kind)
        assert component
        assert self.initialise(component, start, tolerance) == OK
        assert self.ExitInitializationMode(component) == OK
        return component

    def continuous(self, tolerance=None):
        component = self.initialised(MODEL_EXCHANGE, tolerance=tolerance)
        assert not self.update(component)  # what the scene starts with fulfils its constraints
        assert self.EnterContinuousTimeMode(component) == OK
        return component

    def right_side(self, component, time, y):
        assert self.SetTime(component, c_double(time)) == OK
        assert self.SetContinuousStates(component, doubles(y)[0], c_size_t(self.n)) == OK
        pointer, values = doubles(np.zeros(self.n))
        assert self.get_derivatives(component, pointer) == OK
        return values

    def indicators(self, component):
        pointer, values = doubles(np.zeros(self.indicator_count))
        assert self.GetEventIndicators(component, pointer, c_size_t(self.indicator_count)) == OK
        return values

    def integrated(self, component, time, end, tolerance=1e-12):
        """Model exchange as an importer does it: scipy's steps, at the end of each the indicators, and where one has fallen
        to zero or below, an event at the first such time by bisection of the step's interpolant. The events' times."""
        def at(t, y):
            self.right_side(component, t, y)
            return self.indicators(component)

        y, times = self.state(component), []
        while time < end:
            solver = DOP853(lambda t, y: self.right_side(component, t, y), time, y, end, rtol=tolerance, atol=tolerance)
            event = False
            while solver.status == "running" and not event:
                solver.step()
                time, y = solver.t, solver.y
                if (at(time, y) <= 0).any():
                    between, before = solver.dense_output(), solver.t_old
                    while before < (middle := (before + time) / 2) < time:
                        if (at(middle, between(middle)) <= 0).any():
                            time = middle
                        else:
                            before = middle
                    y, event = between(time) if time < solver.t else solver.y, True
                    at(time, y)
                answer, wanted = self.complete_step(component) if not event else (OK, False)
                assert answer == OK
                event = event or wanted
            assert solver.status != "failed"
            if event:
                times.append(time)
                assert self.EnterEventMode(component) == OK
                self.update(component)
                assert not self.update(component) and (self.indicators(component) > 0).all()
                y = self.state(component)
                assert self.EnterContinuousTimeMode(component) == OK
        return times

    def state(self, component):
        pointer, values = doubles(np.zeros(self.n))
        assert self.GetContinuousStates(component, pointer, c_size_t(self.n)) == OK
        return values

    def get(self, component, names):
        pointer, values = doubles(np.zeros(len(names)))
        assert self.get_numbers(component, self.references(names), len(names), pointer) == OK
        return values

    def set(self, component, names, given):
        return self.set_numbers(component, self.references(names), len(names), doubles(given)[0])


def begun(unit, names=(), values=(), kind=CO_SIMULATION):
    """An instance that starts with these values."""
    component = unit.instantiate(kind)
    assert component
    assert unit.initialise(component, 0.0, 1e-12) == OK
    assert unit.set(component, list(names), values) == OK
    assert unit.ExitInitializationMode(component) == OK
    return component


def exchanged(unit, names=(), values=()):
    """One that an importer integrates."""
    component = begun(unit, names, values, MODEL_EXCHANGE)
    unit.update(component)
    assert unit.EnterContinuousTimeMode(component) == OK
    return component


def assert_slopes_by_parameters(unit, component):
    """Directional derivatives by the tunable parameters are slopes; in event mode, where parameters are set."""
    names = [v["name"] for v in unit.variables if v["causality"] == "parameter"]
    unknown = unit.derivatives + unit.outputs
    begin = unit.get(component, names)

    def at(values):
        assert unit.set(component, names, values) == OK
        return unit.get(component, unknown)

    def derivative(known, seed):
        pointer, found = doubles(np.zeros(len(unknown)))
        assert unit.directional(component, unknown, known, seed, pointer) == OK
        return found

    scale, of_state, columns = 1 + np.abs(at(begin)).max(), derivative(unit.states[:1], [1.0]), []
    for k, name in enumerate(names):
        h = 1e-5 * (abs(begin[k]) or 1.0)
        step = np.where(np.arange(len(names)) == k, h, 0.0)
        slope = (at(begin + step) - at(begin - step)) / (2 * h)
        at(begin)
        columns.append(derivative([name], [1.0]))
        # Central differences: (1e-5)^2/6 of third derivatives in units of the parameter, at most a thousand times the
        # values, and some ten roundings of values over h.
        np.testing.assert_allclose(columns[-1], slope, rtol=0, atol=scale * (1e-10 * 1e3 / 6 + 1e-15 / 1e-5) * 1e-5 / h)
    assert np.abs(columns).max() > 0
    seed = np.linspace(0.5, 1.5, len(names) + 1)
    together = derivative([unit.states[0], *names], seed)
    expected = np.transpose([of_state, *columns]) @ seed
    # The same products, summed in another order.
    np.testing.assert_allclose(together, expected, rtol=0, atol=1e-14 * (np.abs([of_state, *columns]).T @ seed).max())


def assert_slopes_while_regimes_last(unit, component, attitude=(), known=()):
    """Of all derivatives of states, by states and by others that can be set, as an importer of model exchange sees them change.
    `attitude` are the states of quaternions, four of each, which change along unit ones alone. Gives a column for each known."""
    begin, count = unit.state(component), len(known)
    given, names = unit.get(component, list(known)), [unit.by_reference[k]["name"] for k in unit.states] + list(known)
    turns = [[names.index(name) for name in attitude[k:k + 4]] for k in range(0, len(attitude), 4)]

    def at(change):
        assert unit.SetContinuousStates(component, doubles(begin + change[:unit.n])[0], c_size_t(unit.n)) == OK
        assert unit.set(component, list(known), given + change[unit.n:]) == OK
        pointer, values = doubles(np.zeros(unit.n))
        assert unit.get_derivatives(component, pointer) == OK
        return values

    def derivative(seed):
        pointer, found = doubles(np.zeros(unit.n))
        assert unit.directional(component, unit.derivatives, names, seed, pointer) == OK
        return found

    h, columns, scale = 1e-4, [], 1 + np.abs(at(np.zeros(unit.n + count))).max()
    for k in range(unit.n + count):
        direction = np.eye(unit.n + count)[k]
        for turn in turns:
            direction[turn] -= begin[turn] * (begin[turn] @ direction[turn])
        near, far = (at(m * h * direction) - at(-m * h * direction) for m in (1, 2))
        slope = (8 * near - far) / (12 * h)
        at(np.zeros(unit.n + count))
        columns.append(derivative(direction))
        # Central differences of the fourth order: h^4/30 of fifth derivatives, at most a million times the values, and a hundred
        # roundings over h.
        np.testing.assert_allclose(columns[-1], slope, rtol=0, atol=scale * (h**4 * 1e6 / 30 + 1e-14 / h), err_msg=names[k])
    if unit.version == 3:
        seed = np.linspace(0.5, 1.5, unit.n)
        pointer, found = doubles(np.zeros(len(names)))
        assert unit.adjoint(component, unit.derivatives, names, seed, pointer) == OK
        straight = [derivative(unit_vector) for unit_vector in np.eye(unit.n + count)]
        np.testing.assert_allclose(found, np.array(straight) @ seed, rtol=0, atol=1e-13 * (np.abs(straight) @ seed).max())
    return np.transpose(columns)


class EventInfo(ctypes.Structure):
    _fields_ = [(name, c_int) for name in ("needed", "terminate", "nominals", "values", "defined")] + [("next", c_double)]


class Unit2(Unit):
    version = 2
    LOGGER = ctypes.CFUNCTYPE(None, c_void_p, c_char_p, c_int, c_char_p, c_char_p)

    class Callbacks(ctypes.Structure):
        _fields_ = [("logger", c_void_p), ("allocate", c_void_p), ("free", c_void_p), ("finished", c_void_p),
                    ("environment", c_void_p)]

    def __init__(self, *arguments):
        super().__init__(*arguments)
        # Variadic, but messages are whole: an importer in Python fills no formats.
        self.logger = self.LOGGER(lambda _, __, status, category, message: self.log(status, message, category))
        self.callbacks = self.Callbacks(ctypes.cast(self.logger, c_void_p).value)
        self.outputs = self.listed("Outputs")
        self.initial_unknowns = self.listed("InitialUnknowns")
        self.listed_derivatives = self.listed("Derivatives")
        self.token = self.description.attrib["guid"]
        self.indicator_count = int(self.description.attrib["numberOfEventIndicators"])

    def read_variables(self):
        return [v.attrib | v.find("Real").attrib for v in self.description.iter("ScalarVariable")]

    def counted(self, index):
        """The value reference of a variable by its place, which this version counts from 1."""
        return int(self.variables[int(index) - 1]["valueReference"])

    def state_of(self, variable):
        return self.counted(variable["derivative"])

    def unknowns(self, tag):
        return list(self.description.find("ModelStructure").find(tag) or [])

    def listed(self, tag):
        return [self.counted(u.attrib["index"]) for u in self.unknowns(tag)]

    def dependencies(self, initially=False):
        """Of each output the references of what it depends on, or None: on all."""
        all_ = {}
        for u in self.unknowns("InitialUnknowns" if initially else "Outputs"):
            on = u.attrib.get("dependencies")
            all_[self.counted(u.attrib["index"])] = None if on is None else [self.counted(k) for k in on.split()]
        return all_

    def instantiate(self, kind, token=None, logging=True, name=b"one"):
        function = self.library.fmi2Instantiate
        function.restype = c_void_p
        function.argtypes = [c_char_p, c_int, c_char_p, c_char_p, c_void_p, c_int, c_int]
        return function(name, kind, (token or self.token).encode(), None, ctypes.addressof(self.callbacks), 0, int(logging))

    def initialise(self, component, start=0.0, tolerance=None, stop=None):
        answer = self.SetupExperiment(component, int(tolerance is not None), c_double(tolerance or 0), c_double(start),
                                      int(stop is not None), c_double(stop or 0))
        return answer or self.EnterInitializationMode(component)

    def update(self, component):
        """Whether values of states changed."""
        info = EventInfo()
        assert self.NewDiscreteStates(component, byref(info)) == OK
        return bool(info.values)

    def complete_step(self, component):
        enter, terminate = c_int(7), c_int(7)
        answer = self.CompletedIntegratorStep(component, 1, byref(enter), byref(terminate))
        return answer, bool(enter.value)

    def step(self, component, time, size):
        return self.DoStep(component, c_double(time), c_double(size), 1)

    def get_derivatives(self, component, pointer):
        return self.GetDerivatives(component, pointer, c_size_t(self.n))

    def get_numbers(self, component, references, count, pointer):
        return self.GetReal(component, references, c_size_t(count), pointer)

    def set_numbers(self, component, references, count, pointer):
        return self.SetReal(component, references, c_size_t(count), pointer)

    def directional(self, component, unknown, known, seed, pointer):
        return self.GetDirectionalDerivative(component, self.references(unknown), c_size_t(len(unknown)), self.references(known),
                                             c_size_t(len(known)), doubles(seed)[0], pointer)

    memory = {"get": "GetFMUstate", "set": "SetFMUstate", "free": "FreeFMUstate", "size": "SerializedFMUstateSize",
              "write": "SerializeFMUstate", "read": "DeSerializeFMUstate"}


class Unit3(Unit):
    version = 3
    LOGGER = ctypes.CFUNCTYPE(None, c_void_p, c_int, c_char_p, c_char_p)

    def __init__(self, *arguments):
        super().__init__(*arguments)
        self.logger = self.LOGGER(lambda _, status, category, message: self.log(status, message, category))
        self.outputs = self.listed("Output")
        self.initial_unknowns = self.listed("InitialUnknown")
        self.listed_derivatives = self.listed("ContinuousStateDerivative")
        self.token = self.description.attrib["instantiationToken"]
        self.indicator_count = len(self.listed("EventIndicator"))

    def read_variables(self):
        return [v.attrib for v in self.description.find("ModelVariables")]

    def state_of(self, variable):
        return int(variable["derivative"])

    def unknowns(self, tag):
        return self.description.find("ModelStructure").findall(tag)

    def listed(self, tag):
        return [int(u.attrib["valueReference"]) for u in self.unknowns(tag)]

    def dependencies(self, initially=False):
        """Of each output the references of what it depends on, or None: on all."""
        all_ = {}
        for u in self.unknowns("InitialUnknown" if initially else "Output"):
            on = u.attrib.get("dependencies")
            all_[int(u.attrib["valueReference"])] = None if on is None else [int(k) for k in on.split()]
        return all_

    def instantiate(self, kind, token=None, logging=True, events=False, intermediate=0, name=b"one"):
        token = (token or self.token).encode()
        if kind == MODEL_EXCHANGE:
            function = self.library.fmi3InstantiateModelExchange
            function.restype = c_void_p
            return function(name, token, None, c_bool(False), c_bool(logging), None, self.logger)
        function = self.library.fmi3InstantiateCoSimulation
        function.restype = c_void_p
        return function(name, token, None, c_bool(False), c_bool(logging), c_bool(events), c_bool(True), None,
                        c_size_t(intermediate), None, self.logger, None)

    def initialise(self, component, start=0.0, tolerance=None, stop=None):
        return self.EnterInitializationMode(component, c_bool(tolerance is not None), c_double(tolerance or 0), c_double(start),
                                            c_bool(stop is not None), c_double(stop or 0))

    def update(self, component):
        flags, time = (c_bool * 5)(*[True] * 5), c_double()
        assert self.UpdateDiscreteStates(component, *[byref(flags, k) for k in range(5)], byref(time)) == OK
        assert not (flags[0] or flags[1] or flags[2] or flags[4])
        return flags[3]

    def complete_step(self, component):
        flags = (c_bool * 2)(True, True)
        answer = self.CompletedIntegratorStep(component, c_bool(True), byref(flags), byref(flags, 1))
        return answer, flags[0]

    def step(self, component, time, size):
        flags, reached = (c_bool * 3)(True, True, True), c_double(-1)
        answer = self.DoStep(component, c_double(time), c_double(size), c_bool(True), *[byref(flags, k) for k in range(3)],
                             byref(reached))
        if answer == OK:
            assert not any(flags) and reached.value == time + size
        self.reached = reached.value
        return answer

    def get_derivatives(self, component, pointer):
        return self.GetContinuousStateDerivatives(component, pointer, c_size_t(self.n))

    def get_numbers(self, component, references, count, pointer):
        return self.GetFloat64(component, references, c_size_t(count), pointer, c_size_t(count))

    def set_numbers(self, component, references, count, pointer):
        return self.SetFloat64(component, references, c_size_t(count), pointer, c_size_t(count))

    def directional(self, component, unknown, known, seed, pointer):
        return self.GetDirectionalDerivative(component, self.references(unknown), c_size_t(len(unknown)), self.references(known),
                                             c_size_t(len(known)), doubles(seed)[0], c_size_t(len(known)), pointer,
                                             c_size_t(len(unknown)))

    def adjoint(self, component, unknown, known, seed, pointer):
        return self.GetAdjointDerivative(component, self.references(unknown), c_size_t(len(unknown)), self.references(known),
                                         c_size_t(len(known)), doubles(seed)[0], c_size_t(len(unknown)), pointer,
                                         c_size_t(len(known)))

    memory = {"get": "GetFMUState", "set": "SetFMUState", "free": "FreeFMUState", "size": "SerializedFMUStateSize",
              "write": "SerializeFMUState", "read": "DeserializeFMUState"}
