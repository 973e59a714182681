# SPDX-License-Identifier: GPL-3.0-or-later
"""Derivatives of what units of FMI compute whose bodies touch: exact while regimes last, and refused where there are none."""

from ctypes import c_size_t

import numpy as np
import pytest

from fmi_importer import (CO_SIMULATION, DISCARD, ERROR, OK, assert_slopes_while_regimes_last, begun, doubles, exchanged)

R, G, F = 0.028575, 9.81, 0.2  # of the example billiard


@pytest.fixture
def unit(fmi_billiard):
    return fmi_billiard


@pytest.fixture
def cart(fmi_cart_with_stops):
    return fmi_cart_with_stops


def test_derivatives_of_what_contacts_have_no_part_in_are_slopes(unit):
    """Of rates of coordinates, energies and poses, along states and parameters."""
    component = unit.instantiate(CO_SIMULATION)
    assert unit.initialise(component, 0.0, 1e-12) == OK
    states = [unit.by_reference[k]["name"] for k in unit.states]
    generic = np.linspace(-0.9, 1.1, len(states))
    turn = [k for k, name in enumerate(states) if name.startswith("q.turn")]
    generic[turn] /= np.linalg.norm(generic[turn])
    rates = [f"der({name})" for name in states if name.startswith("q.")]
    unknown = rates + [unit.by_reference[k]["name"] for k in unit.outputs]
    known = states + [v["name"] for v in unit.variables if v["causality"] == "parameter"]
    assert unit.set(component, [*states, "parameter.e"], [*generic, 0.5]) == OK  # with room below: e < 0 is refused
    start = unit.get(component, known)
    rows, rotation = len(unknown), [k for k, name in enumerate(unknown) if "rotation" in name]
    for k in range(len(known)):
        h = 1e-5
        direction = np.zeros(len(known))
        if k in turn:  # along the unit quaternions, which alone are attitudes: across what it is
            direction[turn] = np.eye(len(known))[k][turn] - start[k] * start[turn]
        else:
            direction[k] = 1.0

        def at(step, along=direction):
            assert unit.set(component, known, start + step * along) == OK
            return unit.get(component, [name for name in unknown if not name.startswith("der(")])

        slope = (at(h) - at(-h)) / (2 * h)
        assert unit.set(component, known, start) == OK
        pointer, found = doubles(np.zeros(rows))
        assert unit.directional(component, unknown, known, direction, pointer) == OK
        # Central differences of functions of third derivatives below 100: h^2/6 of these, and roundings of 1e-15 over h.
        np.testing.assert_allclose(found[len(rates):], slope, rtol=0, atol=1e-8, err_msg=known[k])
        # x' = v_x, and of quaternions e' = e (0, w)/2: bilinear in the state, so that differences are exact.
        if known[k] == "v.x":
            np.testing.assert_array_equal(found[:len(rates)], [name == "der(q.x)" for name in rates])
    assert rotation
    assert unit.directional(component, ["indicator.cloth.opens_or_closes"], ["q.x"], [1.0], doubles(np.zeros(1))[0]) == ERROR
    unit.FreeInstance(component)


ATTITUDE = [f"q.turn_{k}" for k in "wxyz"]
ANY_ATTITUDE = np.array([0.7, -0.1, 0.5, 0.5]) / np.linalg.norm([0.7, -0.1, 0.5, 0.5])


def derivatives(unit, component, unknown, known):
    """A column for each known."""
    columns = []
    for name in known:
        pointer, found = doubles(np.zeros(len(unknown)))
        assert unit.directional(component, unknown, [name], [1.0], pointer) == OK
        columns.append(found)
    return np.transpose(columns)


def turning(unit):
    """Names of the components of the angular velocity."""
    return [v["name"] for v in unit.variables if v["name"].startswith("v.turn")]


def test_accelerations_of_a_flight_have_derivatives(unit):
    component = exchanged(unit, ["q.z", *ATTITUDE, *turning(unit)], [R + 0.1, *ANY_ATTITUDE, 3.0, -2.0, 5.0])
    assert_slopes_while_regimes_last(unit, component, ATTITUDE)
    np.testing.assert_allclose(derivatives(unit, component, ["der(v.x)", "der(v.z)"], ["parameter.g", "parameter.f", "v.x"]),
                               [[0, 0, 0], [-1, 0, 0]], rtol=0, atol=1e-15)
    unit.FreeInstance(component)


def test_accelerations_of_a_slip_have_derivatives(unit):
    """Friction turns with the slip, a point of the ball moves with its attitude, and both change with velocities."""
    component = exchanged(unit, ["v.x", "v.y", *ATTITUDE, *turning(unit)], [1.5, -0.7, *ANY_ATTITUDE, 3.0, -2.0, 5.0])
    assert_slopes_while_regimes_last(unit, component, ATTITUDE)
    unit.FreeInstance(component)


def test_accelerations_of_a_slip_have_derivatives_by_parameters(unit):
    """Of a ball that is struck in its middle: x'' = -f g, and it gains 5 f g/(2 R) of angular velocity."""
    component = exchanged(unit)
    found = derivatives(unit, component, ["der(v.x)", "der(v.z)", *[f"der({name})" for name in turning(unit)]],
                        [f"parameter.{name}" for name in ("f", "g", "m", "R", "e")])
    # Roundings of some ten terms, the largest of them 5 f g/(2 R^2) = 6000.
    np.testing.assert_allclose(found, [[-G, -F, 0, 0, 0], [0] * 5, [0] * 5,
                                       [2.5 * G / R, 2.5 * F / R, 0, -2.5 * F * G / R**2, 0], [0] * 5], rtol=1e-14, atol=1e-11)
    unit.FreeInstance(component)


