# SPDX-License-Identifier: GPL-3.0-or-later
"""What units of FMI 2.0 and 3.0 promise, in their descriptions and in their binaries, against the runtime."""

import ctypes
import os
import platform
import shutil
import subprocess
import xml.etree.ElementTree as ElementTree
from ctypes import byref, c_size_t, c_void_p

import numpy as np
import pytest

from fmi_importer import CO_SIMULATION, DISCARD, ERROR, MODEL_EXCHANGE, OK, Unit2, Unit3, assert_slopes_by_parameters, doubles

MECHANISMS = {"double_pendulum": "pendulum", "cart_pole": "cart", "torque_free_body": "body", "rolling_hoop": "hoop"}
if os.environ.get("TORSOR_LONG_TESTS"):
    MECHANISMS["quadruped"] = "quadruped"  # which takes the compiler a while


@pytest.fixture(scope="module", params=[(name, kind) for name in MECHANISMS for kind in (Unit2, Unit3)],
                ids=lambda p: f"{p[0]}-{p[1].version}")
def unit(request, tmp_path_factory):
    name, kind = request.param
    tuned = () if name == "quadruped" else ("--run-time", "all")  # its text alone takes the compiler long
    return kind(name, tmp_path_factory.mktemp(name), "--flags=-O0", *tuned)


@pytest.fixture(scope="module")
def mechanism(unit, request):
    return request.getfixturevalue(MECHANISMS[unit.description.attrib["modelName"]])


def near_start(mechanism, seed):
    begin = mechanism.initial_state()
    y = np.concatenate([begin.q, begin.v])
    return y + 0.05 * np.random.default_rng(seed).normal(size=len(y))


def test_description_keeps_the_rules(unit):
    root = unit.description
    assert root.attrib["fmiVersion"] == f"{unit.version}.0"
    assert unit.version == 3 or root.attrib["numberOfEventIndicators"] == "0"
    assert root.attrib["variableNamingConvention"] == "structured"
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
        assert ("start" in v) == (v.get("initial") in ("exact", "approx") or v["causality"] == "input")
        if "derivative" in v:
            assert v["name"] == f"der({unit.variables[unit.state_of(v)]['name']})"
    times = [v["name"] for v in unit.variables if v["causality"] == "independent"]
    assert times == (["time"] if unit.version == 3 else [])  # asked for by FMI 3.0 alone
    outputs = [k for k, v in enumerate(unit.variables) if v["causality"] == "output"]
    assert unit.outputs == outputs and unit.listed_derivatives == unit.derivatives
    assert {"energy.kinetic", "energy.potential", "energy.total"} <= {names[k] for k in outputs}
    follow = [unit.reference[v["name"]] for v in unit.variables if v.get("initial") == "approx"]
    assert set(follow) <= set(unit.states)
    assert unit.initial_unknowns == sorted(outputs + unit.derivatives + follow)  # FMI 2.0 asks for that order
    assert list(unit.dependencies()) == outputs and [k for k in unit.dependencies(initially=True) if k in outputs] == outputs
    tags = [child.tag for child in root.find("ModelStructure")]
    assert tags == sorted(tags, key=["Outputs", "Derivatives", "Output", "ContinuousStateDerivative", "InitialUnknown",
                                     "InitialUnknowns"].index)


def test_sources_are_those_that_the_description_names(unit):
    if unit.version == 2:
        files = [f.attrib["name"] for kind in ("ModelExchange", "CoSimulation") for f in unit.description.find(kind).iter("File")]
    else:
        build = ElementTree.parse(unit.folder / "sources/buildDescription.xml").getroot()
        assert build.attrib["fmiVersion"] == "3.0"
        configurations = build.findall("BuildConfiguration")
        assert {c.attrib["modelIdentifier"] for c in configurations} == {unit.description.attrib["modelName"]}
        # Microsoft's compiler knows neither options of others nor a library m; the last one is for all other platforms.
        assert [(c.get("platform"), [lib.attrib["name"] for lib in c.findall("Library")]) for c in configurations] == [
            ("x86_64-windows", []), ("x86-windows", []), (None, ["m"])]
        assert not [s for s in build.iter("SourceFileSet") if "compilerOptions" in s.attrib]
        files = [f.attrib["name"] for f in build.iter("SourceFile")]
    assert files and {"sources/" + name for name in files} <= set(unit.names)
    # Here the tests run where the unit was made: its folder is that of this processor and system.
    assert any(name.startswith(("binaries/linux64/", "binaries/x86_64-linux/", "binaries/aarch64-linux/")) for name in unit.names)


