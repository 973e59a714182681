# SPDX-License-Identifier: GPL-3.0-or-later
"""Where motions start when parameters are set: as the scene says with them, and on its constraints. A bead on a ring has one
mass in all directions, so that the nearest place on the ring lies on the ray from its centre."""

import pickle

import numpy as np
import pytest

import torsor

from conftest import scene
from fmi_importer import CO_SIMULATION, DISCARD, ERROR, MODEL_EXCHANGE, OK, Unit2, Unit3

KERNELS = ("--kernels", "mass_matrix,forward_dynamics,energy,constraints,linearisation")


@pytest.fixture(scope="module")
def bead():
    return scene("ring", "--run-time", "all", *KERNELS)


@pytest.fixture(scope="module", params=[Unit2, Unit3], ids=["2", "3"])
def unit(request, tmp_path_factory):
    return request.param("ring", tmp_path_factory.mktemp("ring"), "--flags=-O0", "--run-time", "all")


def on_ring(x, z, radius):
    return np.array([x, z]) * radius / np.hypot(x, z)


def close(found, expected):
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-15 * 4)  # some roundings of lengths below 1 m


@pytest.mark.parametrize("method", ["dormand_prince_54", "dormand_prince_853", "radau_iia_5", "midpoint"])
def test_a_start_off_the_constraints_is_put_on_them(bead, method):
    """Before its first step, so that every method goes on from the same state."""
    x, z = on_ring(0.4, -0.1, 0.8)
    step = 1e-3 if method in ("runge_kutta_4", "midpoint") else None
    options = {"method": method, "step": step, "parameters": {"l": 0.8}}
    motion = bead.simulate([0.0, 0.3], [0.4, 2.0, -0.1], **options)
    close(motion.q[0], [x, 2.0, z])
    np.testing.assert_array_equal(motion.q, bead.simulate([0.0, 0.3], motion.q[0], **options).q)
    np.testing.assert_array_equal(motion.q[0], bead.simulate([0.0], motion.q[0], **options).q[0])  # rounding is left alone


def test_what_is_linearised_is_the_start_of_the_motion(bead):
    """Not the scene's start, from which the stretched ring is away."""
    parameters = {"stretch": 1.6}
    found = bead.linearise(parameters=parameters)
    expected = bead.linearise(bead.simulate([0.0], parameters=parameters).q[0], parameters=parameters)
    for one, other, of_scene in zip(found, expected, bead.linearise(bead.initial_state().q, parameters=parameters)):
        np.testing.assert_array_equal(one, other)
    assert not np.array_equal(of_scene, other)


def test_a_parameter_without_a_value_is_asked_for_by_name():
    """It is no number: calls would give none, and say that the equations are singular."""
    mass = scene("unvalued", "--run-time", "all", "--kernels", "mass_matrix,forward_dynamics,energy")
    again = pickle.loads(pickle.dumps(mass))
    for one in (mass, again, mass.with_parameters(k=2), pickle.loads(pickle.dumps(mass.with_parameters(k=2)))):
        assert np.isnan(one.parameters["m"])
        for call in (one.initial_state, lambda: one.simulate(1.0), lambda: one.simulate(1.0, parameters={"k": 3}),
                     lambda: one.mass_matrix([1.0]), lambda: one.mass_matrix(np.ones((3, 1)))):
            with pytest.raises(ValueError, match=r"unvalued: the parameter 'm' has no value: .*with_parameters\(m=\.\.\.\)"):
                call()
        assert one.mass_matrix([1.0], parameters={"m": 2}) == 2
    heavy = pickle.loads(pickle.dumps(mass.with_parameters(m=3)))
    assert heavy.mass_matrix([1.0]) == 3 and heavy.parameters["k"] == 8


def test_a_start_that_no_constraint_can_be_met_from_is_refused(bead):
    with pytest.raises(torsor.TorsorError, match="the loops cannot be closed near the start"):
        bead.simulate([0.0, 0.3], [0.0, 1.0, 0.0])  # the centre is as far from all of the ring
    motion = bead.simulate([0.0, 0.3], [[0.0, 1.0, 0.0], [0.5, 1.0, 0.0]])
    assert list(motion.ok) == [False, True] and np.isnan(motion.q[0]).all()


