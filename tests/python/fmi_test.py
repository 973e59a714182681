# SPDX-License-Identifier: GPL-3.0-or-later
"""An importer of FMI 2.0 of our own: what a unit's description and its binary promise, against the runtime."""

import ctypes
import os
import random
import subprocess
import xml.etree.ElementTree as ElementTree
import zipfile
from ctypes import POINTER, byref, c_char_p, c_double, c_int, c_size_t, c_uint, c_void_p

import numpy as np
import pytest

from conftest import PROGRAMS

LOGGER = ctypes.CFUNCTYPE(None, c_void_p, c_char_p, c_int, c_char_p, c_char_p)
OK, DISCARD, ERROR = 0, 2, 3
MODEL_EXCHANGE, CO_SIMULATION = 0, 1


class Callbacks(ctypes.Structure):
    _fields_ = [("logger", c_void_p), ("allocate", c_void_p), ("free", c_void_p), ("finished", c_void_p),
                ("environment", c_void_p)]


class EventInfo(ctypes.Structure):
    _fields_ = [(name, c_int) for name in ("needed", "terminate", "nominals", "values", "defined")] + [("next", c_double)]


def doubles(values):
    values = np.ascontiguousarray(values, dtype=float)
    return values.ctypes.data_as(POINTER(c_double)), values


class Unit:
    """One unit: its description, its binary, and instances of it."""

    def __init__(self, name, folder, *options):
        path = folder / f"{name}.fmu"
        subprocess.run([os.path.join(PROGRAMS, f"{name}_scene"), "fmu", *options, "-o", path], check=True)
        with zipfile.ZipFile(path) as archive:
            assert archive.testzip() is None
            archive.extractall(folder)
            self.names = archive.namelist()
        self.folder = folder
        self.description = ElementTree.parse(folder / "modelDescription.xml").getroot()
        self.variables = [v.attrib | v.find("Real").attrib for v in self.description.iter("ScalarVariable")]
        self.reference = {v["name"]: int(v["valueReference"]) for v in self.variables}
        self.library = ctypes.CDLL(str(folder / f"binaries/linux64/{name}.so"))
        self.states = [int(v["derivative"]) - 1 for v in self.variables if "derivative" in v]
        self.derivatives = [i for i, v in enumerate(self.variables) if "derivative" in v]
        self.n = len(self.states)
        self.callbacks = Callbacks()

    def instantiate(self, kind, token=None):
        function = self.library.fmi2Instantiate
        function.restype = c_void_p
        function.argtypes = [c_char_p, c_int, c_char_p, c_char_p, c_void_p, c_int, c_int]
        token = self.description.attrib["guid"] if token is None else token
        return function(b"one", kind, token.encode(), None, ctypes.addressof(self.callbacks), 0, 0)

    def __getattr__(self, name):
        function = getattr(self.library, "fmi2" + name)
        return lambda component, *arguments: function(c_void_p(component), *arguments)

    def get(self, component, names):
        references = (c_uint * len(names))(*[self.reference[n] if isinstance(n, str) else n for n in names])
        pointer, values = doubles(np.zeros(len(names)))
        assert self.GetReal(component, references, c_size_t(len(names)), pointer) == OK
        return values

    def set(self, component, names, given):
        references = (c_uint * len(names))(*[self.reference[n] if isinstance(n, str) else n for n in names])
        return self.SetReal(component, references, c_size_t(len(names)), doubles(given)[0])

    def initialised(self, kind, start=0.0, tolerance=None):
        component = self.instantiate(kind)
        assert component
        assert self.SetupExperiment(component, int(tolerance is not None), c_double(tolerance or 0), c_double(start), 0,
                                    c_double(0)) == OK
        assert self.EnterInitializationMode(component) == OK
        assert self.ExitInitializationMode(component) == OK
        return component

    def continuous(self):
        component = self.initialised(MODEL_EXCHANGE)
        assert self.NewDiscreteStates(component, byref(EventInfo())) == OK
        assert self.EnterContinuousTimeMode(component) == OK
        return component

    def right_side(self, component, time, y):
        assert self.SetTime(component, c_double(time)) == OK
        assert self.SetContinuousStates(component, doubles(y)[0], c_size_t(self.n)) == OK
        pointer, values = doubles(np.zeros(self.n))
        assert self.GetDerivatives(component, pointer, c_size_t(self.n)) == OK
        return values

    def state(self, component):
        pointer, values = doubles(np.zeros(self.n))
        assert self.GetContinuousStates(component, pointer, c_size_t(self.n)) == OK
        return values


