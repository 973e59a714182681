# SPDX-License-Identifier: GPL-3.0-or-later
"""Motions, linearisation, equilibria, modes."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import torsor

FIXED = {"midpoint", "runge_kutta_4", "gauss"}


def test_methods_agree_with_scipy(pendulum):
    q, v = np.array([1.0, 0.5]), np.zeros(2)
    motion = pendulum.simulate([0.5, 1.0], q, v, relative_tolerance=1e-12, absolute_tolerance=1e-12)
    by_scipy = solve_ivp(pendulum.ode(), (0.0, 1.0), np.concatenate([q, v]), method="DOP853", rtol=1e-12, atol=1e-12)
    # Both hold 1e-12 a step over some hundred steps, and errors grow by e^(3 t) at most.
    np.testing.assert_allclose(motion.states[-1], by_scipy.y[:, -1], atol=1e-8)
    for method in pendulum.methods:
        step = 1e-4 if method in FIXED else None
        other = pendulum.simulate([0.5, 1.0], q, v, method=method, step=step, relative_tolerance=1e-10, absolute_tolerance=1e-10)
        # Midpoint: h^2 / 24 times third derivatives of size 100.
        np.testing.assert_allclose(other.states, motion.states, atol=1e-5 if method == "midpoint" else 1e-7)


def test_energy_is_kept(pendulum):
    motion = pendulum.simulate(2.0)
    assert motion.times.shape == (1001,) and motion.q.shape == (1001, 2) and motion.energy.shape == (1001,)
    # 1e-9 a step over some hundred steps, of energies of some 20 J.
    np.testing.assert_allclose(motion.energy, motion.energy[0], atol=1e-5)


def test_start_time_is_that_of_laws_too(rod):
    """A torque that depends on time, from 2 s on, is the torque two seconds later from zero on."""
    q, v = np.array([0.3]), np.zeros(1)
    late = rod.simulate([2.5, 3.0], q, v, start_time=2.0, inputs=lambda t, q, v: [np.sin(3 * t)])
    early = rod.simulate([0.5, 1.0], q, v, inputs=lambda t, q, v: [np.sin(3 * (t + 2))])
    # Some 50 steps of errors up to 1e-9 each, and times rounded otherwise.
    np.testing.assert_allclose(late.states, early.states, rtol=0, atol=1e-7)
    at_zero = rod.simulate([0.5, 1.0], q, v, inputs=lambda t, q, v: [np.sin(3 * t)])
    assert np.abs(late.states - at_zero.states).max() > 0.1
    many = rod.simulate([2.5, 3.0], np.array([q, q]), v, start_time=np.array([2.0, 2.0]))
    assert np.array_equal(many.states[0], many.states[1])


def test_many_motions_are_each_alone(pendulum):
    q = np.array([[[0.1, 0.2], [0.3, 0.4], [2.0, 1.0]]])
    many = pendulum.simulate([0.3, 0.7], q, np.zeros(2), threads=2)
    assert many.q.shape == (1, 3, 2, 2) and many.ok.shape == (1, 3) and many.ok.all() and many.energy.shape == (1, 3, 2)
    for k in range(3):
        alone = pendulum.simulate([0.3, 0.7], q[0, k], np.zeros(2))
        assert np.array_equal(many.states[0, k], alone.states)


def test_constraints_are_held(hoop):
    motion = hoop.simulate([0.5, 1.0])
    rates = hoop.constraints(motion.q, motion.v).rate
    assert np.abs(rates).max() < 1e-12  # projected after each step, to rounding
    drifting = hoop.simulate([0.5, 1.0], project=False, method="runge_kutta_4", step=0.02)
    assert np.abs(hoop.constraints(drifting.q, drifting.v).rate).max() > 1e-9


def test_quaternions_keep_their_norm(body):
    motion = body.simulate([1.0, 5.0])
    np.testing.assert_allclose(np.linalg.norm(motion.q, axis=-1), 1.0, atol=4e-16)
    f = body.ode()
    y = np.stack([motion.states[0], motion.states[1]], axis=1)
    assert np.array_equal(f(0.0, y)[:, 1], f(0.0, y[:, 1]))


def test_inputs_held_and_by_a_law(panda):
    q = np.full(7, 0.1)
    u = panda.inverse_dynamics(q, np.zeros(7), np.zeros(7))
    still = panda.simulate([0.2], q, np.zeros(7), inputs=u)
    # Held by its own torques: unstable, but errors of rounding need seconds to grow by some e^(4 t).
    np.testing.assert_allclose(still.q[0], q, atol=1e-9)
    by_law = panda.simulate([0.2], q, np.zeros(7), inputs=lambda t, q, v: u)
    assert np.array_equal(by_law.states, still.states)

    # Of many motions each has its own: the second falls.
    both = panda.simulate([0.2], q, np.zeros(7), inputs=np.stack([u, np.zeros(7)]))
    assert np.array_equal(both.states[0], still.states)
    assert np.array_equal(both.states[1], panda.simulate([0.2], q, np.zeros(7), inputs=np.zeros(7)).states)
    assert np.abs(both.q[1] - q).max() > 1e-3

    def broken(t, q, v):
        raise RuntimeError("no torque today")

    with pytest.raises(RuntimeError, match="no torque today"):
        panda.simulate([0.2], q, np.zeros(7), inputs=broken)


def test_what_was_not_reached_is_no_number(pendulum):
    """One hangs at rest and needs few steps, the other swings through."""
    many = pendulum.simulate([0.01, 20.0], [[0.0, 0.0], [2.0, 1.0]], np.zeros(2), step_limit=60)
    assert list(many.ok) == [True, False]
    assert np.isfinite(many.states[0]).all() and np.isfinite(many.states[1, 0]).all()
    assert np.isnan(many.states[1, 1]).all()


def test_refuses_what_makes_no_sense(pendulum):
    with pytest.raises(ValueError, match="no method 'euler'; there are dormand_prince_54"):
        pendulum.simulate(1.0, method="euler")
    with pytest.raises(ValueError, match="give step="):
        pendulum.simulate(1.0, method="midpoint")
    with pytest.raises(ValueError, match="step: dormand_prince_853 chooses its own steps; leave it out, or .*midpoint"):
        pendulum.simulate(1.0, step=0.01)
    with pytest.raises(ValueError, match="infs or NaNs"):
        pendulum.simulate(1.0, [np.nan, 0.0])
    with pytest.raises(torsor.TorsorError, match="step limit"):
        pendulum.simulate(1.0, step_limit=3)
    with pytest.raises(torsor.TorsorError, match="unusable options"):
        pendulum.simulate(1.0, step_limit=-3)


def test_linearisation_is_the_slope(pendulum):
    q, v = np.array([0.4, -0.3]), np.array([0.2, 0.1])
    linear = pendulum.linearise(q, v)
    y, h, f = np.concatenate([q, v]), 1e-5, pendulum.ode()
    slopes = np.stack([(f(0, y + h * e) - f(0, y - h * e)) / (2 * h) for e in np.eye(4)], axis=1)
    # h^2/6 times third derivatives of size 100, and roundings of size 1e-15/h.
    np.testing.assert_allclose(linear.A, slopes, atol=1e-8)


def test_small_oscillations_of_a_double_pendulum(pendulum):
    """Equal masses and lengths: omega^2 = (2 -+ sqrt 2) g/l, undamped."""
    found = pendulum.equilibria(np.array([0.5, -0.4]))
    np.testing.assert_allclose(found.q, 0.0, atol=1e-9)
    modes = pendulum.modes(found.q)
    expected = np.sqrt((2 + np.array([-1, -1, 1, 1]) * np.sqrt(2)) * 9.81)
    np.testing.assert_allclose(modes.frequencies, expected, rtol=1e-9)  # eigenvalues of 4 x 4: some 1e-15, the angle 1e-9
    np.testing.assert_allclose(modes.damping, 0.0, atol=1e-9)


def test_equilibria_from_several_starts_are_distinct(pendulum):
    """Two rods hang or stand: four equilibria, of which these starts lead to three, one of them twice."""
    found = pendulum.equilibria_from([[0.3, -0.2], [3.0, 0.1], [-0.2, 0.1], [0.1, 3.2]])
    np.testing.assert_allclose([each.q for each in found], [[0, 0], [np.pi, 0], [0, np.pi]], atol=1e-9)
    with pytest.raises(torsor.TorsorError, match="from any of 1 starts"):
        pendulum.equilibria_from([[0.3, -0.2]], steps=1)


def test_one_coordinate_alone_has_vectors_and_matrices_too(rod):
    """m g l = 9.81 N m, I = 0.1 + 2 0.5^2 = 0.6 kg m^2: exact to a few roundings."""
    q = np.linspace(-1.0, 1.0, 5)[:, None]
    held = rod.inverse_dynamics(q, np.zeros(1), np.zeros(1))
    assert held.shape == (5, 1)
    np.testing.assert_allclose(held, 9.81 * np.sin(q), rtol=0, atol=1e-14)
    assert rod.mass_matrix(q).shape == (5, 1, 1) and rod.mass_matrix(q[0]).shape == (1, 1)
    assert rod.energy(q, q).kinetic.shape == (5,) and rod.energy(q[0], q[0]).kinetic.shape == ()
    assert rod.forward_dynamics(q, q).accelerations.shape == (5, 1)
    linear = rod.linearise(q[0], np.zeros(1))
    assert linear.K.shape == (1, 1) and linear.F.shape == (1,) and linear.A.shape == (2, 2) and linear.B.shape == (2, 1)
    found = rod.equilibria([0.2])
    np.testing.assert_allclose(found.q, [0.0], atol=1e-9)
    np.testing.assert_allclose(rod.modes(found.q).frequencies, np.sqrt(9.81 / 0.6), rtol=1e-12)
    assert "forces: (..., 1) [N m]" in rod.inverse_dynamics.__doc__ and "mass: (..., 1, 1) [kg m^2]" in rod.mass_matrix.__doc__
    assert "kinetic: (...) [J]" in rod.energy.__doc__ and rod.energy.results[0].unit == "J"
    out = np.zeros((5, 1))
    assert rod.inverse_dynamics(q, np.zeros(1), np.zeros(1), out=out) is out and np.array_equal(out, held)
