"""Detects for each person whether they are present, where, and in which posture."""

from __future__ import annotations

from dataclasses import dataclass, replace

from housefly.hub.situations.bed import Beds
from housefly.hub.situations.hysteresis import Hysteresis, claimed_by
from housefly.hub.situations.kinds import SituationKind
from housefly.hub.situations.layout import Layout
from housefly.hub.situations.person_detector import PersonDetector
from housefly.hub.situations.person_tracks import SPEED_WINDOW, PersonTrack, PersonTracks
from housefly.hub.situations.posture import PersonFeatures, features_of, rule_for
from housefly.hub.situations.situation import SOURCE_PREFIX, Assessment, Evidence, Situation
from housefly.hub.situations.sleeping import assess_sleeper
from housefly.messages import Facts, RoomEvent

ON_FLOOR = "floor"
"""What carries somebody who lies on the floor."""
_SOURCE = SOURCE_PREFIX + "people"
_PRESENT_AFTER = 0.5
"""How long somebody must be seen to be present [s]: ignores single reflections."""
_SEEN_CONFIDENCE = 0.95
"""Confidence in a fresh position."""
_DWELL: dict[SituationKind | None, float] = {
    SituationKind.PERSON_WALKING: 0.5,
    SituationKind.PERSON_STANDING: 1.0,
    SituationKind.PERSON_SITTING: 1.5,
    SituationKind.PERSON_LYING: 2.0,
}
"""How long a posture must last before it is claimed [s]."""


@dataclass(frozen=True, slots=True)
class _PersonState:
    presence: Hysteresis
    posture: Hysteresis


class People(PersonDetector):
    """Detects presence and posture of everybody whom a source sees."""

    def __init__(self, tracks: PersonTracks, beds: Beds, layout: Layout) -> None:
        super().__init__(tracks, beds, layout)
        self._states: dict[str, _PersonState] = {}

    def update(self, now: float) -> tuple[RoomEvent, ...]:
        """Return who came, left, walked, stood, sat or lay down up to a time [s]."""
        events: list[RoomEvent] = []
        for person in self._tracks.people():
            state = self._states.setdefault(person, _new(person))
            posture = self._posture(person, state.posture, now)
            events += state.presence.update(
                now, self._presence(person, posture, state.presence, now)
            )
            events += state.posture.update(now, posture)
        return tuple(events)

    def active(self) -> tuple[Situation, ...]:
        """Return who is present, and their postures."""
        rows = [state for _, state in sorted(self._states.items())]
        return claimed_by(claim for row in rows for claim in (row.presence, row.posture))

    def _presence(
        self, person: str, posture: Assessment | None, hysteresis: Hysteresis, now: float
    ) -> Assessment | None:
        track = self._tracks.best(person, now)
        if track is not None:
            if not hysteresis.kind and track.last.at - track.since < _PRESENT_AFTER:
                return Assessment(
                    None,
                    _SEEN_CONFIDENCE,
                    track.since,
                    (Evidence("seen too shortly", track.source),),
                )
            confidence = _SEEN_CONFIDENCE * self._tracks.confidence(track, now)
            return Assessment(
                SituationKind.PERSON_PRESENT,
                confidence,
                track.since,
                (Evidence("seen", track.source),),
                _place_facts(track, None),
            )
        if posture is not None:
            return replace(posture, kind=SituationKind.PERSON_PRESENT)
        latest = self._tracks.latest(person)
        if latest is None or not self._tracks.out_of_sight(latest):
            return None
        return Assessment(
            None,
            _SEEN_CONFIDENCE,
            latest.last.at,
            (Evidence("sees them no longer", latest.source),),
        )

    def _posture(self, person: str, hysteresis: Hysteresis, now: float) -> Assessment | None:
        track = self._tracks.best(person, now)
        if track is None:
            return assess_sleeper(person, now, self._tracks, self._beds, self._layout)
        speed = track.speed()
        if speed is None:
            return _as_before(track, hysteresis, now)
        walked = hysteresis.kind == SituationKind.PERSON_WALKING
        looks = features_of(track, speed, walked, self._layout, self._beds, now)
        rule = rule_for(looks)
        facts = _place_facts(track, speed)
        if rule.kind in (SituationKind.PERSON_SITTING, SituationKind.PERSON_LYING):
            facts = (*facts, ("on", _carrier(looks)))
        evidence = (Evidence(rule.words, track.source),)
        return Assessment(
            rule.kind, rule.confidence * self._tracks.confidence(track, now), None, evidence, facts
        )


def _as_before(track: PersonTrack, hysteresis: Hysteresis, now: float) -> Assessment | None:
    """Keep the posture while somebody has just come into sight and their speed is not known yet."""
    return (
        Assessment(
            hysteresis.kind,
            _SEEN_CONFIDENCE,
            None,
            (Evidence("just came into sight", track.source),),
        )
        if now - track.since < SPEED_WINDOW
        else None
    )


def _carrier(looks: PersonFeatures) -> str:
    """Return what carries somebody who sits or lies."""
    area = None if looks.lies_on_floor else looks.bed or looks.seat
    return ON_FLOOR if area is None else area.name


def _new(person: str) -> _PersonState:
    return _PersonState(
        Hysteresis(person, _SOURCE, {SituationKind.PERSON_PRESENT: 0.0, None: 0.0}),
        Hysteresis(person, _SOURCE, _DWELL),
    )


def _place_facts(track: PersonTrack, speed: float | None) -> Facts:
    x, y, _ = track.last.position
    place: Facts = (("x", x), ("y", y), ("sigma", track.last.sigma))
    return place if speed is None else (*place, ("speed", speed))
