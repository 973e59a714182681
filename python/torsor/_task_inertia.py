# SPDX-License-Identifier: MIT
"""The inertia that a task feels at a point of a mechanism: operational space (Khatib 1987)."""

from __future__ import annotations

from typing import NamedTuple, Sequence

import numpy as np
from numpy.typing import ArrayLike

from ._kernel import as_columns

ROWS = {"all": range(6), "translation": range(3), "rotation": range(3, 6)}
# ε^(2/3), as of the rank of constraints
TOLERANCE = float(np.finfo(np.float64).eps ** (2 / 3))


class TaskInertia(NamedTuple):
    """Inertias of a task of k rows, one for each state."""

    inertia: np.ndarray
    """(..., k, k), symmetric: [kg], [kg m], [kg m^2] by the kinds of its rows."""
    rank: np.ndarray
    """How many independent motions the task has: k where the inertia is the inverse of J M^-1 J'."""
    ok: np.ndarray
    """Whether the rank is k."""


def chosen_rows(rows: str | Sequence[int]) -> list[int]:
    """Rows of the twist (V, Omega), 0 to 5."""
    if isinstance(rows, str):
        if rows not in ROWS:
            raise ValueError(f"rows: no kind {rows!r}; there are {', '.join(ROWS)}, or give numbers from 0 to 5")
        return list(ROWS[rows])
    numbers = [int(row) for row in rows if row == int(row)]
    if not numbers or len(numbers) != len(rows) or len(set(numbers)) != len(numbers) or not set(numbers) <= set(range(6)):
        raise ValueError(f"rows: {list(rows)} are not different numbers from 0 (x), 1, 2, 3 (about x), 4, 5")
    return numbers


def task_inertia(inverse: np.ndarray, rows: str | Sequence[int], axes: ArrayLike | None, length: float,
                 tolerance: float | None) -> TaskInertia:
    """As runtime/numerics/operational_inertia.hpp, of (..., 6, 6) numbers that are finite, or NaN where there are none."""
    chosen, least = chosen_rows(rows), TOLERANCE if tolerance is None else float(tolerance)
    if not (np.isfinite(length) and length > 0):
        raise ValueError(f"length: {length} is no length; give one of the mechanism [m]")
    if not (np.isfinite(least) and 0 <= least < 1):
        raise ValueError(f"tolerance: {least} is not from 0 to 1")
    kind = np.array([row // 3 for row in chosen])
    there = np.isfinite(inverse).all(axis=(-2, -1))
    whole = np.where(there[..., None, None], inverse, 0.0)
    diagonal = np.diagonal(whole, axis1=-2, axis2=-1)
    mean = np.stack([diagonal[..., :3].mean(axis=-1), diagonal[..., 3:].mean(axis=-1)], axis=-1)
    size = np.maximum(mean, least * mean[..., ::-1] * np.array([length**2, length**-2]))
    with np.errstate(divide="ignore", invalid="ignore"):
        scale = np.where(size > 0, 1 / np.sqrt(size), 0.0)[..., kind]
    if axes is not None:
        turn = as_columns("axes", axes, 3)
        if turn.ndim < 2 or turn.shape[-2] != 3:
            raise ValueError(f"axes: shape {turn.shape} is not (..., 3, 3)")
        if not np.allclose(np.swapaxes(turn, -1, -2) @ turn, np.eye(3), rtol=0, atol=1e-9):
            raise ValueError("axes: the columns are not three directions of length 1, perpendicular to one another")
        six = np.zeros(turn.shape[:-2] + (6, 6))
        six[..., :3, :3] = six[..., 3:, 3:] = turn
        whole = np.swapaxes(six, -1, -2) @ whole @ six
    scaled = whole[..., chosen, :][..., :, chosen] * scale[..., :, None] * scale[..., None, :]
    values, vectors = np.linalg.eigh(scaled)
    moves = values > least
    shares = np.where(moves, 1 / np.where(moves, values, 1.0), 0.0)
    vectors = vectors * scale[..., :, None]
    inertia = (vectors * shares[..., None, :]) @ np.swapaxes(vectors, -1, -2)
    inertia = np.where(there[..., None, None], (inertia + np.swapaxes(inertia, -1, -2)) / 2, np.nan)
    rank = np.where(there, moves.sum(axis=-1), 0)
    return TaskInertia(inertia, rank, rank == len(chosen))