def test_sources_are_not_fused(unit):
    """Without an option, whatever the processor has: the sources say so themselves."""
    source = unit.folder / "sources" / f"{unit.description.attrib['modelName']}_fmi{unit.version}.c"
    tried = 0
    for compiler in ("gcc", "clang"):
        if shutil.which(compiler) is None or platform.machine() != "x86_64":
            continue
        def assembled(*words, of=compiler):
            return subprocess.run([of, "-O1", "-mfma", "-S", "-o", "-", *words], check=True, capture_output=True, text=True).stdout
        assert "vfmadd" not in assembled(source)
        plain = unit.folder / "plain.c"
        plain.write_text("double f(double a, double b, double c) { return a * b + c; }")
        tried += "vfmadd" in assembled(plain)
    assert tried or platform.machine() != "x86_64"


def test_licences_are_told(unit):
    assert unit.description.attrib["license"] == "MIT-0" and "torsor" in unit.description.attrib["copyright"]
    texts = {name.removeprefix("documentation/licenses/") for name in unit.names if name.startswith("documentation/licenses/")}
    assert texts == {"license.txt", "MIT-0.txt"}
    assert "Permission is hereby granted" in (unit.folder / "documentation/licenses/MIT-0.txt").read_text()
    assert "MIT-0.txt" in (unit.folder / "documentation/licenses/license.txt").read_text()


def test_start_values_are_those_of_the_description(unit, mechanism):
    component = unit.instantiate(CO_SIMULATION)
    unit.initialise(component)
    known = [(k, float(v["start"])) for k, v in enumerate(unit.variables) if "start" in v]
    found = unit.get(component, [k for k, _ in known])
    # The text computes formulas (a sixth of pi) in double, the description rounds once: an ulp or two.
    np.testing.assert_allclose(found, [s for _, s in known], rtol=1e-15, atol=0)
    begin = mechanism.initial_state()
    assert np.array_equal(found[:unit.n], np.concatenate([begin.q, begin.v]))
    unit.FreeInstance(component)


def test_states_can_be_read_while_they_are_initialised(unit):
    """FMI 2.0.4, 3.2.3, and FMI 3.0, 3.2.3; also what has been set just now, and indicators, of which there are none."""
    component = unit.instantiate(MODEL_EXCHANGE)
    assert unit.initialise(component) == OK
    assert unit.set(component, unit.states[-1:], [0.25]) == OK
    assert np.array_equal(unit.state(component), unit.get(component, unit.states)) and unit.state(component)[-1] == 0.25
    assert unit.indicators(component).shape == (0,)
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
    inputs = [k for k, v in enumerate(unit.variables) if v["causality"] == "input"]
    y = np.concatenate([near_start(mechanism, 7), np.full(len(inputs), 0.3)])
    known, unknown = unit.states + inputs, unit.derivatives + unit.outputs

    def values(at):
        assert unit.set(component, inputs, at[unit.n:]) == OK
        return np.concatenate([unit.right_side(component, 0.0, at[:unit.n]), unit.get(component, unit.outputs)])

    for k in range(len(known)):
        seed = np.zeros(len(known))
        seed[k] = 1.0
        for i in mechanism.quaternions:  # along the sphere of unit quaternions, where motions are
            y[i:i + 4] /= np.linalg.norm(y[i:i + 4])
            seed[i:i + 4] -= y[i:i + 4] * (y[i:i + 4] @ seed[i:i + 4])
        h = 1e-6
        slope = (values(y + h * seed) - values(y - h * seed)) / (2 * h)
        values(y)
        pointer, exact = doubles(np.zeros(len(unknown)))
        assert unit.directional(component, unknown, known, seed, pointer) == OK
        # Central differences: h^2/6 of third derivatives of size 1e3, and roundings of values of size 1e2 over h.
        np.testing.assert_allclose(exact, slope, atol=1e-7 * (1 + np.abs(slope).max()))
    unit.FreeInstance(component)