MECHANISMS = ["double_pendulum", "torque_free_body", "rolling_hoop"]


@pytest.fixture(scope="module", params=MECHANISMS)
def unit(request, tmp_path_factory):
    return Unit(request.param, tmp_path_factory.mktemp(request.param), "--run-time", "all")


@pytest.fixture(scope="module")
def mechanism(unit, request):
    return request.getfixturevalue({"double_pendulum": "pendulum", "torque_free_body": "body", "rolling_hoop": "hoop"}[
        unit.description.attrib["modelName"]])


def near_start(mechanism, seed):
    begin = mechanism.initial_state()
    y = np.concatenate([begin.q, begin.v])
    return y + 0.05 * np.random.default_rng(seed).normal(size=len(y))


def test_description_keeps_the_rules(unit):
    root = unit.description
    assert root.attrib["fmiVersion"] == "2.0" and root.attrib["numberOfEventIndicators"] == "0"
    order = [child.tag for child in root]
    assert order == ["ModelExchange", "CoSimulation", "UnitDefinitions", "LogCategories", "DefaultExperiment", "ModelVariables",
                     "ModelStructure"]
    names = [v["name"] for v in unit.variables]
    assert len(set(names)) == len(names)
    units = {u.attrib["name"] for u in root.find("UnitDefinitions")}
    for k, v in enumerate(unit.variables):
        assert int(v["valueReference"]) == k
        assert v.get("unit", next(iter(units))) in units
        # Start values are there exactly where the standard asks for them.
        assert ("start" in v) == (v.get("initial") == "exact" or v["causality"] == "input")
        if "derivative" in v:
            assert v["name"] == f"der({unit.variables[int(v['derivative']) - 1]['name']})"
    structure = root.find("ModelStructure")
    listed = {tag: [int(u.attrib["index"]) - 1 for u in structure.find(tag) or []] for tag in
              ("Outputs", "Derivatives", "InitialUnknowns")}
    outputs = [k for k, v in enumerate(unit.variables) if v["causality"] == "output"]
    assert listed["Outputs"] == outputs and listed["Derivatives"] == unit.derivatives
    assert sorted(listed["InitialUnknowns"]) == sorted(outputs + unit.derivatives)
    for kind in ("ModelExchange", "CoSimulation"):
        for source in root.find(kind).iter("File"):
            assert "sources/" + source.attrib["name"] in unit.names


def test_start_values_are_those_of_the_description(unit, mechanism):
    component = unit.instantiate(CO_SIMULATION)
    unit.EnterInitializationMode(component)
    known = [(k, float(v["start"])) for k, v in enumerate(unit.variables) if "start" in v]
    found = unit.get(component, [k for k, _ in known])
    # The text computes formulas (a sixth of pi) in double, the description rounds once: an ulp or two.
    np.testing.assert_allclose(found, [s for _, s in known], rtol=1e-15, atol=0)
    begin = mechanism.initial_state()
    assert np.array_equal(found[:unit.n], np.concatenate([begin.q, begin.v]))
    unit.FreeInstance(component)


def test_derivatives_are_those_of_the_runtime(unit, mechanism):
    component = unit.continuous()
    f = mechanism.ode()
    for seed in range(20):
        y = near_start(mechanism, seed)
        assert np.array_equal(unit.right_side(component, 0.1 * seed, y), f(0.1 * seed, y))  # no operation differs
    energies = mechanism.energy(y[:len(mechanism.coordinates)], y[len(mechanism.coordinates):], time=1.9)
    kinetic, potential, total = unit.get(component, ["energy.kinetic", "energy.potential", "energy.total"])
    assert kinetic == energies.kinetic and potential == -energies.force_function and total == kinetic + potential
    unit.FreeInstance(component)


