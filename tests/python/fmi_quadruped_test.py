# SPDX-License-Identifier: GPL-3.0-or-later
"""A robot with eighteen freedoms as a unit: afloat with its attitude by a quaternion, and falling onto its feet."""

import os

import numpy as np
import pytest

from conftest import scene
from fmi_importer import CO_SIMULATION, MODEL_EXCHANGE, OK, Unit2, Unit3, assert_slopes_while_regimes_last

# Both versions wrap the same code, which takes the compiler long.
KINDS = (Unit2, Unit3) if os.environ.get("TORSOR_LONG_TESTS") else (Unit3,)
OUTPUTS = ("--points", "front_left_foot", "--frames", "trunk,rear_right_foot")


@pytest.fixture(scope="module", params=KINDS, ids=lambda kind: f"{kind.version}")
def afloat(request, tmp_path_factory):
    return request.param("quadruped", tmp_path_factory.mktemp("quadruped"), "--flags=-O0", *OUTPUTS)


def torques(unit):
    inputs = [v["name"] for v in unit.variables if v["causality"] == "input"]
    return inputs, np.linspace(-1.0, 1.0, len(inputs))


def begun(unit, kind, tolerance):
    component = unit.instantiate(kind)
    assert unit.initialise(component, 0.0, tolerance) == OK
    names, values = torques(unit)
    assert unit.set(component, names, values) == OK
    assert unit.ExitInitializationMode(component) == OK
    return component


def assert_outputs(unit, component, mechanism, y):
    q, v = y[:19], y[19:]
    energy, frames, poses = mechanism.energy(q, v), mechanism.frames(q, v), mechanism.poses(q)
    wanted = [energy.kinetic, -energy.force_function, energy.kinetic - energy.force_function,
              *frames.front_left_foot_origin_position]
    names = [v["name"] for v in unit.variables if v["causality"] == "output"]
    turns = {name: value for name, value in zip(names, unit.get(component, names))}
    np.testing.assert_allclose([turns[name] for name in names[:6]], wanted, rtol=1e-13)
    # The trunk is the body that floats: its pose is the state.
    w, x, y_, z = q[3:7]
    np.testing.assert_allclose([turns[f"frame.trunk.{c}"] for c in "xyz"], q[:3], rtol=0, atol=1e-15)
    np.testing.assert_allclose([turns["frame.trunk.rotation[1,1]"], turns["frame.trunk.rotation[2,1]"], turns["frame.trunk.rotation[1,2]"]],
                               [1 - 2 * (y_**2 + z**2), 2 * (x * y_ + w * z), 2 * (x * y_ - w * z)], rtol=0, atol=1e-14)
    column = [np.linalg.norm(poses.origins[:, k] - [turns[f"frame.rear_right_foot.{c}"] for c in "xyz"])
              for k in range(poses.origins.shape[1])]
    assert min(column) < 1e-14  # one of the frames of the scene


def test_a_robot_afloat_reaches_the_state_of_the_runtime(afloat):
    mechanism = scene("quadruped", "--kernels", "forward_dynamics,energy,frames,poses", "--points", "front_left_foot")
    begin, (_, inputs) = mechanism.initial_state(), torques(afloat)
    moved, h = begun(afloat, CO_SIMULATION, 1e-14), 0.01
    for k in range(10):
        assert afloat.step(moved, h * k, h) == OK
    exchanged = begun(afloat, MODEL_EXCHANGE, 1e-12)
    assert not afloat.update(exchanged)
    assert afloat.EnterContinuousTimeMode(exchanged) == OK
    afloat.integrated(exchanged, 0.0, 0.1, tolerance=1e-13)
    own = mechanism.simulate([0.1], inputs=inputs, relative_tolerance=1e-14, absolute_tolerance=1e-14).states[0]
    for component in (moved, exchanged):
        y = afloat.get(component, afloat.states)
        # 1e-14 of 1 + |y| a step, 100 steps and less; errors grow by e in that time. scipy: 1e-13, some ten steps.
        np.testing.assert_allclose(y, own, rtol=1e-11, atol=1e-11)
        assert np.abs(own - np.concatenate([begin.q, begin.v])).max() > 0.1  # it moves
        assert_outputs(afloat, component, mechanism, y)
        afloat.FreeInstance(component)


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: f"{kind.version}")
def test_a_robot_falls_onto_its_feet_as_in_the_runtime(kind, tmp_path):
    unit = kind("quadruped_on_its_feet", tmp_path, "--flags=-O0", *OUTPUTS)
    robot = scene("quadruped_on_its_feet", "--kernels", "mass_matrix,bias,forward_dynamics,energy,contacts,contact_coefficients")
    _, inputs = torques(unit)
    component = begun(unit, CO_SIMULATION, 1e-12)
    count, h = 12, 0.02
    for k in range(count):
        assert unit.step(component, h * k, h) == OK
    motion = robot.simulate([h * count], inputs=inputs, relative_tolerance=1e-12, absolute_tolerance=1e-12)
    assert "impact" in [event.kind for event in motion.events]
    y = unit.get(component, unit.states)
    # 1e-12 of 1 + |y| a step, some hundred steps of both, whose errors grow tenfold on light legs that fold: 1e-9.
    np.testing.assert_allclose(y, motion.states[-1], rtol=1e-9, atol=1e-9)
    energy = robot.energy(y[:19], y[19:])
    np.testing.assert_allclose(unit.get(component, ["energy.kinetic", "energy.total"]),
                               [energy.kinetic, energy.kinetic - energy.force_function], rtol=1e-13)
    unit.FreeInstance(component)
    # With its feet on the ground: what they do is in the derivatives of accelerations, along places, velocities and torques.
    run = unit.instantiate(MODEL_EXCHANGE)
    assert unit.initialise(run, 0.0, 1e-12) == OK
    names, values = torques(unit)
    assert unit.set(run, [*names, *unit.states], [*values, *y]) == OK and unit.ExitInitializationMode(run) == OK
    unit.update(run)
    assert (motion.regimes[-1] != 0).sum() >= 2
    assert unit.EnterContinuousTimeMode(run) == OK
    attitude = [unit.by_reference[k]["name"] for k in unit.states[3:7]]
    assert_slopes_while_regimes_last(unit, run, attitude, names[:2])
    unit.FreeInstance(run)
