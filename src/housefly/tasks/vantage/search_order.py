"""The order of looks that finds a thing soonest.

Which looks are worth their way is chosen one after the other by the most probability found per
second, the rule that is optimal where ways cost the same from everywhere (W. L. Black, "Discrete
sequential search", Information and Control 8, 1965; M. C. Chew, "A sequential search procedure",
Annals of Mathematical Statistics 38, 1967; with a camera that moves: Y. Ye, J. K. Tsotsos, "Sensor
planning for 3D object search", Computer Vision and Image Understanding 73, 1999). Real ways cost
what they cost: the chosen looks are put in the order of least expected time, exactly, by dynamic
programming over their subsets (M. Held, R. M. Karp, J. SIAM 10, 1962). What is still hidden after
some looks does not depend on their order, which is what makes it exact.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise

import numpy as np

from housefly.numeric import FloatArray

LOOKS_MAX = 8
"""Most looks that are put in order: their subsets are gone through."""


def chosen_looks(
    probability: FloatArray,
    detection: FloatArray,
    times_from: Callable[[int], FloatArray],
    least: float,
    budget: float = np.inf,
    most: int = LOOKS_MAX,
) -> tuple[int, ...]:
    """Return looks worth flying, the most probability per second first; () when none is.

    Args:
        probability: that the thing is at each point, shape (n,).
        detection: that each look notices it there, shape (m, n).
        times_from: returns the times from one look, or -1 for the drone, to each, with the look
            itself [s], inf without a way, shape (m,).
        least: a look that would find it with less probability than this is not flown.
        budget: longest time of all of them [s].
        most: no more looks than this.
    """
    left, at, spent = probability.copy(), -1, 0.0
    chosen: list[int] = []
    while len(chosen) < most and len(detection):
        gains, times = np.einsum("mn,n->m", detection, left), times_from(at)
        worth = np.where((gains >= least) & (spent + times <= budget), gains / times, 0.0)
        best = int(np.argmax(worth))
        if worth[best] <= 0.0:
            break
        chosen.append(best)
        spent += float(times[best])
        left, at = left * (1.0 - detection[best]), best
    return tuple(chosen)


def expected_time(
    order: Sequence[int], probability: FloatArray, detection: FloatArray, times: FloatArray
) -> float:
    """Return the expected time until a thing is found, or the last look is over [s].

    Args:
        order: of the looks.
        probability: that the thing is at each point, shape (n,).
        detection: that each look notices it there, shape (m, n).
        times: from the drone (row 0) and each look (the other rows) to each look, with the look
            itself [s], shape (m + 1, m).
    """
    left, total = probability, 0.0
    elsewhere = 1.0 - float(probability.sum())
    for before, look in pairwise((-1, *order)):
        total += float(times[before + 1, look]) * (elsewhere + float(left.sum()))
        left = left * (1.0 - detection[look])
    return total


def soonest_order(
    probability: FloatArray, detection: FloatArray, times: FloatArray
) -> tuple[int, ...]:
    """Return all looks in the order of least expected time; arguments as ``expected_time``.

    Raises:
        ValueError: there are more than LOOKS_MAX.
    """
    count = len(detection)
    if count > LOOKS_MAX:
        raise ValueError(f"{count} looks; allowed: {LOOKS_MAX}")
    hidden = _hidden_after(probability, detection)
    best: dict[tuple[int, int], tuple[float, tuple[int, ...]]] = {(0, -1): (0.0, ())}
    for _ in range(count):
        further: dict[tuple[int, int], tuple[float, tuple[int, ...]]] = {}
        for (done, at), (cost, order) in best.items():
            for look in range(count):
                if done >> look & 1:
                    continue
                total = cost + float(times[at + 1, look]) * hidden[done]
                key = done | 1 << look, look
                if key not in further or total < further[key][0]:
                    further[key] = total, (*order, look)
        best = further
    return min(best.values())[1]


def _hidden_after(probability: FloatArray, detection: FloatArray) -> list[float]:
    """Return the probability that the thing is not found after each subset of looks."""
    count, elsewhere = len(detection), 1.0 - float(probability.sum())
    left = [probability]
    for done in range(1, 1 << count):
        last = done.bit_length() - 1
        left.append(left[done ^ 1 << last] * (1.0 - detection[last]))
    return [elsewhere + float(one.sum()) for one in left]
