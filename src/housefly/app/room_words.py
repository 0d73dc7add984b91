"""Answers of the room as lines for the terminal."""

from __future__ import annotations

from datetime import datetime
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from housefly.app.event_words import EventWords
    from housefly.hub.api.answers import EventAnswer, PlacedThing, SensorAnswer, SourceAnswer


def said_line(said: SourceAnswer) -> str:
    """Return what one source said of a thing."""
    from housefly.app.event_words import fact_words

    place = "({:.2f}, {:.2f}, {:.2f}) m".format(*said.position) if said.position else ""
    inside = f"in {said.inside}" if said.inside else ""
    facts = ", ".join(fact_words(key, value) for key, value in said.facts.items())
    doubt = "" if said.valid else "not valid"
    words = "  ".join(part for part in (place, inside, facts, doubt) if part)
    return f"  {said.source:<14} {_ago(said.age):<12} {words}"


def moved_line(thing: PlacedThing, now: float) -> str:
    """Return where a thing is now [Unix time, s]."""
    if thing.position:
        place = "({:.2f}, {:.2f}, {:.2f}) m".format(*thing.position)
    else:
        place = f"in {thing.inside}"
    return f"{clock_time(now, now)}  {thing.name}: {place}"


def event_line(event: EventAnswer, now: float, words: EventWords) -> str:
    """Return what happened and when, given the time now [Unix time, s]."""
    return f"{clock_time(event.at, now)}  {words.sentence(event)}"


def detailed_event_line(event: EventAnswer, now: float) -> str:
    """Return an event as it is kept: every fact by its key."""
    from housefly.app.event_words import fact_words

    cause = f" by {event.cause}" if event.cause else ""
    facts = ", ".join(fact_words(key, value) for key, value in event.facts.items())
    sure = "" if event.confidence >= 0.995 else f" ({100 * event.confidence:.0f} % sure)"
    return (
        f"{clock_time(event.at, now)}  {event.thing}:"
        f" {event.kind}{cause}{sure}{'; ' + facts if facts else ''}  [{event.source}]"
    )


def sensor_row(sensor: SensorAnswer) -> tuple[str, ...]:
    """Return a sensor's row: mark, title, kind, rate, age, problem.

    One that speaks, and is not believed, is as little use as one that is lost.
    """
    mark = "LOST" if not sensor.connected else "look" if sensor.problem else "ok"
    rate = f"{sensor.rate_hz:.1f} Hz" if sensor.rate_hz else ""
    return mark, sensor.title or sensor.sensor, sensor.kind, rate, _ago(sensor.age), sensor.problem


def clock_time(at: float, now: float) -> str:
    """Return a Unix time [s] as local time, without the date when it is today."""
    when, today = datetime.fromtimestamp(at), datetime.fromtimestamp(now).date()
    return when.strftime("%H:%M:%S" if when.date() == today else "%Y-%m-%d %H:%M:%S")


def _ago(age: float | None) -> str:
    from housefly.hub.things.words import age_words

    return "never" if age is None else age_words(age)
