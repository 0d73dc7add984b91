"""Least squares over blocks, with what differs from block to block projected out, and intervals by
bootstrap over blocks.

Each block has a start and a steady push of its own; these enter linearly and are removed from data
and model alike, so that only what all blocks share is searched for (variable projection).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import sqrt

import numpy as np
from numpy.typing import NDArray

from housefly.errors import MissingPartError

try:
    from scipy.optimize import least_squares
    from scipy.stats import t as student
except ImportError as error:
    raise MissingPartError("scipy (identification)", "pip install 'housefly[lab]'") from error

Numbers = NDArray[np.float64]
RESAMPLES = 2000
LEVEL = 0.95


@dataclass(frozen=True, slots=True, eq=False)
class BlockModel:
    """One block at some constants; all rows are weighted by one over their noise.

    Attributes:
        measured: shape (n,).
        modelled: what the shared constants say, shape (n,).
        own: what is the block's own, as columns, shape (n, k).

    Rows at the end may say what is known beforehand of the block's own (measured and modelled 0).
    """

    measured: Numbers
    modelled: Numbers
    own: Numbers

    @property
    def residual(self) -> Numbers:
        """What neither the shared constants nor the block's own explain, shape (n,)."""
        rest = self.measured - self.modelled
        basis, _ = np.linalg.qr(self.own)
        return np.asarray(rest - basis @ (basis.T @ rest))


Model = Callable[[Numbers], list[BlockModel]]
"""The blocks at given constants."""


@dataclass(frozen=True, slots=True, eq=False)
class Fit:
    """What was found.

    Attributes:
        constants: shape (p,).
        half: half of the 95 % intervals, shape (p,).
        blocks: at the constants found.
        at_bound: numbers of the constants that lie on a bound.
    """

    constants: Numbers
    half: Numbers
    blocks: list[BlockModel]
    at_bound: tuple[int, ...]


def fitted(model: Model, start: Numbers, bounds: tuple[Numbers, Numbers], seed: int = 0) -> Fit:
    """Return the constants that explain the blocks best, with intervals by bootstrap over the
    blocks.

    Args:
        model: the blocks at given constants.
        start: first guess, shape (p,).
        bounds: lowest and highest values, each of shape (p,).
        seed: of the bootstrap.
    """
    scale, steps = np.maximum(np.abs(start), 1e-3), np.full(start.size, 1e-4)

    def residuals(constants: Numbers) -> Numbers:
        return np.concatenate([block.residual for block in model(constants)])

    found = least_squares(
        residuals,
        start,
        bounds=bounds,
        x_scale=scale,
        diff_step=steps,
        xtol=1e-8,
        ftol=1e-10,
        max_nfev=100,
    )
    blocks = model(found.x)
    ends = np.cumsum([block.measured.size for block in blocks])
    rows = np.split(np.asarray(found.jac), ends[:-1])
    rests = np.split(found.fun, ends[:-1])
    tolerance = 1e-3 * (bounds[1] - bounds[0])
    outside = (found.x < bounds[0] + tolerance) | (found.x > bounds[1] - tolerance)
    return Fit(
        found.x, _half_widths(rows, rests, seed), blocks, tuple(np.flatnonzero(outside).tolist())
    )


def _half_widths(rows: list[Numbers], rests: list[Numbers], seed: int) -> Numbers:
    """Return half of the intervals: blocks are drawn with replacement, and each draw is refitted in
    one Gauss-Newton step.

    Residuals within a block hang together (a gust, a late datagram), whole blocks do not. A fit of
    p constants to n blocks leaves residuals that look too small; Student's quantile for n - p and
    the factor n / (n - p) correct for that.
    """
    count, free = len(rows), len(rows) - rows[0].shape[1]
    curvature = np.array([row.T @ row for row in rows])
    slope = np.array([row.T @ rest for row, rest in zip(rows, rests, strict=True)])
    weights = np.random.default_rng(seed).multinomial(count, np.full(count, 1.0 / count), RESAMPLES)
    whole = np.einsum("sb,bij->sij", weights, curvature)
    shifts = -np.einsum(
        "sij,sb,bj->si", np.linalg.pinv(whole, hermitian=True), weights, slope, optimize=True
    )
    spread = shifts.std(axis=0)
    quantile = float(student.ppf(0.5 + 0.5 * LEVEL, free))
    return np.asarray(spread * quantile * sqrt(count / free))
