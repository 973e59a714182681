# SPDX-License-Identifier: GPL-3.0-or-later
"""Kernels on arrays: shapes, bits, refusals, states that fail."""

import os
import subprocess

import numpy as np
import pytest

import torsor

from conftest import SOURCES

N = 41  # some packs, and one that is not full


def states(size, count=3, seed=1):
    return np.random.default_rng(seed).normal(size=(count, N, size))


def test_has_the_bits_of_cpp(panda, tmp_path):
    """The header itself, compiled without vector instructions, at the same states."""
    q, v, a = states(7)
    subprocess.run([os.environ["TORSOR"], "generate", os.path.join(SOURCES, "tests/reference/urdf/panda.urdf"), "--name", "panda",
                    "--kernels", "inverse_dynamics,mass_matrix", "--quiet", "-o", tmp_path / "panda.hpp"], check=True)
    (tmp_path / "main.cpp").write_text("""#include <cstdio>
#include "panda.hpp"
int main() {
  using M = panda::Mechanism<double>;
  const M::Precomputed p = M::precompute(M::default_parameters());
  M::State s{}; M::Accelerations a{}; M::Multipliers l{}; M::GeneralizedForces f{}; std::array<double, 49> mass;
  double x[21];
  while (std::fread(x, sizeof x, 1, stdin) == 1) {
    for (int k = 0; k < 7; ++k) s.q[k] = x[k], s.v[k] = x[7 + k], a[k] = x[14 + k];
    M::inverse_dynamics(p, s, a, l, f);
    M::mass_matrix(p, s, mass);
    std::fwrite(&f, sizeof f, 1, stdout);
    std::fwrite(mass.data(), sizeof mass, 1, stdout);
  }
}""")
    subprocess.run([os.environ.get("CXX", "c++"), "-std=c++17", "-O1", "-ffp-contract=off", "main.cpp", "-o", "main"],
                   cwd=tmp_path, check=True)
    given = np.concatenate([q, v, a], axis=1)
    said = subprocess.run([tmp_path / "main"], input=given.tobytes(), capture_output=True, check=True).stdout
    expected = np.frombuffer(said).reshape(N, 56)
    assert np.array_equal(panda.inverse_dynamics(q, v, a), expected[:, :7])
    assert np.array_equal(panda.mass_matrix(q), expected[:, 7:].reshape(N, 7, 7).transpose(0, 2, 1))
    for i in (0, 8, N - 1):
        assert np.array_equal(panda.inverse_dynamics(q[i], v[i], a[i]), expected[i, :7])


def test_matrices_of_many_states_are_those_of_each_alone(pendulum):
    """None of these is symmetric: rows taken for columns would show."""
    q, v, a = states(2)
    among = pendulum.linearisation(q, v, a)
    for i in (0, 8, N - 1):
        alone = pendulum.linearisation(q[i], v[i], a[i])
        for name in ("C", "K", "A"):
            matrix = getattr(alone, name)
            assert not np.array_equal(matrix, matrix.T)
            assert np.array_equal(getattr(among, name)[i], matrix)
    by_columns = tuple(np.zeros((N, *part.shape[:0:-1])).swapaxes(1, 2) if part.ndim == 3 else np.zeros(part.shape) for part in among)
    pendulum.linearisation(q, v, a, out=by_columns)
    for written, expected in zip(by_columns, among):
        assert np.array_equal(written, expected)


def test_multipliers_are_beside_accelerations(hoop):
    """Both together make the forces of the equations vanish."""
    begin = hoop.initial_state()
    for q, v in ((begin.q, begin.v), (np.tile(begin.q, (9, 1)), np.tile(begin.v, (9, 1)))):
        a, multipliers = hoop.forward_dynamics(q, v)
        assert np.abs(multipliers).max() > 0.1
        # Terms of some 10 N, a hundred operations.
        np.testing.assert_allclose(hoop.inverse_dynamics(q, v, a, multipliers), 0, atol=1e-12)


def test_arguments_of_no_numbers_are_as_many_as_asked_for(pendulum):
    """The documented shape (..., 0): what is written for all mechanisms passes it."""
    q, v = np.broadcast_to([0.3, -0.4], (2, 3, 2)), np.ones((2, 3, 2))
    for none in (np.zeros((2, 3, 0)), np.zeros((3, 0)), np.zeros(0)):
        assert np.array_equal(pendulum.forward_dynamics(q, v, none)[0], pendulum.forward_dynamics(q, v)[0])
        assert np.array_equal(pendulum.inverse_dynamics(q, v, v, none), pendulum.inverse_dynamics(q, v, v))
        assert np.array_equal(pendulum.simulate([0.1], q, v, inputs=none).q, pendulum.simulate([0.1], q, v).q)