def test_directional_derivatives_by_parameters_are_slopes(unit, mechanism):
    if not [v for v in unit.variables if v["causality"] == "parameter"]:
        pytest.skip("no run-time parameters")
    component = unit.instantiate(MODEL_EXCHANGE)
    assert unit.initialise(component) == OK
    y = near_start(mechanism, 11)
    for i in mechanism.quaternions:
        y[i:i + 4] /= np.linalg.norm(y[i:i + 4])
    assert unit.set(component, unit.states, y) == OK
    assert unit.ExitInitializationMode(component) == OK
    assert_slopes_by_parameters(unit, component)
    unit.FreeInstance(component)


def test_adjoint_derivatives_are_transposed(unit, mechanism):
    if unit.version == 2:
        pytest.skip("FMI 2.0 has none")
    component = unit.continuous()
    unit.right_side(component, 0.0, near_start(mechanism, 3))
    known = unit.states + [k for k, v in enumerate(unit.variables) if v["causality"] in ("input", "parameter")]
    unknown = unit.derivatives + unit.outputs
    matrix = np.zeros((len(unknown), len(known)))
    for k in range(len(known)):
        pointer, column = doubles(np.zeros(len(unknown)))
        assert unit.directional(component, unknown, known[k:k + 1], [1.0], pointer) == OK
        matrix[:, k] = column
    seed = np.random.default_rng(5).normal(size=len(unknown))
    pointer, found = doubles(np.zeros(len(known)))
    assert unit.adjoint(component, unknown, known, seed, pointer) == OK
    # Sums of as many products, in another order.
    np.testing.assert_allclose(found, seed @ matrix, rtol=0, atol=1e-15 * len(unknown) * np.abs(matrix).max() * np.abs(seed).max())
    unit.FreeInstance(component)


def runge_kutta_4(unit, component, y, t, h):
    k1 = unit.right_side(component, t, y)
    k2 = unit.right_side(component, t + h / 2, y + h / 2 * k1)
    k3 = unit.right_side(component, t + h / 2, y + h / 2 * k2)
    k4 = unit.right_side(component, t + h, y + h * k3)
    y = y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    unit.right_side(component, t + h, y)
    return y


def test_model_exchange_reaches_the_state_of_the_runtime(unit, mechanism):
    """The importer's own Runge-Kutta 4 with the runtime's step, a completed step after each."""
    component = unit.continuous()
    y, h, steps = unit.state(component), 1e-3, 200
    for k in range(steps):
        runge_kutta_4(unit, component, y, k * h, h)
        assert unit.complete_step(component) == (OK, False)
        y = unit.state(component)
    own = mechanism.simulate([h * steps], method="runge_kutta_4", step=h)
    # The same formula; sums of steps round otherwise, 200 times, of numbers of size 10.
    np.testing.assert_allclose(y, own.states[0], rtol=1e-12, atol=1e-12)
    unit.FreeInstance(component)


def off_constraints(mechanism, y):
    nq = len(mechanism.coordinates)
    off = [np.linalg.norm(y[k:k + 4]) - 1 for k in mechanism.quaternions]
    if "constraints" in mechanism.kernels:
        of = mechanism.constraints(y[:nq], y[nq:])
        off += [*of.value, *of.rate]
    return np.abs(off).max() if off else 0.0


def test_states_off_their_constraints_are_an_event(unit, mechanism):
    """An importer that keeps to the standard reads states again only where an event says that they changed."""
    component = unit.continuous(tolerance=1e-8)
    y = unit.state(component)
    constrained = bool(mechanism.quaternions) or "constraints" in mechanism.kernels
    y = y + 1e-5 * np.random.default_rng(4).normal(size=len(y))
    unit.right_side(component, 0.0, y)
    assert unit.complete_step(component) == (OK, constrained)
    assert unit.EnterEventMode(component) == OK
    assert unit.update(component) == constrained and not unit.update(component)
    put_back = unit.state(component)
    if constrained:
        assert off_constraints(mechanism, y) > 1e-7 and off_constraints(mechanism, put_back) < 1e-13
        assert 1e-8 < np.abs(put_back - y).max() < 1e-3
    else:
        assert np.array_equal(put_back, y)
    unit.FreeInstance(component)


