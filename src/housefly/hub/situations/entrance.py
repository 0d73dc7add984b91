"""Someone is at the entrance: the bell, a person before the door and the motion sensor, each with
its weight.
"""

from __future__ import annotations

from housefly.hub.situations.latch import Latch
from housefly.hub.situations.layout import Layout
from housefly.hub.situations.situation import OURS, Finding, Item, Situation, flag, time_of
from housefly.hub.situations.tracks import Tracks
from housefly.hub.situations.trust import together, trust
from housefly.messages import Happening

SOMEONE = "someone at the entrance"
SOURCE = OURS + "entrance"
BELL = 0.9
"""Confidence that somebody stands there who has just rung."""
BELL_PATIENCE = 15.0
"""Whoever rings is believed to wait: wholly for twice this long, after four times it is not known
any more [s].
"""
PERSON = 0.9
"""Confidence in a person who is seen before the door and stays."""
STAYS = 1.5
"""So long must a person be before the door [s]: who passes does not count."""
EDGE = 0.3
"""And is there until they are this far outside the rectangle [m]."""
MOTION = 0.4
"""Confidence in the motion sensor alone; too little for a claim."""
MOTION_PATIENCE = 5.0
"""Motion is believed wholly for twice this long after it was last seen [s]."""
DWELL = {SOMEONE: 0.0, "": 2.0}
"""So long must somebody, or nobody, be there before it counts [s]."""
THING = "entrance"


class Entrance:
    """Watches one entrance.

    Args:
        tracks: where people are; fed by whoever owns it.
        layout: the rectangle before the door, and whose bells and motion sensors are there.
    """

    def __init__(self, tracks: Tracks, layout: Layout) -> None:
        self._tracks, self._layout = tracks, layout
        self._latch = Latch(THING, SOURCE, DWELL)
        self._rung: tuple[float, str] | None = None
        self._moved: tuple[float, str] | None = None
        self._inside: dict[str, float] = {}
        self._left = False

    def take(self, item: Item) -> None:
        """Take bells and motion."""
        at = time_of(item)
        if (
            isinstance(item, Happening)
            and item.kind == "bell pressed"
            and item.source in self._layout.bells
        ):
            self._rung = (at, item.source)
        if item.source in self._layout.motion and _is_motion(item):
            self._moved = (at, item.source)

    def after(self, now: float) -> tuple[Happening, ...]:
        """Return whether somebody came to be there, or is there no longer, up to a time [s]."""
        self._note_people(now)
        return self._latch.step(now, self._finding(now))

    def holds(self) -> tuple[Situation, ...]:
        """Return that someone is there, if so."""
        return (self._latch.situation,) if self._latch.situation is not None else ()

    def _note_people(self, now: float) -> None:
        here = {person for person in self._tracks.people() if self._is_before_the_door(person, now)}
        gone = set(self._inside) - here
        self._left = not here and (self._left or any(self._went(person, now) for person in gone))
        self._inside = {person: self._inside.get(person, now) for person in sorted(here)}

    def _went(self, person: str, now: float) -> bool:
        """Tell whether somebody is seen elsewhere, or no longer by a source that speaks; its
        silence says nothing.
        """
        latest = self._tracks.latest(person)
        return self._tracks.best(person, now) is not None or (
            latest is not None and self._tracks.out_of_sight(latest)
        )

    def _is_before_the_door(self, person: str, now: float) -> bool:
        track, area = self._tracks.best(person, now), self._layout.entrance
        margin = EDGE if person in self._inside else 0.0
        return (
            track is not None and area is not None and area.distance(track.last.position) <= margin
        )

    def _finding(self, now: float) -> Finding | None:
        signs = [*self._bell(now), *self._person(now), *self._motion(now)]
        confidence = together(believed for believed, _, _ in signs)
        words = tuple(word for _, _, word in signs)
        who = min(
            (person for person, since in self._inside.items() if now - since >= STAYS), default=""
        )
        since = min((at for _, at, _ in signs), default=now)
        if signs:
            return Finding(SOMEONE, confidence, since, words, (("signs", float(len(signs))),), who)
        return Finding("", PERSON, None, ("who stood there is gone",)) if self._left else None

    def _bell(self, now: float) -> list[tuple[float, float, str]]:
        if self._rung is None:
            return []
        at, source = self._rung
        believed = BELL * trust(now - at, BELL_PATIENCE)
        return [(believed, at, f"{source}: rang")] if believed > 0.0 else []

    def _person(self, now: float) -> list[tuple[float, float, str]]:
        return [
            (PERSON * self._believed(person, now), since, f"{person} stands before the door")
            for person, since in self._inside.items()
            if now - since >= STAYS
        ]

    def _believed(self, person: str, now: float) -> float:
        track = self._tracks.best(person, now)
        return 0.0 if track is None else self._tracks.trusted(track, now)

    def _motion(self, now: float) -> list[tuple[float, float, str]]:
        if self._moved is None:
            return []
        at, source = self._moved
        believed = MOTION * trust(now - at, MOTION_PATIENCE)
        return [(believed, at, f"{source}: motion")] if believed > 0.0 else []


def _is_motion(item: Item) -> bool:
    return (
        item.kind == "motion seen"
        if isinstance(item, Happening)
        else item.valid and flag(item, "motion") is True
    )