def test_directional_derivatives_are_slopes(unit, mechanism):
    component = unit.continuous()
    y = near_start(mechanism, 7)
    outputs = [k for k, v in enumerate(unit.variables) if v["causality"] == "output"]
    unknown = unit.derivatives + outputs

    def values(at):
        return np.concatenate([unit.right_side(component, 0.0, at), unit.get(component, outputs)])

    for k in range(unit.n):
        seed = np.zeros(unit.n)
        seed[k] = 1.0
        if k < 4 and mechanism.quaternions:  # along the sphere of unit quaternions, where motions are
            y[:4] /= np.linalg.norm(y[:4])
            seed[:4] -= y[:4] * (y[:4] @ seed[:4])
        h = 1e-6
        slope = (values(y + h * seed) - values(y - h * seed)) / (2 * h)
        values(y)
        pointer, exact = doubles(np.zeros(len(unknown)))
        assert unit.GetDirectionalDerivative(component, (c_uint * len(unknown))(*unknown), c_size_t(len(unknown)),
                                             (c_uint * unit.n)(*unit.states), c_size_t(unit.n), doubles(seed)[0], pointer) == OK
        # Central differences: h^2/6 of third derivatives of size 1e3, and roundings of values of size 1e2 over h.
        np.testing.assert_allclose(exact, slope, atol=1e-7 * (1 + np.abs(slope).max()))
    unit.FreeInstance(component)


def test_model_exchange_reaches_the_state_of_the_runtime(unit, mechanism):
    """The importer's own Runge-Kutta 4 with the runtime's step, a completed step after each."""
    component = unit.continuous()
    y, h, steps = unit.state(component), 1e-3, 200
    for k in range(steps):
        t = k * h
        k1 = unit.right_side(component, t, y)
        k2 = unit.right_side(component, t + h / 2, y + h / 2 * k1)
        k3 = unit.right_side(component, t + h / 2, y + h / 2 * k2)
        k4 = unit.right_side(component, t + h, y + h * k3)
        y = y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        unit.right_side(component, t + h, y)
        enter, terminate = c_int(), c_int()
        assert unit.CompletedIntegratorStep(component, 1, byref(enter), byref(terminate)) == OK
        assert not enter.value and not terminate.value
        y = unit.state(component)
    own = mechanism.simulate([h * steps], method="runge_kutta_4", step=h)
    # The same formula; sums of steps round otherwise, 200 times, of numbers of size 10.
    np.testing.assert_allclose(y, own.states[0], rtol=1e-12, atol=1e-12)
    unit.FreeInstance(component)


def test_co_simulation_reaches_the_state_of_the_runtime(unit, mechanism):
    component = unit.initialised(CO_SIMULATION, tolerance=1e-12)
    for k in range(10):
        assert unit.DoStep(component, c_double(0.05 * k), c_double(0.05), 1) == OK
    y = unit.get(component, unit.states)
    own = mechanism.simulate([0.5], relative_tolerance=1e-13, absolute_tolerance=1e-13).states[0]
    # 1e-12 of 1 + |y| a step, some 1,000 steps for rates of size 10, and errors that grow by e at most in that time.
    np.testing.assert_allclose(y, own, rtol=1e-8, atol=1e-8)
    if "constraints" in mechanism.kernels:
        nq = len(mechanism.coordinates)
        assert np.abs(mechanism.constraints(y[:nq], y[nq:], time=0.5).rate).max() < 1e-12
    for first in mechanism.quaternions:
        assert abs(np.linalg.norm(y[first:first + 4]) - 1) < 4e-16
    unit.FreeInstance(component)


def test_states_are_restored_and_serialised(unit):
    component = unit.initialised(CO_SIMULATION)
    unit.DoStep(component, c_double(0), c_double(0.1), 1)
    state = c_void_p()
    assert unit.GetFMUstate(component, byref(state)) == OK
    size = c_size_t()
    assert unit.SerializedFMUstateSize(component, state, byref(size)) == OK
    bytes_ = ctypes.create_string_buffer(size.value)
    assert unit.SerializeFMUstate(component, state, bytes_, size) == OK
    unit.DoStep(component, c_double(0.1), c_double(0.1), 1)
    after = unit.get(component, unit.states)
    for restore in (state, None):
        if restore is None:
            restore = c_void_p()
            assert unit.DeSerializeFMUstate(component, bytes_, size, byref(restore)) == OK
        assert unit.SetFMUstate(component, restore) == OK
        unit.DoStep(component, c_double(0.1), c_double(0.1), 1)
        assert np.array_equal(unit.get(component, unit.states), after)
    assert unit.DeSerializeFMUstate(component, bytes_, c_size_t(size.value - 1), byref(restore)) == ERROR
    assert unit.FreeFMUstate(component, byref(state)) == OK and not state.value
    unit.FreeFMUstate(component, byref(restore))
    unit.FreeInstance(component)


