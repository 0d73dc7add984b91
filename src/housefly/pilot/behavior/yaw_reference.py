"""Where the nose should point: the path's wish, turned to no faster than a film can follow."""

from __future__ import annotations

from math import isnan
from typing import NamedTuple

from housefly.numeric import clipped, compiled, wrapped

YAW_REFERENCE_RATE = 0.9
"""How quickly the wanted heading turns in mode default [rad/s]: what is filmed should stay
recognizable.
"""


class YawReference(NamedTuple):
    """Headings [rad].

    Attributes:
        target: where the nose shall point in the end.
        reference: where it should point now; nan before there is anything to track.
    """

    target: float
    reference: float


@compiled
def yaw_reference_advanced(
    nose: YawReference, wish: float, yaw: float, turn_max: float
) -> YawReference:
    """Return the wanted headings after one look.

    Args:
        nose: before.
        wish: what the reference wants [rad]; nan keeps the last target, or the present heading when
            there is none.
        yaw: present heading [rad].
        turn_max: largest turn of the reference in this look [rad]; infinite lets it jump.
    """
    kept = yaw if isnan(nose.reference) else nose.target
    target = kept if isnan(wish) else wish
    if turn_max > 7.0:
        return YawReference(target, target)
    last = yaw if isnan(nose.reference) else nose.reference
    return YawReference(target, wrapped(last + clipped(wrapped(target - last), turn_max)))
