# SPDX-License-Identifier: GPL-3.0-or-later
"""Units of FMI whose bodies touch: for co-simulation, from event to event, against closed forms."""

import subprocess
from ctypes import byref, c_void_p

import numpy as np
import pytest

from conftest import command
from fmi_importer import CO_SIMULATION, DISCARD, ERROR, MODEL_EXCHANGE, OK, Unit2, Unit3, doubles

R, G, F, V = 0.028575, 9.81, 0.2, 2.0  # of the example billiard


@pytest.fixture(scope="module", params=(Unit2, Unit3), ids=("2", "3"))
def unit(request, tmp_path_factory):
    return request.param("billiard", tmp_path_factory.mktemp("billiard"), "--flags=-O0", "--run-time", "all")


def begun(unit, names=(), values=()):
    component = unit.instantiate(CO_SIMULATION)
    assert component
    assert unit.initialise(component, 0.0, 1e-12) == OK
    assert unit.set(component, list(names), values) == OK
    assert unit.ExitInitializationMode(component) == OK
    return component


def test_is_for_co_simulation_alone(unit):
    assert unit.description.find("ModelExchange") is None
    assert unit.description.find("CoSimulation") is not None
    assert [name.split("/")[0] for name in unit.names] == ["modelDescription.xml", "binaries"]
    assert not [v["name"] for v in unit.variables if v["name"].startswith(("der(", "multiplier."))]
    assert not unit.outputs + unit.listed_derivatives + unit.initial_unknowns
    unit.messages.clear()
    assert unit.instantiate(MODEL_EXCHANGE) is None
    assert b"for co-simulation, not for model exchange" in unit.messages[0][1]


def test_has_no_value_of_what_is_not_described(unit):
    component = begun(unit)
    numbers = len([v for v in unit.variables if v["name"].startswith(("q.", "v."))])
    for reference in range(numbers, 2 * numbers):
        assert reference not in unit.reference.values()
        assert unit.get_numbers(component, unit.references([reference]), 1, doubles(np.zeros(1))[0]) == ERROR
    assert unit.directional(component, [numbers], [0], [1.0], doubles(np.zeros(1))[0]) == ERROR
    unit.FreeInstance(component)


def slid(t, f):
    """Place and velocity of a ball that is struck in its middle: it slides for 2 V/(7 f g), then rolls with 5/7 V."""
    end = 2 * V / (7 * f * G)
    at = min(t, end)
    return V * at - f * G * at**2 / 2 + 5 / 7 * V * (t - at), V - f * G * at


@pytest.mark.parametrize("f", [F, 0.35])
def test_a_ball_slides_then_rolls(unit, f):
    component = begun(unit, ["parameter.f"], [f])
    for k in range(20):
        assert unit.step(component, 0.05 * k, 0.05) == OK
        # 1e-12 a step; events are located to rounding.
        np.testing.assert_allclose(unit.get(component, ["q.x", "v.x"]), slid(0.05 * (k + 1), f), rtol=0, atol=1e-10)
        np.testing.assert_allclose(unit.get(component, ["q.z"]), R, rtol=0, atol=1e-14)
    unit.FreeInstance(component)


def test_bounces_come_to_an_end(unit):
    """From 0.1 m with e = 1/2: impacts at T, 2 T, 2.5 T and so on, T the time of the first fall, which tend to 3 T."""
    component = begun(unit, ["q.z", "v.x", "parameter.e"], [R + 0.1, 0.0, 0.5])
    fall = np.sqrt(2 * 0.1 / G)
    steps = [0.5 * fall, fall, 0.75 * fall, fall]
    heights = [0.075, 0.025, 0.00625, 0.0]  # on the way, at the tops of two flights, at rest
    time = 0.0
    for size, height in zip(steps, heights):
        assert unit.step(component, time, size) == OK
        time += size
        np.testing.assert_allclose(unit.get(component, ["q.z"]), R + height, rtol=0, atol=1e-10)
    assert np.abs(unit.get(component, ["v.z"])).max() < 1e-12
    unit.FreeInstance(component)


def test_a_law_that_no_surface_has_ends_the_motion(unit):
    component = begun(unit, ["parameter.e"], [2.0])
    unit.messages.clear()
    assert unit.step(component, 0, 0.1) == DISCARD
    assert b"the motion ends" in unit.messages[0][1]
    unit.FreeInstance(component)


def test_states_are_restored(unit):
    component = begun(unit)
    state, names = c_void_p(), ["q.x", "v.x", "q.turn_y", "parameter.f"]
    assert unit.step(component, 0, 0.25) == OK
    assert getattr(unit, unit.memory["get"])(component, byref(state)) == OK
    assert unit.step(component, 0.25, 0.25) == OK
    after = unit.get(component, names)
    assert unit.set(component, ["parameter.f"], [0.5]) == OK
    assert getattr(unit, unit.memory["set"])(component, state) == OK
    assert unit.step(component, 0.25, 0.25) == OK
    assert np.array_equal(unit.get(component, names), after)
    getattr(unit, unit.memory["free"])(component, byref(state))
    unit.FreeInstance(component)


def test_sources_alone_are_refused(tmp_path):
    said = subprocess.run([*command("billiard", "fmu", "--sources-only", "-o", tmp_path / "x.fmu")], capture_output=True, text=True,
                          check=False)
    assert said.returncode == 2 and "'billiard' has contacts" in said.stderr
