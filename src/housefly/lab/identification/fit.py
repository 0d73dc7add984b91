"""Least squares over blocks by variable projection, with intervals by bootstrap over blocks.

Each block has its own initial state and constant push. These enter linearly and are projected out
of data and model, so that only the shared constants are searched for.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import sqrt

import numpy as np

from housefly.errors import MissingPartError
from housefly.numeric import FloatArray

try:
    from scipy.optimize import least_squares
    from scipy.special import stdtrit
except ImportError as error:
    raise MissingPartError("scipy (identification)", "pip install 'housefly[lab]'") from error

_RESAMPLES = 2000
_CONFIDENCE = 0.95


@dataclass(frozen=True, slots=True, eq=False)
class BlockModel:
    """One block at given constants; every row is divided by its noise.

    Attributes:
        measured: shape (n,).
        modelled: what the shared constants say, shape (n,).
        own: what is the block's own, as columns, shape (n, k).

    Rows at the end may say what is known beforehand of the block's own (measured and modelled 0).
    """

    measured: FloatArray
    modelled: FloatArray
    own: FloatArray

    @property
    def residual(self) -> FloatArray:
        """What neither the shared constants nor the block's own terms explain, shape (n,)."""
        rest = self.measured - self.modelled
        basis, _ = np.linalg.qr(self.own)
        return np.asarray(rest - basis @ (basis.T @ rest))


_Model = Callable[[FloatArray], list[BlockModel]]
"""Returns the blocks at given constants."""


@dataclass(frozen=True, slots=True, eq=False)
class Fit:
    """The result of a fit.

    Attributes:
        constants: shape (p,).
        half: half of the 95 % intervals, shape (p,).
        blocks: at the constants found.
        at_bound: numbers of the constants that lie on a bound.
    """

    constants: FloatArray
    half: FloatArray
    blocks: list[BlockModel]
    at_bound: tuple[int, ...]


def fit_blocks(
    model: _Model, start: FloatArray, bounds: tuple[FloatArray, FloatArray], seed: int = 0
) -> Fit:
    """Return the constants that fit the blocks best, with intervals by bootstrap over the blocks.

    Args:
        model: the blocks at given constants.
        start: first guess, shape (p,).
        bounds: lowest and highest values, each of shape (p,).
        seed: of the bootstrap.
    """
    scale, steps = np.maximum(np.abs(start), 1e-3), np.full(start.size, 1e-4)

    def residuals(constants: FloatArray) -> FloatArray:
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


def _half_widths(rows: list[FloatArray], rests: list[FloatArray], seed: int) -> FloatArray:
    """Return half the widths of the intervals.

    Blocks are drawn with replacement and each draw is refitted in one Gauss-Newton step. Residuals
    within a block are correlated (a gust, a late datagram), whole blocks are not. With p constants
    and n blocks the residuals look too small; Student's quantile for n - p and the factor n / (n -
    p) correct for that.
    """
    count, free = len(rows), len(rows) - rows[0].shape[1]
    curvature = np.array([row.T @ row for row in rows])
    slope = np.array([row.T @ rest for row, rest in zip(rows, rests, strict=True)])
    weights = np.random.default_rng(seed).multinomial(
        count, np.full(count, 1.0 / count), _RESAMPLES
    )
    whole = np.einsum("sb,bij->sij", weights, curvature)
    shifts = -np.einsum(
        "sij,sb,bj->si", np.linalg.pinv(whole, hermitian=True), weights, slope, optimize=True
    )
    spread = shifts.std(axis=0)
    quantile = float(stdtrit(free, 0.5 + 0.5 * _CONFIDENCE))
    return np.asarray(spread * quantile * sqrt(count / free))
