"""What happened, as sentences with the names that people use."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING

from housefly.hub.person_status import spoken_name, spoken_seat
from housefly.hub.situations.kinds import OF_PEOPLE
from housefly.hub.situations.situation import SOURCE_PREFIX

if TYPE_CHECKING:
    from housefly.hub.api.answers import EventAnswer

_SENTENCES: dict[str, str] = {
    "object taken": "{who} took {thing}{from}",
    "object put": "{who} put {thing}{into}",
    "object missing": "{thing} is missing",
    "object missing ended": "{thing} is back",
    "person present": "{thing} is here",
    "person present ended": "{thing} is out of sight",
    "person sitting": "{thing} sits{on}",
    "person lying": "{thing} lies{on}",
    "person standing": "{thing} stands",
    "person walking": "{thing} walks",
    "person fallen": "{thing} may have fallen",
    "person fallen ended": "{thing} is up again",
    "bed occupied": "somebody is in {thing}",
    "bed occupied ended": "{thing} is empty",
    "bed left": "{thing} is empty",
    "appliance on": "{thing} is on",
    "appliance on ended": "{thing} is off",
    "contact open": "{thing} is open",
    "contact open ended": "{thing} is closed",
    "door opened": "{thing} was opened",
    "door closed": "{thing} was closed",
    "door open too long": "{thing} is open for too long",
    "door open too long ended": "{thing} is closed at last",
    "someone at the entrance": "{who} is at the entrance",
    "someone at the entrance ended": "nobody is at the entrance any more",
    "bell pressed": "the bell rang",
    "motion seen": "{thing} saw motion",
    "memory started": "the memory started",
    "flight started": "{thing} sets out{purpose}",
    "flight ended": "the flight ended",
    "task asked": "task {task} was asked for by {by}: {title}",
    "task started": "task {task} began: {title}",
    "task paused": "task {task} was paused",
    "task ended": "task {task} ended: {words}",
    "person asked": "asked: {words}",
    "person answered": "{by} answered: {words}",
    "said": "said: {words}",
    "found": "found: {words}",
    "snapshot kept": "a picture was kept{shown}",
    "clip kept": "a clip was kept{shown}",
    "rule fired": "the rule {rule}: {words}",
}
"""One sentence a kind of event; what it has no fact for is said without."""
_FOR_PROGRAMS = frozenset({
    "noticed_at", "sigma", "lasted", "because", "by_distance", "by_confidence", "evidence",
    "sources", "known", "code", "severity", "speed", "signs", "candidates", "descent",
    "open_since", "limit", "last_seen", "taken_by", "clip", "late", "from", "into", "on", "task",
    "title", "by", "words", "service", "outcome", "goal", "place", "thing", "rule", "x", "y", "z",
})  # fmt: skip
"""Facts that a sentence says already, or that are for programs."""
_UNITS: dict[str, Callable[[float], str]] = {
    "weight": lambda value: f"{value:.2f} kg",
    "load": lambda value: f"{value:.0f} kg",
    "power": lambda value: f"{value:.0f} W",
    "open_for": lambda value: f"for {value:.0f} s",
}


class EventWords:
    """Says events in the names of a room.

    Args:
        names: of its things, by id.
    """

    def __init__(self, names: Mapping[str, str]) -> None:
        self._names = names

    def name(self, thing: str) -> str:
        """Return what people call a thing, with its article."""
        return spoken_name(self._names.get(thing) or thing.replace("-", " "))

    def sentence(self, event: EventAnswer) -> str:
        """Return what happened, how surely, and by whose word."""
        form = _SENTENCES.get(event.kind)
        words = _text(event.facts.get("words", event.kind))
        said = self._filled(form, event) if form else f"{self.name(event.thing)}: {words}"
        facts = [said, *self._facts(event)]
        if form is None and event.cause:
            facts.append(f"by {self.name(event.cause)}")
        doubts = [f"{100 * event.confidence:.0f} % sure"] if event.confidence < 0.995 else []
        sources = str(event.facts.get("sources") or event.source).split(",")
        heard = [one for one in sources if not one.startswith(SOURCE_PREFIX)]
        said_by = f"  ({', '.join([*doubts, *heard])})" if doubts or heard else ""
        return f"{', '.join(facts)}{said_by}"

    def _filled(self, form: str, event: EventAnswer) -> str:
        facts = event.facts
        shown = facts.get("thing") or facts.get("place")
        return form.format(
            thing=self.name(event.thing),
            who=self.name(event.cause) if event.cause else "somebody",
            on=f" on {spoken_seat(str(facts['on']))}" if facts.get("on") else "",
            into=self._place(" in ", facts.get("into")) or " down",
            purpose=f" for {event.cause}" if event.cause else "",
            shown=f": {self.name(str(shown))}" if shown else "",
            **{"from": self._place(" from ", facts.get("from"))},
            **{key: _text(facts.get(key, "-")) for key in ("task", "title", "words", "rule")},
            by=facts.get("by", "somebody"),
        )

    def _place(self, preposition: str, thing: object) -> str:
        return f"{preposition}{self.name(str(thing))}" if thing else ""

    def _facts(self, event: EventAnswer) -> Iterator[str]:
        facts = event.facts
        has_place = event.kind in OF_PEOPLE or bool({"from", "into", "on"} & facts.keys())
        if not has_place and isinstance(x := facts.get("x"), float):
            yield f"at ({x:.1f}, {float(facts.get('y', 0.0)):.1f}) m"
        for key, value in facts.items():
            if key not in _FOR_PROGRAMS and not (key == "load" and "on" in facts):
                yield fact_words(key, value)


def _text(value: str | float | bool) -> str:
    return f"{value:g}" if isinstance(value, float) else str(value)


def fact_words(key: str, value: str | float | bool) -> str:
    """Return a fact with its unit, for example "0.21 kg", "1420 W", "contents cup"."""
    if key in _UNITS and isinstance(value, float):
        return _UNITS[key](value)
    if isinstance(value, bool):
        value = "yes" if value else "no"
    elif isinstance(value, float):
        value = f"{value:.0f}" if abs(value) >= 1000.0 else f"{value:.3g}"
    return f"{key.replace('_', ' ')} {value}"