def test_broadcasts_like_numpy(panda):
    q, v, a = states(7)
    grid = panda.inverse_dynamics(q[:5, None], v[None, :3], a[0])
    assert grid.shape == (5, 3, 7)
    for i in range(5):
        for k in range(3):
            assert np.array_equal(grid[i, k], panda.inverse_dynamics(q[i], v[k], a[0]))
    assert panda.mass_matrix(q[:0]).shape == (0, 7, 7)


def test_reads_arrays_of_any_order_and_type(panda):
    q, v, a = states(7)
    expected = panda.inverse_dynamics(q, v, a)
    assert np.array_equal(panda.inverse_dynamics(np.asfortranarray(q), v[::-1][::-1], a.copy(order="F")), expected)
    assert np.array_equal(panda.inverse_dynamics(np.repeat(q, 2, axis=0)[::2], v, a), expected)
    assert np.array_equal(panda.inverse_dynamics(q.astype(">f8"), v, a), expected)
    single = q.astype(np.float32)
    assert np.array_equal(panda.inverse_dynamics(single, v, a), panda.inverse_dynamics(single.astype(float), v, a))
    whole = np.arange(7)
    assert np.array_equal(panda.bias(whole, list(whole)), panda.bias(whole.astype(float), whole.astype(float)))


def test_writes_where_it_is_told(panda):
    q, v, a = states(7)
    expected = panda.inverse_dynamics(q, v, a)
    out = np.zeros((N, 7))
    assert panda.inverse_dynamics(q, v, a, out=out) is out
    assert np.array_equal(out, expected)
    wide = np.zeros((7, 2 * N))
    panda.inverse_dynamics(q, v, a, out=wide.T[::2])
    assert np.array_equal(wide.T[::2], expected) and not wide.T[1::2].any()
    over = a.copy()
    panda.inverse_dynamics(q, v, over, out=over)
    assert np.array_equal(over, expected)
    with pytest.raises(ValueError, match="doesn't match the broadcast shape"):
        panda.inverse_dynamics(q, v, a, out=np.zeros((N, 6)))
    with pytest.raises(TypeError, match="float32"):
        panda.inverse_dynamics(q, v, a, out=np.zeros((N, 7), dtype=np.float32))
    out.flags.writeable = False
    with pytest.raises(ValueError, match="read-only"):
        panda.inverse_dynamics(q, v, a, out=out)


def test_threads_change_nothing(panda):
    q, v, a = states(7)
    assert np.array_equal(panda.inverse_dynamics(q, v, a, threads=3), panda.inverse_dynamics(q, v, a))


def test_bound_call_reads_what_the_arrays_hold_now(panda):
    q, v, a = np.zeros((3, 7))
    call = panda.inverse_dynamics.bind(q, v, a)
    q[:] = 0.3
    assert call() is call.result
    assert np.array_equal(call.result, panda.inverse_dynamics(q, v, a))
    q[2] = np.nan
    with pytest.raises(ValueError, match="infs or NaNs"):
        call()


def test_bound_call_reads_arrays_that_it_must_copy(panda):
    """A batch of two dimensions without a single step through it, whole numbers, a result in an argument's place."""
    q, v, a = states(7)
    wide, single, over = np.zeros((5, 7)), np.zeros((3, 1, 7), dtype=np.float32), np.zeros((3, 5, 7))
    time = np.zeros(5, dtype=np.float32)
    call = panda.inverse_dynamics.bind(wide, single, over, out=over, time=time)
    bias = panda.bias.bind(wide[::2], single)
    for k in range(2):
        wide[:], single[:], over[:] = q[k:k + 5], v[k:k + 3, None], a[k]
        assert np.array_equal(bias(), panda.bias(wide[::2], single.astype(float)))
        expected = panda.inverse_dynamics(q[k:k + 5], single.astype(float), a[k])
        assert call() is over and np.array_equal(over, expected)