def test_a_state_that_cannot_be_put_back_is_refused(unit, mechanism):
    if not mechanism.quaternions:
        pytest.skip("nothing that has a size")
    component = unit.continuous()
    y = unit.state(component)
    first = mechanism.quaternions[0]
    y[first:first + 4] = 0.0
    unit.SetContinuousStates(component, doubles(y)[0], c_size_t(unit.n))
    unit.messages.clear()
    assert unit.complete_step(component) == (DISCARD, False)
    names = ", ".join(unit.by_reference[k]["name"] for k in unit.states[first:first + 4]).encode()
    said = b"the quaternion (" + names + b") is zero, which is no attitude: set one of norm 1"
    assert [text.split(b": ", 1)[1] for _, text in unit.messages] == [said]
    assert np.array_equal(unit.state(component), y)
    unit.FreeInstance(component)
    # From a start with it no motion begins.
    component = unit.instantiate(CO_SIMULATION)
    assert unit.initialise(component) == OK and unit.set(component, unit.states[first:first + 4], np.zeros(4)) == OK
    unit.messages.clear()
    assert unit.ExitInitializationMode(component) == ERROR
    assert [text.split(b": ", 1)[1] for _, text in unit.messages] == [said]
    unit.FreeInstance(component)


def test_co_simulation_reaches_the_state_of_the_runtime(unit, mechanism):
    component = unit.initialised(CO_SIMULATION, tolerance=1e-14)
    for k in range(10):
        assert unit.step(component, 0.05 * k, 0.05) == OK
    y = unit.get(component, unit.states)
    own = mechanism.simulate([0.5], relative_tolerance=1e-14, absolute_tolerance=1e-14).states[0]
    # Some 500 steps, of 1 ms for rates of 10 /s. In each the formula of fourth order errs by 1e-14 of 1 + |y| at most, that of
    # fifth order, which is kept, by a hundredth of it; errors grow by e in that time. 500 1e-16 e < 2e-13, and the
    # roundings of 500 sums are as many.
    np.testing.assert_allclose(y, own, rtol=1e-12, atol=1e-12)
    assert off_constraints(mechanism, y) < 1e-12
    unit.FreeInstance(component)


def test_states_are_restored_and_serialised(unit):
    component = unit.initialised(CO_SIMULATION)
    call = {what: getattr(unit, name) for what, name in unit.memory.items()}
    unit.step(component, 0, 0.1)
    state = c_void_p()
    assert call["get"](component, byref(state)) == OK
    size = c_size_t()
    assert call["size"](component, state, byref(size)) == OK
    bytes_ = ctypes.create_string_buffer(size.value)
    assert call["write"](component, state, bytes_, size) == OK
    unit.step(component, 0.1, 0.1)
    after = unit.get(component, unit.states)
    tuned = [v["name"] for v in unit.variables if v["causality"] == "parameter"]
    for restore in (state, None):
        # Parameters belong to a state, and what is computed of them.
        assert unit.set(component, tuned, 1.25 * unit.get(component, tuned)) == OK
        if restore is None:
            restore = c_void_p()
            assert call["read"](component, bytes_, size, byref(restore)) == OK
        assert call["set"](component, restore) == OK
        unit.step(component, 0.1, 0.1)
        assert np.array_equal(unit.get(component, unit.states), after)
    assert call["read"](component, bytes_, c_size_t(size.value - 1), byref(restore)) == ERROR
    # What another unit wrote, of the same size and with other equations: its token stands before its numbers.
    other = ctypes.create_string_buffer(bytes_.raw.replace(unit.token.encode(), b"{0123456789abcdef-0123456789abcdef}"), size.value)
    assert other.raw != bytes_.raw
    unit.messages.clear()
    fresh = c_void_p()
    assert call["read"](component, other, size, byref(fresh)) == ERROR and not fresh.value
    assert [b"these bytes are no state of this unit" in text for _, text in unit.messages] == [True]
    assert call["read"](component, other, size, byref(restore)) == ERROR  # nor is a state that is there touched
    assert call["set"](component, restore) == OK
    unit.step(component, 0.1, 0.1)
    assert np.array_equal(unit.get(component, unit.states), after)
    assert call["free"](component, byref(state)) == OK and not state.value
    call["free"](component, byref(restore))
    unit.FreeInstance(component)


