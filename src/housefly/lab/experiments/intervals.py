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
