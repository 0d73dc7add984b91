"""Means and shares with their 95 % intervals over seeds."""

from __future__ import annotations

from math import nan
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from housefly.errors import MissingPartError

try:
    from scipy import stats
except ImportError as error:
    raise MissingPartError("scipy (intervals)", "pip install 'housefly[lab]'") from error

CONFIDENCE_LEVEL = 0.95
"""Confidence of every interval."""
_RESAMPLES = 2000
"""Samples drawn anew for a bootstrap."""


class IntervalEstimate(NamedTuple):
    """A number with its interval; nan where it cannot be given."""

    value: float
    low: float
    high: float

    @property
    def half(self) -> float:
        """Half the width of the interval."""
        return 0.5 * (self.high - self.low)


NOTHING = IntervalEstimate(nan, nan, nan)


def mean(samples: ArrayLike) -> IntervalEstimate:
    """Return the mean of the finite samples with Student's t interval."""
    numbers = np.asarray(samples, dtype=float)
    numbers = numbers[np.isfinite(numbers)]
    if not numbers.size:
        return NOTHING
    middle = float(numbers.mean())
    if numbers.size == 1:
        return IntervalEstimate(middle, nan, nan)
    reach = _student(numbers.size - 1) * float(numbers.std(ddof=1)) / float(np.sqrt(numbers.size))
    return IntervalEstimate(middle, middle - reach, middle + reach)


def bootstrap_mean(samples: ArrayLike) -> IntervalEstimate:
    """Return the mean of all samples with its percentile bootstrap interval, the same every time.

    Unlike ``mean`` it leaves no sample out and supposes no distribution.

    Args:
        samples: finite numbers, shape (n,).
    """
    numbers = np.asarray(samples, dtype=float)
    if not numbers.size:
        return NOTHING
    random = np.random.Generator(np.random.PCG64(0))
    drawn = numbers[random.integers(numbers.size, size=(_RESAMPLES, numbers.size))].mean(axis=1)
    tail = 50.0 * (1.0 - CONFIDENCE_LEVEL)
    low, high = np.percentile(drawn, (tail, 100.0 - tail))
    return IntervalEstimate(float(numbers.mean()), float(low), float(high))


def share(hits: ArrayLike) -> IntervalEstimate:
    """Return the share of true samples with Wilson's interval, which is honest at 0 and at 1."""
    truths = np.asarray(hits, dtype=bool)
    if not truths.size:
        return NOTHING
    interval = stats.binomtest(int(truths.sum()), truths.size).proportion_ci(
        CONFIDENCE_LEVEL, method="wilson"
    )
    return IntervalEstimate(float(truths.mean()), float(interval.low), float(interval.high))


def _student(freedom: int) -> float:
    return float(stats.t.ppf(0.5 + 0.5 * CONFIDENCE_LEVEL, freedom))
