# SPDX-License-Identifier: GPL-3.0-or-later
"""States of units with contacts in which accelerations have no derivatives by some variables, or by none: the unit says which."""

from ctypes import c_size_t

import numpy as np
import pytest

from fmi_importer import CO_SIMULATION, DISCARD, OK, Unit2, Unit3, doubles, exchanged


@pytest.fixture(scope="module", params=(Unit2, Unit3), ids=("2", "3"))
def parts(request, tmp_path_factory):
    return request.param("rubbing_parts", tmp_path_factory.mktemp("rubbing_parts"), "--flags=-O0")


@pytest.fixture
def begun(parts):
    """An instance that is initialised, where every variable can be set."""
    component = parts.instantiate(CO_SIMULATION)
    assert parts.initialise(component, 0.0, 1e-12) == OK
    yield component
    parts.FreeInstance(component)


def directional(unit, component, unknown, known, seed=(1.0,)):
    pointer, found = doubles(np.full(len(unknown), np.nan))
    answer = unit.directional(component, unknown, known, seed, pointer)
    return answer, found


def refusal(unit, component, unknown="der(v.x)", known="q.x"):
    unit.messages.clear()
    assert directional(unit, component, [unknown], [known])[0] == DISCARD
    (_, said), = unit.messages
    return said.decode()


def test_a_parameter_without_a_slope_spoils_no_other_derivative(parts, begun):
    """-k/m, whatever the friction sqrt(p)/2 would do along p."""
    for known, seed in ((["q.x"], [1.0]), (["q.x", "parameter.p"], [1.0, 0.0])):
        answer, found = directional(parts, begun, ["der(v.x)"], known, seed)
        assert answer == OK
        np.testing.assert_allclose(found, [-1.5], rtol=1e-14)
    if parts.version == 3:
        pointer, found = doubles(np.zeros(2))
        assert parts.adjoint(begun, ["der(v.x)", "der(v.turn)"], ["q.x", "v.turn"], [1.0, 0.0], pointer) == OK
        np.testing.assert_allclose(found, [-1.5, 0.0], rtol=1e-14, atol=1e-15)


def test_a_derivative_that_is_no_number_is_refused(parts, begun):
    said = refusal(parts, begun, known="parameter.p")
    assert said.endswith(": a derivative is not a finite number in this state")
    if parts.version == 3:
        parts.messages.clear()
        assert parts.adjoint(begun, ["der(v.x)"], ["q.x", "parameter.p"], [1.0], doubles(np.zeros(2))[0]) == DISCARD
        (_, said), = parts.messages
        assert said.endswith(b": a derivative is not a finite number in this state")
    assert parts.set(begun, ["parameter.p"], [0.25]) == OK
    answer, found = directional(parts, begun, ["der(v.x)"], ["parameter.p"])
    assert answer == OK
    np.testing.assert_allclose(found, [-10 / (4 * 0.5)], rtol=1e-14)


def test_feet_that_share_a_weight_have_no_derivatives(parts, begun):
    assert parts.set(begun, ["q.height"], [0.0]) == OK
    assert refusal(parts, begun).endswith(
        ": derivatives of accelerations are not given where reactions are not unique; contact 'left'")


def test_a_joint_that_carries_nothing_has_no_derivatives(parts, begun):
    assert directional(parts, begun, ["der(v.turn)"], ["v.turn"])[0] == OK
    assert parts.set(begun, ["parameter.e"], [0.0]) == OK
    assert refusal(parts, begun).endswith(
        ": derivatives of accelerations are not given where friction is in proportion to a joint's reaction, and that is zero; "
        "contact 'journal'")


def near_a_jam(unit, angle):
    """An importer has turned the arm to where the belt, which pushes its tip with f N, all but turns it as much as N does."""
    component = exchanged(unit, ["parameter.f"], [0.5])
    state = unit.state(component)
    # The tip, at (0.375, 0, -0.5) m before, comes to x/|z| = f.
    state[unit.states.index(unit.reference["q.swing"])] = np.arctan2(0.375 - 0.5 * 0.5, 0.5 + 0.5 * 0.375) - angle
    assert unit.SetContinuousStates(component, doubles(state)[0], c_size_t(unit.n)) == OK
    return component


@pytest.mark.parametrize("angle", [1e-9, -1e-9, 1e-11, -1e-11])
def test_equations_that_are_singular_but_for_rounding_have_no_derivatives(parts, angle):
    """The arm is held where it is, so that the true ones are 0; reactions change with the square of 1/angle."""
    component = near_a_jam(parts, angle)
    assert refusal(parts, component, "der(v.swing)", "q.swing").endswith(
        ": derivatives of accelerations are not given where the equations of the regimes are singular")
    parts.FreeInstance(component)


@pytest.mark.parametrize("angle", [1e-4, -1e-4])
def test_equations_near_a_jam_have_derivatives(parts, angle):
    component = near_a_jam(parts, angle)
    answer, found = directional(parts, component, ["der(v.x)", "der(v.swing)"], ["q.swing"])
    assert answer == OK
    np.testing.assert_allclose(found, [0.0, 0.0], atol=1e-16 / angle**2 * 100)  # roundings of changes of reactions
    parts.FreeInstance(component)
