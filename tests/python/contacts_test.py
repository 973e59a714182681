# SPDX-License-Identifier: GPL-3.0-or-later
"""Motions from event to event of contacts, against closed forms: docs/contacts.md."""

import csv
import os
import subprocess

import numpy as np
import pytest

import torsor
from conftest import SOURCES, scene

R, G, F, V, H = 0.028575, 9.81, 0.2, 2.0, 0.1  # of the example billiard; H is a height to fall from
EXACT = {"relative_tolerance": 1e-13, "absolute_tolerance": 1e-13}


@pytest.fixture(scope="module")
def ball():
    """Struck in its middle on a cloth."""
    return scene("billiard", "--kernels", "mass_matrix,bias,energy,contacts,contact_coefficients")


def falling(ball):
    """The ball above the cloth, at rest."""
    _, q, v = ball.initial_state()
    q[2] = R + H
    return q, np.zeros_like(v)


def test_contacts_are_described(ball):
    assert dict(ball.contact_descriptions) == {"cloth": torsor.Contact("m", "N", 3)}
    assert ball.methods == ("dormand_prince_54", "dormand_prince_853", "radau_iia_5")


@pytest.mark.parametrize("method", ["dormand_prince_54", "dormand_prince_853", "radau_iia_5"])
def test_a_ball_slides_then_rolls(ball, method):
    end = 2 * V / (7 * F * G)
    motion = ball.simulate([0.5 * end, 2 * end], method=method, **EXACT)
    # 1e-13 a step; events are located to rounding.
    np.testing.assert_allclose(motion.q[:, 0], [V * end / 2 - F * G * end**2 / 8, V * end - F * G * end**2 / 2 + 5 / 7 * V * end],
                               atol=1e-11)
    np.testing.assert_allclose(motion.v[:, 0], [V - F * G * end / 2, 5 / 7 * V], atol=1e-11)
    assert motion.regimes.tolist() == [[2], [1]]
    (event,) = motion.events
    assert (event.kind, event.contact, dict(event.regimes)) == ("slip ends", "cloth", {"cloth": "sticks"})
    assert abs(event.time - end) < 1e-11 and event.energy_lost == 0 and not event.impulses["cloth"].any()
    # Friction takes 2/7 of the energy of a ball that slides; rolling takes nothing.
    assert motion.energy[1] < motion.energy[0] < motion.energy[1] / (1 - 2 / 7)


def test_bounces_come_to_an_end(ball):
    """With e = 1/2: impacts at T, 2 T, 2.5 T and so on, T the time of the first fall, which tend to 3 T."""
    e, fall = 0.5, np.sqrt(2 * H / G)
    motion = ball.simulate([1.5 * fall, 4 * fall], *falling(ball), parameters={"e": e}, **EXACT)
    *impacts, last = motion.events
    assert {event.kind for event in impacts} == {"impact"} and len(impacts) > 10
    np.testing.assert_allclose([event.time for event in impacts[:8]], 3 * fall - 2 * fall * e ** np.arange(8), atol=1e-10)
    speeds = np.sqrt(2 * G * H) * e ** np.arange(8)
    np.testing.assert_allclose([event.before[9] for event in impacts[:8]], -speeds, atol=1e-9)
    np.testing.assert_allclose([event.after[9] for event in impacts[:8]], e * speeds, atol=1e-9)
    # P = m (1 + e) w and m w^2 (1 - e^2)/2 lost.
    np.testing.assert_allclose([event.energy_lost / event.impulses["cloth"][0] for event in impacts[:8]],
                               (1 - e) / 2 * speeds, atol=1e-9)
    assert last.kind == "accumulation" and abs(last.time - 3 * fall) < 1e-9
    np.testing.assert_allclose(motion.q[:, 2], [R + H * e**2, R], atol=1e-10)
    assert motion.regimes[0, 0] == 0 and motion.regimes[1, 0] != 0


def test_many_motions_have_their_own_events(ball):
    q, v = falling(ball)
    places = np.stack([ball.initial_state().q, q])
    speeds = np.stack([ball.initial_state().v, v])
    for threads in (1, 2):
        many = ball.simulate([0.4, 0.8], places, speeds, threads=threads)
        assert many.ok.all() and many.regimes.shape == (2, 2, 1) and many.events.shape == (2,)
        for k in range(2):
            alone = ball.simulate([0.4, 0.8], places[k], speeds[k])
            assert np.array_equal(many.states[k], alone.states)
            assert [(event.kind, event.time) for event in many.events[k]] == [(event.kind, event.time) for event in alone.events]
    assert [[event.kind for event in events] for events in many.events] == [["slip ends"], ["impact"]]