def test_parameters_can_be_tuned(unit, mechanism):
    names = [v["name"] for v in unit.variables if v["causality"] == "parameter"]
    if not names:
        pytest.skip("no run-time parameters")
    component = unit.initialised(MODEL_EXCHANGE)
    before = unit.get(component, [*unit.derivatives, "energy.total"])
    values = unit.get(component, names) * np.linspace(1.1, 1.3, len(names))
    assert unit.set(component, names, values) == OK
    y = unit.state(component)
    given = {name.removeprefix("parameter."): value for name, value in zip(names, values)}
    expected = mechanism.ode(parameters=given)(0.0, y)
    found = unit.get(component, unit.derivatives)
    assert np.array_equal(found, expected)
    assert not np.array_equal([*found, *unit.get(component, ["energy.total"])], before)
    unit.FreeInstance(component)


def test_refuses_what_is_not_allowed(unit):
    assert unit.instantiate(CO_SIMULATION, token="{another}") is None
    component = unit.instantiate(CO_SIMULATION)
    assert unit.DoStep(component, c_double(0), c_double(0.1), 1) == ERROR
    assert unit.EnterEventMode(component) == ERROR
    unit.FreeInstance(component)
    component = unit.initialised(CO_SIMULATION)
    assert unit.set(component, [unit.states[0]], [0.0]) == ERROR  # states start, and then move
    assert unit.set(component, [10**6], [0.0]) == ERROR
    assert unit.DoStep(component, c_double(5), c_double(0.1), 1) == ERROR
    assert unit.DoStep(component, c_double(0), c_double(-0.1), 1) == ERROR
    unit.FreeInstance(component)


def test_random_calls_never_crash(unit):
    """Any call in any state is answered; what it answers after is what the state machine says."""
    random.seed(1)
    count = int(os.environ.get("TORSOR_FMI_CALLS", "20000" if unit.n == 4 else "4000"))
    vr, value = (c_uint * 2)(0, 10**6), doubles(np.zeros(64))[0]
    info, flags = EventInfo(), (c_int * 2)()
    state = c_void_p()
    component = None
    calls = [
        lambda: unit.SetupExperiment(component, 1, c_double(1e-6), c_double(0), 0, c_double(0)),
        lambda: unit.EnterInitializationMode(component), lambda: unit.ExitInitializationMode(component),
        lambda: unit.EnterEventMode(component), lambda: unit.NewDiscreteStates(component, byref(info)),
        lambda: unit.EnterContinuousTimeMode(component), lambda: unit.SetTime(component, c_double(random.random())),
        lambda: unit.CompletedIntegratorStep(component, 1, byref(flags), byref(flags, 4)),
        lambda: unit.GetReal(component, vr, c_size_t(random.randint(0, 2)), value),
        lambda: unit.SetReal(component, vr, c_size_t(random.randint(0, 2)), value),
        lambda: unit.GetReal(component, None, c_size_t(1), None),
        lambda: unit.GetDerivatives(component, value, c_size_t(random.choice([0, unit.n]))),
        lambda: unit.GetContinuousStates(component, value, c_size_t(unit.n)),
        lambda: unit.SetContinuousStates(component, value, c_size_t(unit.n)),
        lambda: unit.GetNominalsOfContinuousStates(component, value, c_size_t(unit.n)),
        lambda: unit.GetEventIndicators(component, None, c_size_t(0)),
        lambda: unit.DoStep(component, c_double(0), c_double(1e-4), 1), lambda: unit.CancelStep(component),
        lambda: unit.GetFMUstate(component, byref(state)), lambda: unit.SetFMUstate(component, state),
        lambda: unit.FreeFMUstate(component, byref(state)), lambda: unit.Reset(component), lambda: unit.Terminate(component),
        lambda: unit.GetDirectionalDerivative(component, vr, c_size_t(1), vr, c_size_t(1), value, value),
    ]
    answers = set()
    for k in range(count):
        if k % 200 == 0:
            unit.FreeInstance(component)
            component = unit.instantiate(random.choice([MODEL_EXCHANGE, CO_SIMULATION]))
        answers.add(random.choice(calls)())
    assert {OK, ERROR} <= answers <= {OK, DISCARD, ERROR}
    unit.FreeFMUstate(component, byref(state))
    unit.FreeInstance(component)