@pytest.mark.parametrize("bad, error, words", [
    (lambda m, x: m.simulate(1.0, inputs={"panda_joint1_torque": 1}), TypeError, r"inputs: give an array of \d numbers .* not a dict"),
    (lambda m, x: m.inverse_dynamics(x[:6], x, x), ValueError, r"q: mismatch in its last dimension.*\(6,\).*7"),
    (lambda m, x: m.inverse_dynamics(1.0, x, x), ValueError, "q: mismatch"),
    (lambda m, x: m.inverse_dynamics(x, x * 1j, x), TypeError, "Cannot cast array data from dtype\\('complex128'\\)"),
    (lambda m, x: m.inverse_dynamics(["a"] * 7, x, x), TypeError, "Cannot cast array data"),
    (lambda m, x: m.inverse_dynamics(np.zeros((3, 7)), np.zeros((2, 7)), x), ValueError, "broadcast"),
    (lambda m, x: m.inverse_dynamics(x, x, x + np.inf), ValueError, "accelerations: array must not contain infs or NaNs"),
    (lambda m, x: m.inverse_dynamics(np.array([x, x + np.nan]), x, x), ValueError, "q: array must not contain infs or NaNs"),
    (lambda m, x: m.inverse_dynamics(x, x), TypeError, "missing 1 required argument: 'accelerations'"),
    (lambda m, x: m.bias(x, x, x), TypeError, "takes 2 arguments"),
    (lambda m, x: m.bias(x, inputs=x), TypeError, "unexpected keyword argument 'inputs'"),
    (lambda m, x: m.no_kernel(x), AttributeError, "no kernel or attribute 'no_kernel'; its kernels are .*bias"),
    (lambda m, x: m.bias(x, x, parameters={"m": 1}), KeyError, "no run-time parameter 'm'"),
])
def test_refuses(panda, bad, error, words):
    with pytest.raises(error, match=words):
        bad(panda, np.zeros(7))


def test_a_singular_state_alone_raises_and_among_many_is_masked(top):
    """The angles about x, z, y lock at beta = pi/2: the mass matrix loses rank."""
    q = np.zeros((9, 3))
    q[:, 2] = 0.2
    q[4, 1] = np.pi / 2
    determinants = np.linalg.det(top.mass_matrix(q))
    assert abs(determinants[4]) < 1e-16 < determinants[3]
    result = top.forward_dynamics(q, np.ones(3))
    assert list(np.flatnonzero(~result.ok)) == [4]
    assert result.statuses[4] == 1 and np.isnan(result.accelerations[4]).all()
    assert np.array_equal(result.accelerations[3], top.forward_dynamics(q[3], np.ones(3)).accelerations)
    with pytest.raises(torsor.SingularError, match="singular"):
        top.forward_dynamics(q[4], np.ones(3))


def test_a_result_that_overflows_alone_raises_and_among_many_is_not_a_number(panda):
    """Products of rates of 1e200 are no numbers; the kernel bias has no status of its own."""
    v = np.ones((9, 7))
    v[4] = 1e200
    forces = panda.bias(np.zeros(7), v)
    assert list(np.flatnonzero(np.isnan(forces).any(axis=1))) == [4] and np.isnan(forces[4]).all()
    assert np.array_equal(forces[3], panda.bias(np.zeros(7), v[3]))
    with pytest.raises(torsor.NotFiniteError, match="bias: a result is not a finite number"):
        panda.bias(np.zeros(7), v[4])
    energy = panda.energy(np.zeros(7), v)
    assert list(np.flatnonzero(~energy.ok)) == [4] and energy.statuses[4] == 2


def test_parameters_are_a_mapping(pendulum):
    assert dict(pendulum.parameters) == {"m1": 1.0, "m2": 1.0, "l1": 1.0, "l2": 1.0, "g": 9.81}
    assert pendulum.parameter_units["g"] == "m/s^2"
    q = np.array([0.4, -0.2])
    # M of the scene, written out: (m1 + m2) l1^2, m2 l1 l2 cos(theta_1 - theta_2), m2 l2^2
    m1, m2, l1, l2 = 2.0, 0.5, 0.7, 1.1
    expected = [[(m1 + m2) * l1**2, m2 * l1 * l2 * np.cos(0.6)], [m2 * l1 * l2 * np.cos(0.6), m2 * l2**2]]
    given = {"m1": m1, "m2": m2, "l1": l1, "l2": l2}
    # Some eight roundings of numbers of size one.
    np.testing.assert_allclose(pendulum.mass_matrix(q, parameters=given), expected, rtol=0, atol=2e-15)
    other = pendulum.with_parameters(**given)
    assert np.array_equal(other.mass_matrix(q), pendulum.mass_matrix(q, parameters=given))
    assert np.array_equal(other.mass_matrix(np.tile(q, (9, 1)))[8], other.mass_matrix(q))
    assert pendulum.parameters["m1"] == 1.0
    with pytest.raises(ValueError, match="infs or NaNs"):
        pendulum.mass_matrix(q, parameters={"m1": np.nan})


