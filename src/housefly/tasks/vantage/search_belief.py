"""Where a lost thing may be, as probabilities over points, and what a look in vain makes of them.

Bayes' rule with a detection probability at each point: what was looked at well becomes unlikely,
everything else, what no point stands for included, likelier (L. D. Stone, "Theory of Optimal
Search", Academic Press, 1975, section 2.1).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from housefly.numeric import FloatArray

IntArray = NDArray[np.int_]


@dataclass(frozen=True, slots=True, eq=False)
class SearchBelief:
    """Where a thing may be.

    Attributes:
        points: where it may lie, world [m], shape (n, 3).
        probability: that it lies at each of them, sum at most 1, shape (n,); what is missing to 1
            is elsewhere, where no point is.
        place: index of each point's place, shape (n,).
        places: what people call the places: "the sofa table".
    """

    points: FloatArray
    probability: FloatArray
    place: IntArray
    places: tuple[str, ...]

    def __post_init__(self) -> None:
        """Raise ValueError for what is no belief."""
        if np.any(self.probability < 0.0) or float(self.probability.sum()) > 1.0 + 1e-9:
            raise ValueError("probabilities are from 0 to 1, and their sum is at most 1")

    def after_nothing(self, detection: FloatArray) -> SearchBelief:
        """Return the belief after a look that showed nothing.

        Args:
            detection: probability that it would have been noticed at each point, shape (n,).
        """
        left = self.probability * (1.0 - detection)
        unseen = 1.0 - float((self.probability * detection).sum())
        # What is surely at a point that was surely seen is nowhere: the memory was wrong.
        new = left / unseen if unseen > 1e-12 else np.zeros_like(left)
        return replace(self, probability=new * min(1.0, 1.0 / max(float(new.sum()), 1e-12)))

    def of_places(self) -> FloatArray:
        """Return the probability of each place, shape (places,)."""
        shares = np.bincount(self.place, self.probability, minlength=len(self.places))
        return np.asarray(shares, dtype=np.float64)
