"""Groups what happened into entries of a feed: pure, from events by time."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Protocol

from housefly.hub.api.answers import EventAnswer
from housefly.hub.api.feed_answers import FeedEntry, FeedTopic
from housefly.hub.api.told_events import TOLD_EVENT_SOURCE
from housefly.hub.feed.steps import (
    ALARMS,
    IS_OF_PERSON,
    flown,
    person_step,
    task_step,
    then,
    thing_step,
)
from housefly.hub.feed.worth_reading import worth_reading
from housefly.hub.flight_facts import PILOT
from housefly.messages.words import UNSAID, Words, joined, literal

GAP = 600.0
"""What happens to somebody or something after a pause of this [s] is told anew."""
_STEPS_MAX: dict[FeedTopic, int] = {"people": 4, "things": 2, "drone": 4, "tasks": 1}
_PICTURES_MAX = 4
_CLIPS = ("clip kept", "snapshot kept")
_FLIGHT_BEGINS, _FLIGHT_ENDS = "flight started", "flight ended"
_OF_TASK = "task "
"""So begins who sends a drone for a task, and what keeps a clip for one."""


class RoomNames(Protocol):
    """What people call things, and where something is."""

    def name(self, thing: str) -> str:
        """Return what people call a thing."""
        ...

    def spot(self, x: float, y: float) -> str:
        """Return beside what a place [m] is, "" for nothing."""
        ...


@dataclass(slots=True)
class _Group:
    of: FeedTopic
    thing: str
    name: Words
    began_at: float
    at: float
    steps: list[Words] = field(default_factory=list)
    otherwise: Words = UNSAID
    warning: Words = UNSAID
    pictures: list[str] = field(default_factory=list)
    alarms: bool = False
    of_task: bool = False
    has_found: bool = False

    def add(self, step: Words) -> None:
        """Add what happened next, unless it goes on as before."""
        if step and (not self.steps or self.steps[-1] != step):
            self.steps.append(step)

    def words(self) -> Words:
        """Return what happened, in order; of a long way the end."""
        steps = self.steps[-_STEPS_MAX[self.of] :]
        if self.of == "drone":
            return joined(", ", [*steps, *([self.warning] if self.warning else [])])
        return then(steps) or self.otherwise

    def entry(self) -> FeedEntry:
        """Return it as an entry."""
        pictures = tuple(self.pictures[-_PICTURES_MAX:])
        words, span = self.words(), (self.began_at, self.at)
        return FeedEntry(self.of, self.thing, self.name, words, *span, pictures, self.alarms)


def grouped(
    events: Sequence[EventAnswer], names: RoomNames, topic: FeedTopic | None = None
) -> tuple[FeedEntry, ...]:
    """Return what happened, the newest first.

    Args:
        events: by time.
        names: of the room.
        topic: what is told; None is everything, without the flights that a task tells of.
    """
    groups = _Groups(names)
    for event in worth_reading(events):
        groups.add(event)
    told = [
        group.entry()
        for group in groups.all
        if (group.of == topic if topic else not (group.of_task and not group.alarms))
    ]
    return tuple(sorted((one for one in told if one.words), key=lambda one: -one.at))


class _Groups:
    """Collects groups; the last of each key is open."""

    def __init__(self, names: RoomNames) -> None:
        self.all: list[_Group] = []
        self._names = names
        self._open: dict[tuple[str, str], _Group] = {}

    def add(self, event: EventAnswer) -> None:
        """Add an event."""
        if event.source == TOLD_EVENT_SOURCE:
            self._told(event)
        elif event.source == PILOT:
            self._flown(event)
        elif event.kind in IS_OF_PERSON:
            group = self._group("people", event, event.thing)
            group.add(person_step(event, self._names.spot))
            group.otherwise = event.words
        elif step := thing_step(event, self._names.name):
            self._group("things", event, event.thing).add(step)

    def _group(
        self, of: FeedTopic, event: EventAnswer, key: str, name: Words = UNSAID, gap: float = GAP
    ) -> _Group:
        """Return the group of an event, which it prolongs."""
        found = self._open.get((of, key))
        if found is None or event.at - found.at > gap:
            thing = "" if of == "tasks" else event.thing
            named = name or literal(self._names.name(event.thing))
            found = self._open[of, key] = _Group(of, thing, named, event.at, event.at)
            self.all.append(found)
        found.at = event.at
        found.alarms |= event.kind in ALARMS
        return found

    def _flown(self, event: EventAnswer) -> None:
        """Add a flight, or what a person must know of the drone; all else is for the log."""
        warns = event.facts.get("severity") in ("warning", "fault")
        is_flight = event.kind in (_FLIGHT_BEGINS, _FLIGHT_ENDS)
        goal = str(event.facts.get("goal", "")) if event.kind == "looking" else ""
        if not (warns or is_flight or goal):
            return
        if event.kind == _FLIGHT_BEGINS:
            self._open.pop(("drone", event.thing), None)
        group = self._group("drone", event, event.thing)
        group.alarms |= warns
        if warns:
            # The last one: what went before it led to it.
            group.warning = event.words
        if event.kind == _FLIGHT_BEGINS:
            group.of_task = event.cause.startswith(_OF_TASK)
            group.otherwise = Words("in the air")
            group.add(group.otherwise)
        elif event.kind == _FLIGHT_ENDS:
            if group.otherwise in group.steps:
                group.steps.remove(group.otherwise)
                group.add(flown(event.at - group.began_at))
        elif goal:
            group.add(literal(goal))

    def _told(self, event: EventAnswer) -> None:
        """Add what tasks and house tell."""
        facts = event.facts
        if event.kind in _CLIPS:
            self._picture(event, str(facts.get("clip", "")))
        elif event.kind == "clip deleted":
            for group in self.all:
                group.pictures = [one for one in group.pictures if one != facts.get("clip")]
        elif event.kind == "mode changed":
            name, mode = Words("Mode of the house"), str(facts.get("mode", ""))
            who = event.cause
            by = Words("{what} ({who})", what=mode, who=who) if who else literal(mode)
            self._group("tasks", event, "mode", name, gap=-1.0).add(by)
        elif "task" in facts:
            self._task(event, f"{_OF_TASK}{facts['task']:.0f}")
        elif event.kind == "said":
            said = literal(str(facts.get("words", "")))
            self._group("tasks", event, "said", literal("Housefly"), gap=-1.0).add(said)

    def _task(self, event: EventAnswer, key: str) -> None:
        title = event.facts.get("title") or event.facts.get("service", "")
        group = self._group("tasks", event, key, literal(str(title)), gap=float("inf"))
        # Who asked for it says that it waits for a yes; what it found says more than "done".
        waits = event.kind == "person asked" and len(group.steps) == 1
        is_told = group.has_found and event.facts.get("outcome") == "done"
        if not waits and not is_told:
            group.add(task_step(event))
        group.has_found |= event.kind in ("found", "said")
        group.alarms |= event.facts.get("outcome") == "failed"

    def _picture(self, event: EventAnswer, clip: str) -> None:
        """Add a clip or snapshot to its task; a person's own stands for itself."""
        if event.cause.startswith(_OF_TASK):
            shown = event.facts.get("place") or event.facts.get("thing") or event.cause
            name = literal(str(shown))
            group = self._group("tasks", event, event.cause, name, gap=float("inf"))
            group.otherwise = group.otherwise or Words("a picture was kept")
        else:
            group = self._group("drone", event, event.thing)
            group.add(Words("a picture was kept"))
        group.pictures.append(clip)
