"""Fuses the last observations of all sources into one pose per thing.

The rules, in this order:

1. A sample with ``valid`` False is skipped: the source's last valid sample counts.
2. Position: the newest sample that has one. Samples at most ``_FUSION_WINDOW`` older are fused
   with it, weighted by the inverse of their covariances, to which ``(_DRIFT_SPEED * age)^2`` is
   added because things move. A sample without a covariance is used only if no other has one.
3. Orientation: the newest sample within the window that has one.
4. Container: the newest sample that names one; else the catalogue's, unless a source has seen the
   thing elsewhere (``_MOVED_DISTANCE``).
5. A thing that was put into another one after it was last seen (by more than ``_FUSION_WINDOW``)
   has no position of its own any more: it is where its container is, unless the container is as
   large as a room (``_ROOM_KINDS``). The same holds for a thing that never had a position.
6. A thing that no source reports is where the catalogue says; so is a thing that is reported in
   its container of the catalogue.

The result depends only on the samples, not on the order in which they arrived.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from math import isfinite

from housefly.geometry import Quaternion, Vec3, distance
from housefly.hub.things.fusion import fused_position, inflated
from housefly.hub.things.thing import Thing, ThingKind
from housefly.messages import Covariance, Observation

_FUSION_WINDOW = 0.5
"""Samples at most this much older than the newest belong to the same moment [s]."""
_DRIFT_SPEED = 1.0
"""How fast an unobserved thing may move [m/s]."""
_MOVED_DISTANCE = 0.5
"""A thing this far from its place in the catalogue has left its container there [m]."""
_ROOM_KINDS = (ThingKind.SPACE, ThingKind.PLACE)
"""Kinds that are too large to locate what is inside them."""


@dataclass(frozen=True, slots=True)
class FusedPose:
    """Where a thing is and how we know.

    Attributes:
        thing: its id.
        position: world [m]; None if unknown.
        orientation: (w, x, y, z), body to world; None if unknown.
        covariance: of the position [m^2]; None if unknown.
        inside: id of its container, "" if none or unknown.
        seen_at: when the newest valid sample was captured [s, Unix time]; None without one.
        sources: sources of the position (or of the newest sample without one), sorted; empty for
            the catalogue.
        by_container: id of the container whose position this is, "" if it is the thing's own.
    """

    thing: str
    position: Vec3 | None
    orientation: Quaternion | None
    covariance: Covariance | None
    inside: str
    seen_at: float | None
    sources: tuple[str, ...]
    by_container: str = ""

    def age(self, now: float) -> float | None:
        """Return the time since it was last seen [s]; None if it never was."""
        return None if self.seen_at is None else max(0.0, now - self.seen_at)


def fused_pose(
    thing: Thing, samples: Iterable[Observation], kind_of: Callable[[str], ThingKind | None]
) -> FusedPose:
    """Fuse the last valid sample of each source; does not look up the container's position."""
    valid = sorted((sample for sample in samples if sample.valid), key=_age_key)
    placed = [
        sample
        for sample in valid
        if sample.position is not None and all(map(isfinite, sample.position))
    ]
    naming = [sample for sample in valid if sample.inside]
    if placed and naming and _put_away(placed[-1], naming[-1], kind_of):
        placed = []
    seen_at = valid[-1].captured_at if valid else None
    if not placed:
        inside = naming[-1].inside if naming else thing.inside
        position, orientation = (
            (thing.position, thing.orientation) if inside == thing.inside else (None, None)
        )
        return FusedPose(
            thing.id,
            position,
            orientation,
            None,
            inside,
            seen_at,
            tuple(s.source for s in valid[-1:]),
        )
    fresh = [
        sample for sample in placed if sample.captured_at >= placed[-1].captured_at - _FUSION_WINDOW
    ]
    position, covariance, sources = _position(fresh)
    inside = naming[-1].inside if naming else (thing.inside if _at_home(thing, position) else "")
    turned = [sample.orientation for sample in fresh if sample.orientation is not None]
    return FusedPose(
        thing.id, position, turned[-1] if turned else None, covariance, inside, seen_at, sources
    )


def _age_key(sample: Observation) -> tuple[float, str]:
    return sample.captured_at, sample.source


def _put_away(
    placed: Observation, naming: Observation, kind_of: Callable[[str], ThingKind | None]
) -> bool:
    return (
        naming.captured_at > placed.captured_at + _FUSION_WINDOW
        and kind_of(naming.inside) not in _ROOM_KINDS
    )


def _position(fresh: Sequence[Observation]) -> tuple[Vec3, Covariance | None, tuple[str, ...]]:
    newest = fresh[-1]
    assert newest.position is not None, "only samples with a position are weighed"
    parts = [
        (
            sample.position,
            inflated(
                sample.covariance, (_DRIFT_SPEED * (newest.captured_at - sample.captured_at)) ** 2
            ),
        )
        for sample in fresh
        if sample.position is not None and sample.covariance is not None
    ]
    joint = fused_position(parts)
    if joint is None:
        return newest.position, newest.covariance, (newest.source,)
    return *joint, tuple(sorted(sample.source for sample in fresh if sample.covariance is not None))


def _at_home(thing: Thing, position: Vec3) -> bool:
    return thing.position is not None and distance(thing.position, position) <= _MOVED_DISTANCE