def test_accelerations_of_a_roll_have_derivatives(unit):
    component = exchanged(unit)
    unit.integrated(component, 0.0, 1.0)
    assert_slopes_while_regimes_last(unit, component, ATTITUDE)
    # A ball that rolls is not accelerated, whatever it and its cloth are made of.
    found = derivatives(unit, component, ["der(v.x)", "der(v.y)", "der(v.z)"], [f"parameter.{name}" for name in ("f", "g", "m", "R")])
    np.testing.assert_allclose(found, 0.0, atol=1e-12)
    unit.FreeInstance(component)


def test_co_simulation_has_derivatives_of_the_same_regimes(unit):
    moved, run = begun(unit), exchanged(unit)
    assert unit.step(moved, 0.0, 0.25) == OK
    unit.integrated(run, 0.0, 0.25)
    unknown = [unit.by_reference[k]["name"] for k in unit.derivatives]
    known = [unit.by_reference[k]["name"] for k in unit.states] + ["parameter.f", "parameter.R"]
    found, other = derivatives(unit, moved, unknown, known), derivatives(unit, run, unknown, known)
    np.testing.assert_allclose(found, other, rtol=0, atol=1e-9 * np.abs(other).max())  # states differ by 1e-12 a step
    unit.FreeInstance(moved)
    unit.FreeInstance(run)


def test_a_slip_without_a_direction_has_no_derivatives(unit):
    """Where the importer has taken a slip to its end, and no event has said yet what follows."""
    component = exchanged(unit)
    ended = unit.state(component)
    ended[unit.states.index(unit.reference["v.x"])] = 0.0
    assert unit.SetContinuousStates(component, doubles(ended)[0], c_size_t(unit.n)) == OK
    unit.messages.clear()
    assert unit.directional(component, ["der(v.x)"], ["v.x"], [1.0], doubles(np.zeros(1))[0]) == DISCARD
    (_, said), = unit.messages
    assert said.endswith(b": derivatives of accelerations are not given where a slip begins or ends; contact 'cloth'")
    assert unit.directional(component, ["der(q.x)"], ["v.x"], [1.0], doubles(np.zeros(1))[0]) == OK
    unit.FreeInstance(component)


def test_a_state_that_an_event_changes_first_has_no_derivatives(unit):
    """A ball that strikes while it is initialised: what it does then depends on the state before through the impact."""
    component = initialised(unit, 1e-12, ["v.z"], [-1.0])
    unit.messages.clear()
    assert unit.directional(component, ["der(v.x)"], ["v.x"], [1.0], doubles(np.zeros(1))[0]) == DISCARD
    (_, said), = unit.messages
    assert said.endswith(b"derivatives of accelerations are not given where an event changes the state before it moves")
    assert unit.ExitInitializationMode(component) == OK and unit.step(component, 0.0, 0.1) == OK
    assert unit.directional(component, ["der(v.x)"], ["v.x"], [1.0], doubles(np.zeros(1))[0]) == OK
    unit.FreeInstance(component)


def initialised(unit, tolerance, names, values):
    """An instance while it is initialised: where regimes are decided, its state stays."""
    component = unit.instantiate(CO_SIMULATION)
    assert unit.initialise(component, 0.0, tolerance) == OK and unit.set(component, names, values) == OK
    return component


def test_an_impact_within_the_tolerance_is_an_event(unit):
    component = initialised(unit, 1e-4, ["v.z"], [-1e-6])
    unit.messages.clear()
    assert unit.directional(component, ["der(v.x)"], ["v.x"], [1.0], doubles(np.zeros(1))[0]) == DISCARD
    (_, said), = unit.messages
    assert said.endswith(b"derivatives of accelerations are not given where an event changes the state before it moves")
    unit.FreeInstance(component)


def test_a_start_that_is_put_on_its_surface_has_no_event(unit):
    """It starts 5e-11 m above the cloth, which counts as on it, with an attitude of another norm; the tolerance is smaller."""
    component = initialised(unit, 1e-12, ["q.z", *ATTITUDE], [R + 5e-11, *((1 + 1e-9) * ANY_ATTITUDE)])
    np.testing.assert_allclose(derivatives(unit, component, ["der(v.x)"], ["parameter.f", "parameter.g"]), [[-G, -F]], rtol=1e-9)
    unit.FreeInstance(component)


def test_accelerations_at_a_stop_have_derivatives(cart):
    for place in (0.0, 10.0):
        run = exchanged(cart, ["input.slide_force", "q.slide", "v.hinge"], [20.0, place, 0.7])
        columns = assert_slopes_while_regimes_last(cart, run, known=["input.slide_force"])
        of_cart = columns[cart.derivatives.index(cart.reference["der(v.slide)"])]
        assert (np.abs(of_cart).max() > 0.1) == (place == 0.0)  # it stays at its stop, whatever pushes
        cart.FreeInstance(run)
