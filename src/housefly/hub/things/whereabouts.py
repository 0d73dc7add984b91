"""The fused view: where a thing is, by what all sources last said of it.

The rule, in this order:

1. A sample that its source does not stand by (``valid`` False) says nothing: the source's last
  valid sample speaks.
2. Position: the newest sample that has one; samples at most ``FRESH`` older join it, weighted by
  the inverse of their
   covariances, to which ``(DRIFT * age)^2`` is added because things move. A sample without a
   covariance is used only when no fresh one has any.
3. Orientation: the newest fresh sample that has one.
4. Containment: the newest sample that names a container; else the catalogue's, as long as no source
  has seen the thing
   elsewhere (``MOVED``).
5. A thing that was put into something after it was last seen (more than ``FRESH`` later) has no
  position of its own any more,
   unless what it is in is as large as a room (``ROOMY``): it is where its container is. So is one
   that never had a position.
6. What no source speaks of is where the catalogue says; so is one that is said to be in its
  container of the catalogue.

The outcome depends on the samples alone, not on the order in which they came.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from math import isfinite

from housefly.geometry import Quaternion, Vec3, distance
from housefly.hub.things.thing import Kind, Thing
from housefly.hub.things.weighing import weighted, widened
from housefly.messages import Covariance, Observation

FRESH = 0.5
"""Samples at most this much older than the newest are of the same moment [s]."""
DRIFT = 1.0
"""How fast a thing may move while we look away [m/s]."""
MOVED = 0.5
"""Seen farther than this from its place in the catalogue, a thing is no longer in its container
there [m].
"""
ROOMY = (Kind.SPACE, Kind.PLACE)
"""Kinds whose position is no answer to where a thing inside them is."""


@dataclass(frozen=True, slots=True)
class Whereabouts:
    """Where a thing is and how we know.

    Attributes:
        thing: its id.
        position: world [m]; None when nobody knows.
        orientation: (w, x, y, z), body to world; None when unknown.
        covariance: of the position [m^2]; None when unknown.
        inside: id of what contains it, "" when nothing does or nobody says.
        seen_at: when the newest valid sample was captured [s, Unix time]; None when only the
            catalogue speaks.
        sources: whose samples made the position (or, without one, who spoke last), in alphabetical
            order; empty: the catalogue.
        by_container: id of the container whose position this is, "" when it is the thing's own.
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
        """Return how long ago [s] it was last seen; None when it never was."""
        return None if self.seen_at is None else max(0.0, now - self.seen_at)


def whereabouts(
    thing: Thing, said: Iterable[Observation], kind_of: Callable[[str], Kind | None]
) -> Whereabouts:
    """Return the fused view of a thing from the last valid sample of each source; the container's
    position is not looked up.
    """
    speaking = sorted((sample for sample in said if sample.valid), key=_age_key)
    placed = [
        sample
        for sample in speaking
        if sample.position is not None and all(map(isfinite, sample.position))
    ]
    naming = [sample for sample in speaking if sample.inside]
    if placed and naming and _put_away(placed[-1], naming[-1], kind_of):
        placed = []
    seen_at = speaking[-1].captured_at if speaking else None
    if not placed:
        inside = naming[-1].inside if naming else thing.inside
        position, orientation = (
            (thing.position, thing.orientation) if inside == thing.inside else (None, None)
        )
        return Whereabouts(
            thing.id,
            position,
            orientation,
            None,
            inside,
            seen_at,
            tuple(s.source for s in speaking[-1:]),
        )
    fresh = [sample for sample in placed if sample.captured_at >= placed[-1].captured_at - FRESH]
    position, covariance, sources = _position(fresh)
    inside = naming[-1].inside if naming else (thing.inside if _at_home(thing, position) else "")
    turned = [sample.orientation for sample in fresh if sample.orientation is not None]
    return Whereabouts(
        thing.id, position, turned[-1] if turned else None, covariance, inside, seen_at, sources
    )


def _age_key(sample: Observation) -> tuple[float, str]:
    return sample.captured_at, sample.source


def _put_away(
    placed: Observation, naming: Observation, kind_of: Callable[[str], Kind | None]
) -> bool:
    return naming.captured_at > placed.captured_at + FRESH and kind_of(naming.inside) not in ROOMY


def _position(fresh: Sequence[Observation]) -> tuple[Vec3, Covariance | None, tuple[str, ...]]:
    newest = fresh[-1]
    assert newest.position is not None, "only samples with a position are weighed"
    parts = [
        (
            sample.position,
            widened(sample.covariance, (DRIFT * (newest.captured_at - sample.captured_at)) ** 2),
        )
        for sample in fresh
        if sample.position is not None and sample.covariance is not None
    ]
    joint = weighted(parts)
    if joint is None:
        return newest.position, newest.covariance, (newest.source,)
    return *joint, tuple(sorted(sample.source for sample in fresh if sample.covariance is not None))


def _at_home(thing: Thing, position: Vec3) -> bool:
    return thing.position is not None and distance(thing.position, position) <= MOVED
