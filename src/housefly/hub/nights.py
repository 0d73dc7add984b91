"""How often somebody was up at night, from what was kept of beds and people; pure."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from datetime import datetime, timedelta
from itertools import zip_longest

from housefly.hub.api.state_answers import NightAnswer, TimeUp
from housefly.hub.person_status import is_bed
from housefly.hub.situations.hysteresis import UNKNOWN
from housefly.hub.situations.kinds import SituationKind
from housefly.hub.situations_at import MEMORY_STARTED
from housefly.hub.things.words import lasting_words
from housefly.messages import RoomEvent

SHORTEST_TIME_UP = 30.0
"""Whoever is out of bed for less than this was not up [s]."""
_MAX_NIGHTS = 400


@dataclass(frozen=True, slots=True)
class Stay:
    """One time in bed: from, until [s, Unix time], and whether they are known to have left then."""

    begin: float
    end: float
    left: bool


@dataclass(frozen=True, slots=True)
class NightWindow:
    """The hours of the local day that count as night; across midnight when they decrease [h]."""

    from_hour: float = 22.0
    to_hour: float = 6.0

    def nights(self, since: float, until: float) -> Iterator[tuple[float, float]]:
        """Yield begin and end of the nights that begin between two times [s, Unix time]."""
        day = datetime.fromtimestamp(since).replace(hour=0, minute=0, second=0, microsecond=0)
        for _ in range(_MAX_NIGHTS):
            begin = (day + timedelta(hours=self.from_hour)).timestamp()
            days = 1 if self.to_hour <= self.from_hour else 0
            end = (day + timedelta(days=days, hours=self.to_hour)).timestamp()
            if begin >= until:
                return
            if begin >= since:
                yield begin, end
            day += timedelta(days=1)


def stays_of(thing: str, events: Iterable[RoomEvent], until: float) -> tuple[Stay, ...]:
    """Return the times that a bed was occupied, or that a person was in bed.

    Args:
        thing: id of the bed or of the person.
        events: of any kind, by time.
        until: the end of what is known [s, Unix time].
    """
    stays: list[Stay] = []
    begin: float | None = None
    for event in events:
        if begin is not None and _ends(thing, event):
            left = event.kind != MEMORY_STARTED and UNKNOWN not in event.facts
            stays.append(Stay(begin, event.at, left))
            begin = None
        elif begin is None and _begins(thing, event):
            begin = event.at
    if begin is not None:
        stays.append(Stay(begin, until, left=False))
    return tuple(_joined(stays))


def night_of(
    thing: str, window: tuple[float, float], stays: Sequence[Stay], now: float
) -> NightAnswer:
    """Return one night of a bed or a person.

    Args:
        thing: its id.
        window: begin and end [s, Unix time].
        stays: by time.
        now: nothing is known of what comes after it [s, Unix time].
    """
    begin, end = window
    horizon = min(end, now)
    during = [stay for stay in stays if stay.end > begin and stay.begin < horizon]
    times_up: list[TimeUp] = []
    rose: float | None = None
    unknown = 0.0
    for stay, after in zip_longest(during, during[1:]):
        if stay.end >= horizon:
            continue
        back = after.begin if after is not None else None
        if not stay.left:
            unknown += (back or horizon) - stay.end
        elif back is not None:
            times_up.append(TimeUp(stay.end, back))
        else:
            rose = stay.end
    in_bed = sum(min(stay.end, horizon) - max(stay.begin, begin) for stay in during)
    words = _night_words(window, times_up, rose, in_bed, unknown)
    return NightAnswer(thing, begin, end, tuple(times_up), rose, in_bed, unknown, words)


def nothing_kept(thing: str, window: tuple[float, float]) -> NightAnswer:
    """Return a night of which the memory holds nothing at all."""
    begin, end = window
    words = f"{_span(window)}: nothing was kept of this night"
    return NightAnswer(thing, begin, end, (), None, 0.0, end - begin, words)


_UP = {
    SituationKind.BED_OCCUPIED.ended,
    SituationKind.PERSON_LYING.ended,
    SituationKind.PERSON_SITTING.ended,
}


def _begins(thing: str, event: RoomEvent) -> bool:
    if event.thing != thing:
        return False
    in_bed = event.kind in (SituationKind.PERSON_LYING, SituationKind.PERSON_SITTING) and is_bed(
        dict(event.facts).get("on")
    )
    return event.kind == SituationKind.BED_OCCUPIED or in_bed


def _ends(thing: str, event: RoomEvent) -> bool:
    return event.kind == MEMORY_STARTED or (event.thing == thing and event.kind in _UP)


def _joined(stays: Sequence[Stay]) -> Iterator[Stay]:
    """Yield the stays; those with a shorter break than a time up between them are one."""
    last: Stay | None = None
    for stay in stays:
        if last is not None and stay.begin - last.end < SHORTEST_TIME_UP:
            last = Stay(last.begin, stay.end, stay.left)
            continue
        if last is not None:
            yield last
        last = stay
    if last is not None:
        yield last


def _night_words(
    window: tuple[float, float],
    times_up: Sequence[TimeUp],
    rose: float | None,
    in_bed: float,
    unknown: float,
) -> str:
    if in_bed <= 0.0:
        return f"{_span(window)}: nobody was in bed"
    ups = ", ".join(
        f"{_clock(up.left)}{lasting_words((up.back or up.left) - up.left)}" for up in times_up
    )
    count = len(times_up)
    parts = [
        f"up {count} time{'' if count == 1 else 's'}" + (f" ({ups})" if ups else ""),
        f"in bed{lasting_words(in_bed)}",
    ]
    if rose is not None:
        parts.append(f"rose at {_clock(rose)}")
    if unknown > 0.0:
        parts.append(f"not known{lasting_words(unknown)}")
    return f"{_span(window)}: {', '.join(parts)}"


def _span(window: tuple[float, float]) -> str:
    begin, end = (datetime.fromtimestamp(at) for at in window)
    return f"{begin:%Y-%m-%d %H:%M} to {end:%H:%M}"


def _clock(at: float) -> str:
    return datetime.fromtimestamp(at).strftime("%H:%M")