def test_results_have_names(pendulum):
    energy = pendulum.energy(np.zeros(2), np.ones(2))
    assert energy._fields == ("kinetic", "force_function", "power")
    # T = (m1 + m2) l1^2/2 + m2 l1 l2 + m2 l2^2/2 at equal angles and unit rates
    assert energy.kinetic == 2.5 and energy.kinetic.shape == ()
    with pytest.raises(AttributeError, match="no result 'potential'; there are kinetic"):
        energy.potential


def test_series_of_a_motion(pendulum):
    q, v = np.array([0.3, 0.5]), np.array([0.1, -0.2])
    series = pendulum.jets(q, v, order=20).coefficients
    assert series.shape == (4, 21)
    t = 0.1
    motion = pendulum.simulate([t], q, v, method="taylor", relative_tolerance=1e-14, absolute_tolerance=1e-14)
    # What is left of the series is below 0.1^21 of coefficients of size one or so; the motion errs by some 1e-14.
    np.testing.assert_allclose(series @ t ** np.arange(21), motion.states[0], atol=1e-13)
    with pytest.raises(ValueError, match="order"):
        pendulum.jets(q, v, order=31)
    assert pendulum.jets(q, v).coefficients.shape == (4, 13)
    with pytest.raises(ValueError, match="order: mass_matrix has none, only Taylor coefficients do; leave it out"):
        pendulum.mass_matrix(q, order=3)
    with pytest.raises(ValueError, match="order: energy has none"):
        pendulum.energy.bind(q, v, order=12)


def test_says_what_it_is(panda, body):
    assert list(panda.coordinates) == [f"j{k}" for k in range(7)]
    assert panda.coordinates["j0"] == "rad" and panda.inputs["j0_torque"] == "N m"
    assert "accelerations: (..., 7)" in panda.inverse_dynamics.__doc__
    assert "(..., 7, 7)" in panda.mass_matrix.__doc__
    assert body.quaternions == (0,) and len(body.coordinates) == 4


def test_opens_what_is_a_library_only(tmp_path):
    with pytest.raises(OSError):
        torsor.open(tmp_path / "nothing.so")
    with pytest.raises(FileNotFoundError):
        torsor.load(tmp_path / "nothing.urdf")
    with pytest.raises(torsor.LoadError, match="unknown kernel 'biass'"):
        torsor.load(os.path.join(SOURCES, "tests/reference/urdf/panda.urdf"), kernels=["biass"])


def test_a_notebook_shows_the_equations(rod):
    assert "hinge" in rod._repr_latex_()
    assert rod._repr_html_().startswith("<iframe srcdoc=") and "canvas" in rod._repr_html_()
    assert torsor.open(rod.path)._repr_html_() is None


def test_kernels_that_are_made_by_name():
    """A cart of 1 kg with a pole of 0.2 kg, whose centre of mass is 0.5 m from the hinge, turned by theta about y."""
    arm = torsor.load(os.path.join(SOURCES, "tests/python/cart_pole.urdf"), options=("--points", "pole"), flags="-O0",
                      kernels="mass_matrix,inverse_dynamics,gravity,centroidal_momentum,frames,operational_inertia")
    q, v = np.array([0.3, 0.7]), np.array([0.2, -1.1])
    few = dict(rtol=0, atol=1e-14)  # some roundings of numbers of the size of 1 to 16
    np.testing.assert_allclose(arm.gravity(q), arm.inverse_dynamics(q, [0, 0], [0, 0]), **few)
    np.testing.assert_allclose(arm.gravity(q)[1], -0.2 * 9.81 * 0.5 * np.sin(0.7), **few)
    momentum = arm.centroidal_momentum(q, v)
    np.testing.assert_allclose(momentum.linear[0], 1.2 * 0.2 + 0.2 * 0.5 * np.cos(0.7) * -1.1, **few)
    np.testing.assert_allclose(momentum.matrix @ v, np.concatenate([momentum.linear, momentum.angular]), **few)
    frames = arm.frames(q, v)
    np.testing.assert_allclose(frames.pole_origin_position, [0.3, 0, 0], **few)
    np.testing.assert_allclose(frames.pole_origin_jacobian @ v, frames.pole_origin_twist, **few)
    jacobian, mass = frames.pole_origin_jacobian, arm.mass_matrix(q)
    np.testing.assert_allclose(arm.operational_inertia(q).pole_origin_inverse_inertia, jacobian @ np.linalg.solve(mass, jacobian.T),
                               **few)
    with pytest.raises(AttributeError, match=r"made by name only: load\(..., kernels='all,gravity'\)"):
        arm.poses(q)
