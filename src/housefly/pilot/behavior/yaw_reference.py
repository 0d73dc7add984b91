"""The heading to fly: the path's wish, turned to no faster than a film can follow."""

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
        target: the heading in the end.
        reference: the heading now; nan before there is anything to track.
    """

    target: float
    reference: float


@compiled
def yaw_reference_advanced(
    before: YawReference, wish: float, yaw: float, turn_max: float
) -> YawReference:
    """Return the wanted headings after one look.

    Args:
        before: at the last look.
        wish: what the path or the task wants [rad]; nan keeps the last target, or the present
            heading when there is none.
        yaw: present heading [rad].
        turn_max: largest turn of the reference in this look [rad]; infinite lets it jump.
    """
    kept = yaw if isnan(before.reference) else before.target
    target = kept if isnan(wish) else wish
    if turn_max > 7.0:
        return YawReference(target, target)
    last = yaw if isnan(before.reference) else before.reference
    return YawReference(target, wrapped(last + clipped(wrapped(target - last), turn_max)))
