"""Each person: whether they are there, where, and how."""

from __future__ import annotations

from dataclasses import dataclass, replace

from housefly.hub.situations.bed import Beds
from housefly.hub.situations.latch import Latch
from housefly.hub.situations.layout import Layout
from housefly.hub.situations.posture import (
    LYING,
    SITTING,
    STANDING,
    WALKING,
    Looks,
    bed_at,
    rule_for,
    seat_at,
)
from housefly.hub.situations.situation import OURS, Finding, Item, Situation
from housefly.hub.situations.sleeper import sleeper_finding
from housefly.hub.situations.tracks import WINDOW, Track, Tracks
from housefly.messages import Facts, Happening

PRESENT = "person present"
SOURCE = OURS + "people"
PRESENT_AFTER = 0.5
"""Somebody must be seen over this long before they are there [s]: one reflection is nobody."""
SEEN = 0.95
"""Confidence in a position that is fresh."""
DWELL = {WALKING: 0.5, STANDING: 1.0, SITTING: 1.5, LYING: 2.0}
"""So long must a posture be found before it is claimed [s]."""


@dataclass(frozen=True, slots=True)
class _Latches:
    present: Latch
    posture: Latch


class People:
    """Watches everybody whom a source sees.

    Args:
        tracks: where people are; fed by whoever owns it.
        beds: which beds are occupied; likewise.
        layout: where one sits and lies.
    """

    def __init__(self, tracks: Tracks, beds: Beds, layout: Layout) -> None:
        self._tracks, self._beds, self._layout = tracks, beds, layout
        self._latches: dict[str, _Latches] = {}

    def take(self, item: Item) -> None:
        """Take nothing: all that counts comes through tracks and beds."""

    def after(self, now: float) -> tuple[Happening, ...]:
        """Return who came, went, walked, stood, sat or lay down up to a time [s]."""
        told: list[Happening] = []
        for person in self._tracks.people():
            latches = self._latches.setdefault(person, _new(person))
            posture = self._posture(person, latches.posture, now)
            told += latches.present.step(now, self._presence(person, posture, latches.present, now))
            told += latches.posture.step(now, posture)
        return tuple(told)

    def holds(self) -> tuple[Situation, ...]:
        """Return who is there and how."""
        rows = [latches for _, latches in sorted(self._latches.items())]
        claims = (latch.situation for row in rows for latch in (row.present, row.posture))
        return tuple(claim for claim in claims if claim is not None)

    def _presence(
        self, person: str, posture: Finding | None, latch: Latch, now: float
    ) -> Finding | None:
        track = self._tracks.best(person, now)
        if track is not None:
            if not latch.kind and track.last.at - track.since < PRESENT_AFTER:
                return Finding("", SEEN, track.since, (f"{track.source}: seen too shortly",))
            believed = SEEN * self._tracks.trusted(track, now)
            return Finding(
                PRESENT,
                believed,
                track.since,
                (f"{track.source}: seen",),
                _whereabouts(track, None),
            )
        if posture is not None:
            return replace(posture, kind=PRESENT)
        latest = self._tracks.latest(person)
        if latest is None or not self._tracks.out_of_sight(latest):
            return None
        return Finding("", SEEN, latest.last.at, (f"{latest.source}: sees them no longer",))

    def _posture(self, person: str, latch: Latch, now: float) -> Finding | None:
        track = self._tracks.best(person, now)
        if track is None:
            return sleeper_finding(person, now, self._tracks, self._beds, self._layout)
        speed = track.speed()
        if speed is None:
            return _as_before(track, latch, now)
        looks = self._looks(track, speed, latch, now)
        rule = rule_for(looks)
        on = looks.bed or looks.seat
        facts = _whereabouts(track, speed)
        facts = (
            (*facts, ("on", on.name)) if on is not None and rule.kind in (SITTING, LYING) else facts
        )
        words = (f"{track.source}: {rule.words}",)
        return Finding(
            rule.kind, rule.confidence * self._tracks.trusted(track, now), None, words, facts
        )

    def _looks(self, track: Track, speed: float, latch: Latch, now: float) -> Looks:
        place, bed = track.last.position, bed_at(self._layout, track.last.position)
        loaded = self._beds.occupied(bed, now) if bed else None
        area = self._layout.beds.get(bed)
        return Looks(
            speed,
            latch.kind == WALKING,
            track.last.head,
            seat_at(self._layout, place),
            area,
            loaded,
        )


def _as_before(track: Track, latch: Latch, now: float) -> Finding | None:
    """Return what was claimed, for the moment in which somebody came into sight and their speed is
    not known yet.
    """
    return (
        Finding(latch.kind, SEEN, None, (f"{track.source}: just came into sight",))
        if now - track.since < WINDOW
        else None
    )


def _new(person: str) -> _Latches:
    return _Latches(Latch(person, SOURCE, {PRESENT: 0.0, "": 0.0}), Latch(person, SOURCE, DWELL))


def _whereabouts(track: Track, speed: float | None) -> Facts:
    x, y, _ = track.last.position
    place: Facts = (("x", x), ("y", y), ("sigma", track.last.sigma))
    return place if speed is None else (*place, ("speed", speed))
