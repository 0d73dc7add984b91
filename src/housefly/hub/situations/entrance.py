"""Detects someone at the entrance from the bell, a person at the door and the motion sensor."""

from __future__ import annotations

from housefly.hub.situations.confidence import freshness, noisy_or
from housefly.hub.situations.hysteresis import Hysteresis, claimed_by
from housefly.hub.situations.kinds import SituationKind
from housefly.hub.situations.layout import Layout
from housefly.hub.situations.person_tracks import PersonTracks
from housefly.hub.situations.situation import (
    SOURCE_PREFIX,
    Assessment,
    DetectorInput,
    Evidence,
    Situation,
    flag,
    time_of,
)
from housefly.messages import RoomEvent

_SOURCE = SOURCE_PREFIX + "entrance"
BELL_CONFIDENCE = 0.9
"""Confidence that somebody who has just rung stands there."""
BELL_HEARTBEAT = 15.0
"""Heartbeat of the bell [s]: whoever rings is expected to wait for twice this time."""
_PERSON_CONFIDENCE = 0.9
"""Confidence in a person who is seen at the door and stays."""
_MIN_STAY = 1.5
"""How long a person must be at the door [s]: passers-by do not count."""
_EXIT_MARGIN = 0.3
"""A person leaves when this far outside the rectangle [m]."""
MOTION_CONFIDENCE = 0.4
"""Confidence in the motion sensor alone; too low for a claim."""
_MOTION_HEARTBEAT = 5.0
"""Heartbeat of the motion sensor [s]: motion counts fully for twice this time."""
_DWELL = {SituationKind.AT_ENTRANCE: 0.0, None: 2.0}
"""How long somebody, or nobody, must be there before it counts [s]."""
_THING = "entrance"


class Entrance:
    """Detects who is at one entrance.

    Args:
        tracks: where people are; fed by whoever owns it.
        layout: the rectangle before the door, and whose bells and motion sensors are there.
    """

    def __init__(self, tracks: PersonTracks, layout: Layout) -> None:
        self._tracks, self._layout = tracks, layout
        self._hysteresis = Hysteresis(_THING, _SOURCE, _DWELL)
        self._rung: tuple[float, str] | None = None
        self._moved: tuple[float, str] | None = None
        self._inside: dict[str, float] = {}
        self._left = False

    def add(self, item: DetectorInput) -> None:
        """Add bell presses and motion."""
        at = time_of(item)
        if (
            isinstance(item, RoomEvent)
            and item.kind == "bell pressed"
            and item.source in self._layout.bells
        ):
            self._rung = (at, item.source)
        if item.source in self._layout.motion and _is_motion(item):
            self._moved = (at, item.source)

    def update(self, now: float) -> tuple[RoomEvent, ...]:
        """Return whether somebody arrived or left up to a time [s]."""
        self._note_people(now)
        return self._hysteresis.update(now, self._assess(now))

    def active(self) -> tuple[Situation, ...]:
        """Return the situation that someone is there, if so."""
        return claimed_by((self._hysteresis,))

    def _note_people(self, now: float) -> None:
        here = {person for person in self._tracks.people() if self._is_before_the_door(person, now)}
        gone = set(self._inside) - here
        self._left = not here and (self._left or any(self._went(person, now) for person in gone))
        self._inside = {person: self._inside.get(person, now) for person in sorted(here)}

    def _went(self, person: str, now: float) -> bool:
        """Return whether a person is seen elsewhere, or no longer seen by a live source."""
        latest = self._tracks.latest(person)
        return self._tracks.best(person, now) is not None or (
            latest is not None and self._tracks.out_of_sight(latest)
        )

    def _is_before_the_door(self, person: str, now: float) -> bool:
        track, area = self._tracks.best(person, now), self._layout.entrance
        margin = _EXIT_MARGIN if person in self._inside else 0.0
        return (
            track is not None and area is not None and area.distance(track.last.position) <= margin
        )

    def _assess(self, now: float) -> Assessment | None:
        signs = [*self._bell(now), *self._person(now), *self._motion(now)]
        confidence = noisy_or(sign for sign, _, _ in signs)
        reports = tuple(report for _, _, report in signs)
        who = min(
            (person for person, since in self._inside.items() if now - since >= _MIN_STAY),
            default="",
        )
        since = min((at for _, at, _ in signs), default=now)
        if signs:
            return Assessment(
                SituationKind.AT_ENTRANCE,
                confidence,
                since,
                reports,
                (("signs", float(len(signs))),),
                who,
            )
        return (
            Assessment(None, _PERSON_CONFIDENCE, None, (Evidence("who stood there is gone"),))
            if self._left
            else None
        )

    def _bell(self, now: float) -> list[tuple[float, float, Evidence]]:
        if self._rung is None:
            return []
        at, source = self._rung
        confidence = BELL_CONFIDENCE * freshness(now - at, BELL_HEARTBEAT)
        return [(confidence, at, Evidence("rang", source))] if confidence > 0.0 else []

    def _person(self, now: float) -> list[tuple[float, float, Evidence]]:
        return [
            (
                _PERSON_CONFIDENCE * self._track_confidence(person, now),
                since,
                Evidence(f"{person} stands before the door"),
            )
            for person, since in self._inside.items()
            if now - since >= _MIN_STAY
        ]

    def _track_confidence(self, person: str, now: float) -> float:
        track = self._tracks.best(person, now)
        return 0.0 if track is None else self._tracks.confidence(track, now)

    def _motion(self, now: float) -> list[tuple[float, float, Evidence]]:
        if self._moved is None:
            return []
        at, source = self._moved
        confidence = MOTION_CONFIDENCE * freshness(now - at, _MOTION_HEARTBEAT)
        return [(confidence, at, Evidence("motion", source))] if confidence > 0.0 else []


def _is_motion(item: DetectorInput) -> bool:
    return (
        item.kind == "motion seen"
        if isinstance(item, RoomEvent)
        else item.valid and flag(item, "motion") is True
    )