def test_parameters_can_be_tuned(unit, mechanism):
    names = [v["name"] for v in unit.variables if v["causality"] == "parameter"]
    if not names:
        pytest.skip("no run-time parameters")
    component = unit.initialised(MODEL_EXCHANGE)
    before = unit.get(component, [*unit.derivatives, "energy.total"])
    values = unit.get(component, names) * np.linspace(1.3, 1.1, len(names))  # moments of matter stay such
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
    for kind in (CO_SIMULATION, MODEL_EXCHANGE):  # FMI 2.0.4, 2.1.5 and FMI 3.0, 2.3.1: the name is not empty
        unit.messages.clear()
        assert unit.instantiate(kind, name=b"") is None
        assert [text.split(b": ")[1] for _, text in unit.messages] == [b"an instance has a name"]
    component = unit.instantiate(CO_SIMULATION)
    assert unit.step(component, 0, 0.1) == ERROR
    assert unit.EnterEventMode(component) == ERROR
    unit.FreeInstance(component)
    component = unit.initialised(CO_SIMULATION)
    assert unit.set(component, [unit.states[0]], [0.0]) == ERROR  # states start, and then move
    assert unit.set(component, [10**6], [0.0]) == ERROR
    unit.messages.clear()
    assert unit.step(component, 5, 0.1) == ERROR
    assert [text for _, text in unit.messages] == [f"fmi{unit.version}DoStep: another time than that reached".encode()]
    assert unit.step(component, 0, -0.1) == ERROR
    unit.FreeInstance(component)


def test_derivatives_follow_what_is_set_and_parameters_wait_for_events(unit):
    component = unit.continuous()
    before = unit.get(component, unit.derivatives)
    inputs = [v["name"] for v in unit.variables if v["causality"] == "input"]
    assert unit.set(component, inputs, np.ones(len(inputs))) == OK
    assert np.array_equal(unit.get(component, unit.derivatives), before) == (not inputs)
    tuned = [v["name"] for v in unit.variables if v["causality"] == "parameter"][:1]
    assert unit.set(component, tuned, [2.0] * len(tuned)) == (ERROR if tuned else OK)
    assert unit.EnterEventMode(component) == OK
    assert unit.set(component, tuned, [2.0] * len(tuned)) == OK
    unit.FreeInstance(component)


def test_steps_of_any_length_follow_each_other(unit):
    """What a step far below the others leaves is no step size of theirs."""
    component, time = unit.initialised(CO_SIMULATION), 0.0
    for size in (1e-300, 1e-16, 0.01, 1e-17, 1e-15, 0.02):
        assert unit.step(component, time, size) == OK, size
        time += size
    other = unit.initialised(CO_SIMULATION)
    assert unit.step(other, 0.0, time) == OK
    # The tolerance is 1e-10 where an importer gives none; errors of two motions differ by some of it.
    np.testing.assert_allclose(unit.get(component, unit.states), unit.get(other, unit.states), rtol=0, atol=1e-8)
    unit.FreeInstance(component)
    unit.FreeInstance(other)


def test_no_step_goes_beyond_the_stop_time(unit):
    component = unit.instantiate(CO_SIMULATION)
    assert unit.initialise(component, stop=0.3) == OK
    assert unit.ExitInitializationMode(component) == OK
    assert unit.step(component, 0, 0.2) == OK
    unit.messages.clear()
    assert unit.step(component, 0.2, 0.2) == ERROR
    assert b"a step beyond the stop time" in unit.messages[0][1]
    assert unit.step(component, 0.2, 0.1) == OK
    unit.FreeInstance(component)


def test_refuses_ways_of_fmi_3_that_it_does_not_have(unit):
    if unit.version == 2:
        pytest.skip("FMI 2.0")
    assert unit.instantiate(CO_SIMULATION, events=True) is None
    assert unit.instantiate(CO_SIMULATION, intermediate=1) is None
    component = unit.initialised(CO_SIMULATION)
    for call in ("EnterStepMode", "EnterConfigurationMode", "ExitConfigurationMode"):
        assert getattr(unit, call)(component) == ERROR
    count = c_size_t(7)
    assert unit.GetNumberOfContinuousStates(component, byref(count)) == OK and count.value == unit.n
    assert unit.GetNumberOfEventIndicators(component, byref(count)) == OK and count.value == 0
    unit.step(component, 0, 0.25)
    assert unit.get(component, ["time"]) == 0.25
    unit.FreeInstance(component)
