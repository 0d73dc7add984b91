"""What is near the hull: the drone itself, or somebody who was seen before."""

from __future__ import annotations

import numpy as np

from housefly.perception.laser_tracker import OWN_MARGIN, OwnFootprint

NOBODY = np.zeros((0, 3))
OWN = OwnFootprint((2.0, 2.0), 0.34 + OWN_MARGIN)


def test_what_appears_near_the_hull_is_the_drone() -> None:
    ends = np.array([[2.2, 2.0], [2.5, 2.0], [2.7, 2.0]])
    assert OWN.others(ends, NOBODY).tolist() == [False, False, True]


def test_who_was_seen_before_stays_somebody_when_they_come_near() -> None:
    ends = np.array([[2.2, 2.0], [2.5, 2.0], [2.0, 2.5]])
    somebody = np.array([[2.65, 2.0, 0.17]])
    assert OWN.others(ends, somebody).tolist() == [False, True, False]