def test_constraints_that_nothing_holds_are_told(monkeypatch):
    """Without the mass matrix a motion would leave the ring unseen."""
    bare = scene("ring", "--kernels", "forward_dynamics,energy")
    with pytest.raises(ValueError, match="build it with mass_matrix, constraints, or give project=False"):
        bare.simulate(0.1)
    assert bare.simulate(0.1, project=False).ok
    monkeypatch.setattr(bare, "_kernels_of_motion", list)  # the library says it itself, to others than Python
    with pytest.raises(torsor.TorsorError, match="the method does not suit the model"):
        bare.simulate(0.1)


def state_of(unit, component):
    return unit.get(component, ["q.x", "q.y", "q.z"])


@pytest.mark.parametrize("kind", [CO_SIMULATION, MODEL_EXCHANGE])
@pytest.mark.parametrize("late", [False, True])
def test_starts_of_units_follow_parameters(unit, kind, late):
    component = unit.instantiate(kind)
    if late:
        assert unit.initialise(component) == OK
    assert unit.set(component, ["parameter.l"], [0.8]) == OK
    if not late:
        assert unit.initialise(component) == OK
    close(state_of(unit, component), [0.48, 1, -0.64])
    # What the importer sets stays, whatever is set afterwards.
    assert unit.set(component, ["q.x"], [0.35]) == OK
    assert unit.set(component, ["parameter.l"], [1.0]) == OK
    close(state_of(unit, component), [0.35, 1, -0.8])
    assert unit.Reset(component) == OK and unit.initialise(component) == OK
    close(state_of(unit, component), [0.3, 1, -0.4])
    unit.FreeInstance(component)


def test_descriptions_tell_which_starts_follow(unit):
    by_name = {v["name"]: v for v in unit.variables}
    initial = {name: by_name[name].get("initial") for name in ("q.x", "q.y", "q.z", "v.x")}
    assert initial == {"q.x": "approx", "q.y": "exact", "q.z": "approx", "v.x": "exact"}
    first = unit.initial_unknowns[:3]
    assert first == [unit.reference["q.x"], unit.reference["q.z"], unit.derivatives[0]]
    # At the start the height is no known: what is a function of it depends on all.
    potential = unit.reference["energy.potential"]
    assert unit.dependencies(initially=True)[potential] is None and unit.reference["q.z"] in unit.dependencies()[potential]


@pytest.mark.parametrize("kind", [CO_SIMULATION, MODEL_EXCHANGE])
def test_units_start_on_their_constraints(unit, kind):
    component = unit.instantiate(kind)
    assert unit.set(component, ["q.x", "q.z", "parameter.l"], [0.4, -0.1, 0.8]) == OK
    assert unit.initialise(component) == OK and unit.ExitInitializationMode(component) == OK
    if kind == MODEL_EXCHANGE:
        assert unit.update(component) and not unit.update(component)
    x, z = on_ring(0.4, -0.1, 0.8)
    close(state_of(unit, component), [x, 1, z])
    unit.FreeInstance(component)


@pytest.mark.parametrize("kind", [CO_SIMULATION, MODEL_EXCHANGE])
def test_units_close_constraints_of_any_size(unit, kind):
    """No numbers near a place meet them better than a rounding of the largest: of a radius of the Earth that is 1e-9 m."""
    component = unit.instantiate(kind)
    assert unit.set(component, ["q.x", "q.z", "parameter.l"], [3.1e6, -5.3e6, 6371000.7]) == OK
    assert unit.initialise(component) == OK and unit.ExitInitializationMode(component) == OK
    if kind == MODEL_EXCHANGE:
        unit.update(component)
    x, z = on_ring(3.1e6, -5.3e6, 6371000.7)
    np.testing.assert_allclose(state_of(unit, component), [x, 1, z], rtol=4e-16)
    unit.FreeInstance(component)


def test_units_move_where_a_constraint_vanishes_all_along(tmp_path):
    """Bennett's linkage: of an equation that is rounding there is neither a direction nor a residual."""
    linkage = Unit3("bennett", tmp_path, "--flags=-O1")
    component = linkage.initialised(CO_SIMULATION, tolerance=1e-9)
    energy = sum(linkage.get(component, ["energy.kinetic", "energy.potential"]))
    for k in range(4):
        assert linkage.step(component, 0.1 * k, 0.1) == OK
        first, second, third = linkage.get(component, ["q.first", "q.second", "q.third"])
        np.testing.assert_allclose(np.tan(first / 2) * np.tan(second / 2), np.sqrt(3), rtol=1e-8)
        np.testing.assert_allclose(third, -first, rtol=1e-8)
        np.testing.assert_allclose(sum(linkage.get(component, ["energy.kinetic", "energy.potential"])), energy, rtol=1e-6)
    assert abs(first - 0.7) > 0.1
    linkage.FreeInstance(component)


