"""Detects falls, apart from lying: by where somebody lies, how they came there, and how long."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf

from housefly.hub.situations.bed import Beds
from housefly.hub.situations.confidence import KNOWN_THRESHOLD, noisy_or
from housefly.hub.situations.hysteresis import Hysteresis, claimed_by
from housefly.hub.situations.kinds import SituationKind
from housefly.hub.situations.layout import Layout
from housefly.hub.situations.person_detector import PersonDetector
from housefly.hub.situations.person_tracks import PersonTrack, PersonTracks
from housefly.hub.situations.posture import features_of, is_down
from housefly.hub.situations.situation import SOURCE_PREFIX, Assessment, Evidence, Situation
from housefly.messages import Facts, RoomEvent

_SOURCE = SOURCE_PREFIX + "falls"
UPRIGHT_HEAD = 1.0
"""Somebody with a higher head is upright: stands, or sits on a chair [m]."""
UPRIGHT_EXTENT = 0.6
"""Somebody who touches the floor over no more than this length is upright [m]."""
FAST_DESCENT, SLOW_DESCENT = 1.5, 4.0
"""Who falls is down within the first, who lies down on purpose takes longer than the second [s]."""
_DESCENTS = ((FAST_DESCENT, 0.85), (SLOW_DESCENT, 0.6), (inf, 0.3))
"""Confidence in a fall by the time from upright to the floor [s]."""
_UNSEEN_DESCENT = 0.5
"""Confidence where nobody saw how they came to lie there."""
LONG_ON_FLOOR = 180.0
"""Who lies on the floor for this long may need help however they came there [s]."""
_LASTING = ((600.0, 0.6), (LONG_ON_FLOOR, 0.35))
"""What the time on the floor [s] adds, as an independent word."""
_UP_AGAIN = 2.0
"""Whoever is off the floor for less than this never got up [s]: measurements flicker."""
_UPRIGHT_MEMORY = 30.0
"""Older sightings of somebody upright do not say how they came down [s]."""
_UP_CONFIDENCE = 0.95
_DWELL = {SituationKind.PERSON_FALLEN: 3.0, None: 1.0}
"""How long somebody must lie on the floor, or be off it [s]: who stumbles gets up at once."""


@dataclass(slots=True)
class _Watch:
    """One person: when last upright, since when on the floor, and how long the way took [s]."""

    hysteresis: Hysteresis
    upright_at: float | None = None
    down_since: float | None = None
    down_until: float = -inf
    descent: float | None = None

    def see(self, at: float, lies: bool, upright: bool) -> None:
        """Take in whether somebody lies on the floor or is upright at a time [s]."""
        if lies:
            if self.down_since is None:
                known = self.upright_at is not None and at - self.upright_at <= _UPRIGHT_MEMORY
                self.descent = at - self.upright_at if known and self.upright_at else None
                self.down_since = at
            self.down_until = at
            return
        if at - self.down_until > _UP_AGAIN:
            self.down_since = None
        if upright:
            self.upright_at = at


class Falls(PersonDetector):
    """Detects who may have fallen."""

    def __init__(self, tracks: PersonTracks, beds: Beds, layout: Layout) -> None:
        super().__init__(tracks, beds, layout)
        self._watches: dict[str, _Watch] = {}

    def update(self, now: float) -> tuple[RoomEvent, ...]:
        """Return who fell, or got up again, up to a time [s]."""
        events: list[RoomEvent] = []
        for person in self._tracks.people():
            watch = self._watches.setdefault(person, _Watch(Hysteresis(person, _SOURCE, _DWELL)))
            events += watch.hysteresis.update(now, self._assess(person, watch, now))
        return tuple(events)

    def active(self) -> tuple[Situation, ...]:
        """Return who may have fallen and lies there still."""
        return claimed_by(watch.hysteresis for _, watch in sorted(self._watches.items()))

    def _assess(self, person: str, watch: _Watch, now: float) -> Assessment | None:
        track = self._telling(person, now)
        if track is None:
            watch.down_since = None
            return None
        lies = self._lies(track, now)
        watch.see(track.last.at, lies, _is_upright(track))
        trusted = self._tracks.confidence(track, now)
        is_claimed = watch.hysteresis.kind == SituationKind.PERSON_FALLEN
        if watch.down_since is None or not (lies or is_claimed):
            return Assessment(
                None,
                _UP_CONFIDENCE * trusted,
                None,
                (Evidence("off the floor", track.source),),
            )
        lasting = track.last.at - watch.down_since
        confidence = noisy_or((_by_descent(watch.descent), _by_time(lasting))) * trusted
        evidence = _evidence(track, watch.descent, lasting)
        return Assessment(
            SituationKind.PERSON_FALLEN,
            confidence,
            watch.down_since,
            evidence,
            _facts(track, watch.descent),
        )

    def _telling(self, person: str, now: float) -> PersonTrack | None:
        """Return the best track of a source that measures how high or how long somebody is."""
        telling = [
            track
            for track in self._tracks.of(person)
            if (track.last.head is not None or track.last.extent is not None)
            and self._tracks.confidence(track, now) >= KNOWN_THRESHOLD
        ]
        return min(
            telling,
            key=lambda track: (
                -self._tracks.confidence(track, now), track.last.sigma, track.source,
            ),
            default=None,
        )  # fmt: skip

    def _lies(self, track: PersonTrack, now: float) -> bool:
        if not is_down(track.last.head, track.last.extent):
            return False
        return features_of(track, 0.0, False, self._layout, self._beds, now).lies_on_floor


def _is_upright(track: PersonTrack) -> bool:
    head, extent = track.last.head, track.last.extent
    if head is not None:
        return head >= UPRIGHT_HEAD
    return extent is not None and extent <= UPRIGHT_EXTENT


def _by_descent(descent: float | None) -> float:
    if descent is None:
        return _UNSEEN_DESCENT
    return next(confidence for limit, confidence in _DESCENTS if descent <= limit)


def _by_time(lasting: float) -> float:
    return next((confidence for limit, confidence in _LASTING if lasting >= limit), 0.0)


def _evidence(track: PersonTrack, descent: float | None, lasting: float) -> tuple[Evidence, ...]:
    """Return what shows that they lie there, how they came down, since when."""
    last = track.last
    lies = (
        f"head at {last.head:.2f} m"
        if last.head is not None
        else f"{last.extent or 0.0:.1f} m long on the floor"
    )
    came = "nobody saw how" if descent is None else f"down within {max(descent, 0.1):.1f} s"
    stays = (f"there for {lasting / 60.0:.0f} min",) if lasting >= LONG_ON_FLOOR else ()
    return (Evidence(f"on the floor, {lies}", track.source), *map(Evidence, (came, *stays)))


def _facts(track: PersonTrack, descent: float | None) -> Facts:
    x, y, _ = track.last.position
    place: Facts = (("x", x), ("y", y))
    return place if descent is None else (*place, ("descent", descent))
