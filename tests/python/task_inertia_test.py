# SPDX-License-Identifier: GPL-3.0-or-later
"""Inertias in operational space: what a push at the point does, elimination in more digits, and tasks without motion."""

import os
from fractions import Fraction

import numpy as np
import pytest

import torsor

from conftest import SOURCES


@pytest.fixture(scope="module")
def arm():
    return torsor.load(os.path.join(SOURCES, "tests/reference/urdf/panda.urdf"), options=("--points", "l3,l6"), flags="-O0",
                       kernels="mass_matrix,bias,forward_dynamics,frames,operational_inertia")


@pytest.fixture(scope="module")
def q():
    """Away from the stretched arm: the elbow is bent by a radian and more."""
    q = np.random.default_rng(2).uniform(-0.4, 0.4, size=(3, 5, 7))
    q[..., 3] -= 1.5
    q[..., 5] += 1.5
    return q


def exact_inverse(matrix):
    """By Gauss's elimination of rational numbers."""
    rows = [[Fraction(x) for x in row] + [Fraction(i == j) for j in range(len(matrix))] for i, row in enumerate(matrix)]
    for k in range(len(rows)):
        best = max(range(k, len(rows)), key=lambda i: abs(rows[i][k]))
        rows[k], rows[best] = rows[best], rows[k]
        rows[k] = [x / rows[k][k] for x in rows[k]]
        for i, row in enumerate(rows):
            if i != k:
                rows[i] = [x - row[k] * y for x, y in zip(row, rows[k])]
    return [row[len(rows):] for row in rows]


def exact_product(a, b):
    return [[sum((x * y for x, y in zip(row, column)), Fraction(0)) for column in zip(*b)] for row in a]


@pytest.mark.parametrize("rows", [range(6), range(3), range(3, 6), [2], [1, 5, 0]])
def test_is_the_inverse_that_rational_numbers_give(arm, q, rows):
    task = arm.task_inertia("l6_origin", q, rows=list(rows))
    assert task.ok.shape == task.rank.shape == q.shape[:-1] and task.ok.all() and (task.rank == len(rows)).all()
    at = (1, 2)
    jacobian = arm.frames(q[at], np.zeros(7)).l6_origin_jacobian[list(rows)]
    half = exact_product([[Fraction(x) for x in row] for row in jacobian], exact_inverse(arm.mass_matrix(q[at])))
    inertia = np.array(exact_inverse(exact_product(half, [[Fraction(x) for x in row] for row in jacobian.T])), dtype=float)
    size = np.sqrt(np.diag(inertia))
    np.testing.assert_allclose(task.inertia[at] / np.outer(size, size), inertia / np.outer(size, size), rtol=0, atol=1e-11)


def test_a_push_at_the_point_accelerates_it(arm, q):
    """At rest and without weight: F along three axes of the hand, J a along them."""
    rest = np.zeros(7)
    frames = arm.frames(q, rest)
    axes, force = frames.l6_origin_rotation, np.array([3.0, -1.0, 2.0])
    task = arm.task_inertia("l6_origin", q, rows="translation", axes=axes)
    linear = np.swapaxes(axes, -1, -2) @ frames.l6_origin_jacobian[..., :3, :]
    a = arm.forward_dynamics(q, rest, arm.bias(q, rest) + force @ linear)[0]
    felt = (task.inertia @ (linear @ a[..., None]))[..., 0]
    np.testing.assert_allclose(felt, np.broadcast_to(force, felt.shape), rtol=0, atol=1e-11)


def test_a_task_without_motion_is_refused_or_asks_for_no_force(arm, q):
    """The fourth link is moved by four joints: no task of six rows. And the whole arm where it is stretched."""
    one = q[0, 0]
    with pytest.raises(torsor.SingularError, match="l3_origin moves in 4 independent ways, and the task has 6 rows"):
        arm.task_inertia("l3_origin", one)
    many = arm.task_inertia("l3_origin", q)
    assert not many.ok.any() and (many.rank == 4).all() and np.isnan(many.inertia).all()
    inverse = arm.operational_inertia(one).l3_origin_inverse_inertia
    inertia = arm.task_inertia("l3_origin", one, pseudo_inverse=True).inertia
    size = np.sqrt(np.outer(np.diag(inverse), np.diag(inverse)))
    np.testing.assert_allclose((inverse @ inertia @ inverse) / size, inverse / size, rtol=0, atol=1e-10)
    assert (inertia == inertia.T).all()
    stretched = np.stack([np.zeros(7), one])
    assert arm.task_inertia("l6_origin", stretched).ok.tolist() == [False, True]


def test_lengths_matter_only_for_what_is_rounding(arm, q):
    for length in (1e-3, 1e3):
        np.testing.assert_array_equal(arm.task_inertia("l6_origin", q, length=length).inertia,
                                      arm.task_inertia("l6_origin", q).inertia)


def test_refuses_what_is_no_task(arm, q):
    with pytest.raises(KeyError, match="no named point 'hand'; there are l3_origin, l6_origin"):
        arm.task_inertia("hand", q)
    for rows, words in (("linear", "no kind 'linear'"), ([0, 0], "are not different numbers"), ([6], "are not"), ([], "are not"),
                        ([0.5], "are not")):
        with pytest.raises(ValueError, match=words):
            arm.task_inertia("l6_origin", q, rows=rows)
    with pytest.raises(ValueError, match="perpendicular"):
        arm.task_inertia("l6_origin", q, axes=2 * np.eye(3))
    with pytest.raises(ValueError, match=r"axes: shape \(2, 3\)"):
        arm.task_inertia("l6_origin", q, axes=np.ones((2, 3)))
    with pytest.raises(ValueError, match="is no length"):
        arm.task_inertia("l6_origin", q, length=0.0)
    with pytest.raises(ValueError, match="tolerance"):
        arm.task_inertia("l6_origin", q, tolerance=np.nan)