def test_one_that_cannot_begin_harms_no_other(ball):
    q, v = falling(ball)
    low = q.copy()
    low[2] = R / 2
    with pytest.raises(torsor.TorsorError, match="starts below its surface; contact cloth"):
        ball.simulate(1.0, low, v)
    many = ball.simulate([0.5], np.stack([low, q]), v)
    assert many.ok.tolist() == [False, True] and np.isnan(many.states[0]).all() and many.regimes.tolist() == [[[-1]], [[1]]]
    with pytest.raises(ValueError, match="contact 'cloth' has the restitution e = 2: it must lie between 0 and 1; .* with e=2:"):
        ball.simulate(1.0, parameters={"e": 2.0})


def test_a_friction_that_is_no_number_is_no_surface(ball):
    """Not below zero, so that no parameter is refused; the motion says it, and which contact."""
    floor = scene("worn_floor", "--kernels", "mass_matrix,bias,energy,constraints,contacts,contact_coefficients")
    assert floor.simulate([0.1]).q[0, 0] > 0
    with pytest.raises(torsor.TorsorError, match="a contact's rule is impossible|coefficients that no surface has") as raised:
        floor.simulate([0.1], parameters={"wear": 0.0})
    assert "contact floor" in str(raised.value)


def test_refuses_what_makes_no_sense(ball):
    with pytest.raises(ValueError, match="no impact law 'glued'; there are newton_moreau"):
        ball.simulate(1.0, impact_law="glued")
    with pytest.raises(ValueError, match="no method 'midpoint'; there are dormand_prince_54, dormand_prince_853, radau_iia_5"):
        ball.simulate(1.0, method="midpoint", step=0.1)
    for times in ([1.0, 0.5], [-1.0]):
        with pytest.raises(ValueError, match="times: with contacts a motion goes forward in time"):
            ball.simulate(times)
    with pytest.raises(ValueError, match="times: array must not contain infs or NaNs"):
        ball.simulate(float("inf"))
    few = scene("billiard", "--kernels", "mass_matrix,bias,energy,contacts")
    with pytest.raises(ValueError, match="build it with mass_matrix, bias, contacts, contact_coefficients$"):
        few.simulate(1.0)
    assert few.energy(*falling(few)).kinetic == 0


def test_a_robot_lands_on_its_feet():
    """Motors hold a crouch as springs do: they are at rest in it, so that the robot falls as one body."""
    robot = scene("quadruped_on_its_feet", "--kernels", "mass_matrix,bias,forward_dynamics,energy,contacts,contact_coefficients")
    crouch = np.array([0.0, 0.7, -1.4] * 4)
    start = robot.initial_state()
    with pytest.raises(RuntimeError, match="no torque today"):
        robot.simulate([0.2], inputs=failing)
    motion = robot.simulate([0.3], inputs=lambda t, q, v: 60 * (crouch - q[7:]) - 2 * v[6:], relative_tolerance=1e-10,
                            absolute_tolerance=1e-10)
    gaps = robot.contacts(start.q, start.v).gap
    impact = motion.events[0]
    # 1e-10 a step, over some twenty steps.
    assert impact.kind == "impact" and abs(impact.time - np.sqrt(2 * gaps.min() / G)) < 1e-8
    assert set(impact.regimes) == set(robot.contact_descriptions) and "open" not in impact.regimes.values()
    with pytest.raises(ValueError, match="project: False does nothing with contacts"):
        robot.simulate(0.1, project=False)
    energies = [robot.energy(y[:19], y[19:]).kinetic for y in (impact.before, impact.after)]
    assert abs(impact.energy_lost - (energies[0] - energies[1])) < 1e-12 * energies[0] * 100  # rounding of some hundred terms
    assert min(impulse[0] for impulse in impact.impulses.values()) > 0
    assert (motion.regimes[-1] == 1).all()  # they stick, and hold it where it is
    np.testing.assert_allclose(robot.contacts(motion.q[-1], motion.v[-1]).rate, 0.0, atol=1e-12)


def failing(t, q, v):
    raise RuntimeError("no torque today")


def test_joints_that_rub_move_as_the_evaluated_scene():
    """The generated header against `simulate`, which evaluates the scene's formulas: two joints, one of them pressed in two
    directions, and accelerations that press both."""
    file = os.path.join(SOURCES, "tests/python/trolley.cpp")
    car = torsor.load(file, flags="-O0", kernels=["mass_matrix", "bias", "energy", "contacts", "contact_coefficients"])
    table = subprocess.run([os.environ["TORSOR"], file, "simulate", "--to=1.5", "--step=0.25", "--tolerance=1e-13"],
                           capture_output=True, text=True, check=True).stdout
    names, *rows = csv.reader(line for line in table.splitlines() if not line.startswith("#"))
    rows = np.array(rows, float)
    wanted = np.column_stack([rows[1:, names.index(name)] for name in ("x", "a", "x'", "a'")])
    motion = car.simulate(rows[1:, names.index("time")], **EXACT)
    # 1e-13 a step of both, some hundred steps.
    np.testing.assert_allclose(np.hstack([motion.q, motion.v]), wanted, atol=1e-10)
    assert motion.energy[-1] < motion.energy[0] - 1