@pytest.mark.parametrize("kind", [CO_SIMULATION, MODEL_EXCHANGE])
def test_units_go_on_from_constraints_that_a_parameter_moves(unit, kind):
    component = unit.initialised(kind)
    if kind == MODEL_EXCHANGE:
        assert not unit.update(component)
        assert unit.set(component, ["parameter.l"], [0.8]) == OK
        assert unit.update(component)
        close(state_of(unit, component), [0.48, 1, -0.64])
    else:
        assert unit.step(component, 0.0, 0.1) == OK
        begin = state_of(unit, component)
        assert unit.set(component, ["parameter.l"], [0.8]) == OK
        assert unit.step(component, 0.1, 1e-9) == OK
        x, z = on_ring(begin[0], begin[2], 0.8)
        # It moves on at some 3 m/s at most for 1e-9 s.
        np.testing.assert_allclose(state_of(unit, component), [x, 1, z], rtol=0, atol=3e-9)
    unit.FreeInstance(component)


@pytest.mark.parametrize("kind", [CO_SIMULATION, MODEL_EXCHANGE])
def test_units_refuse_a_start_that_no_constraint_can_be_met_from(unit, kind):
    component = unit.instantiate(kind)
    assert unit.set(component, ["q.x", "q.z"], [0.0, 0.0]) == OK and unit.initialise(component) == OK
    unit.messages.clear()
    answer = unit.ExitInitializationMode(component)
    if kind == MODEL_EXCHANGE:
        assert answer == OK
        with pytest.raises(AssertionError):
            unit.update(component)
    else:
        assert answer == ERROR
    assert [text.split(b": ")[1] for _, text in unit.messages] == [b"no state near this one meets the constraints"]
    unit.FreeInstance(component)


@pytest.mark.parametrize("kind", [CO_SIMULATION, MODEL_EXCHANGE])
def test_units_refuse_a_mass_that_no_body_has(unit, kind):
    """Where a motion begins and where it goes on, not where one parameter is set: others may follow."""
    said = b"body 'bead' has the mass m = -2 kg: a mass is never negative"
    component = unit.instantiate(kind)
    assert unit.set(component, ["parameter.m"], [-2.0]) == OK and unit.initialise(component) == OK
    assert unit.set(component, ["parameter.m"], [2.0]) == OK and unit.ExitInitializationMode(component) == OK
    if kind == MODEL_EXCHANGE:
        assert not unit.update(component)
    else:
        assert unit.step(component, 0.0, 0.1) == OK
    assert unit.set(component, ["parameter.m"], [-2.0]) == OK
    with pytest.raises(AssertionError):
        unit.get(component, ["der(v.z)"])
    unit.messages.clear()
    if kind == MODEL_EXCHANGE:
        with pytest.raises(AssertionError):
            unit.update(component)
    else:
        assert unit.step(component, 0.1, 0.1) == DISCARD
    assert [text.split(b": ", 1)[1].startswith(said) for _, text in unit.messages] == [True]
    assert unit.Reset(component) == OK and unit.set(component, ["parameter.m"], [-2.0]) == OK
    unit.messages.clear()
    assert unit.initialise(component) == OK
    if kind == CO_SIMULATION:
        assert unit.ExitInitializationMode(component) == ERROR and said in unit.messages[0][1]
    unit.FreeInstance(component)


def test_calls_refuse_parameters_that_no_mechanism_has(bead):
    pattern = r"ring: body 'bead' has the mass m = -2 kg: a mass is never negative; .*; that is so with m=-2: give another value"
    for call in (lambda: bead.with_parameters(m=-2), lambda: bead.simulate([0.1], parameters={"m": -2}),
                 lambda: bead.energy(np.ones(3), np.ones(3), parameters={"m": -2})):
        with pytest.raises(ValueError, match=pattern):
            call()
    assert bead.mass_matrix(np.ones(3), parameters={"m": 0})[0, 0] == 0  # an energy may be asked for
    assert list(bead.kernels) == ["mass_matrix", "forward_dynamics", "energy", "constraints", "linearisation", "state_derivative"]
