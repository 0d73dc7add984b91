"""Answers about states: yes or no, who is there and how, how often up at night.

Times are Unix time [s].
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from housefly.geometry import Vec3

Verdict = Literal["yes", "no", "unknown"]


@dataclass(frozen=True, slots=True)
class StateAnswer:
    """Whether a thing is in a state.

    Attributes:
        thing, name: of the thing.
        state: as asked.
        answer: "yes", "no" or "unknown".
        words: the answer as a sentence, its verdict first.
        confidence: that the verdict holds, 0 to 1; 0 when unknown.
        age: of the evidence [s]; None without any.
        since: since when it is so; None when not known.
        sources: ids of the sensors and detectors whose word this is.
    """

    thing: str
    name: str
    state: str
    answer: Verdict
    words: str
    confidence: float
    age: float | None
    since: float | None
    sources: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class PersonAnswer:
    """How one person is.

    Attributes:
        person, name: of the person.
        words: all of it as a sentence.
        present: whether they are in the room: "yes", "no" or "unknown".
        posture: walking, standing, sitting, lying, or "" when unknown.
        activity: what they do: "in bed", "on sofa seat 1", "at the refrigerator", "on the floor".
        fallen: confidence that they fell and lie there, 0 to 1.
        carries: ids of what they carry.
        since: since when they are in this posture; None when unknown.
        confidence: in the posture, 0 to 1; 0 when unknown.
        position: world [m]; None when unknown.
        age: of the position [s]; None when never seen.
        evidence: which sources report what, in words.
        sources: their ids.
    """

    person: str
    name: str
    words: str
    present: Verdict
    posture: str
    activity: str
    fallen: float
    carries: tuple[str, ...]
    since: float | None
    confidence: float
    position: Vec3 | None
    age: float | None
    evidence: str
    sources: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class PeopleAnswer:
    """Everybody, by id."""

    at: float
    people: tuple[PersonAnswer, ...]


@dataclass(frozen=True, slots=True)
class TimeUp:
    """One time out of bed: when they left and came back; None when not before the night's end."""

    left: float
    back: float | None


@dataclass(frozen=True, slots=True)
class NightAnswer:
    """One night of one bed or person.

    Attributes:
        thing: id of the bed or the person.
        begin, end: of the window.
        times_up: each time somebody left the bed in the window and came back to it.
        rose: when they left it in the window for good; None when they did not.
        in_bed: for how long the bed was occupied [s].
        unknown: for how much of the window nobody knows [s].
        words: the night as a sentence.
    """

    thing: str
    begin: float
    end: float
    times_up: tuple[TimeUp, ...]
    rose: float | None
    in_bed: float
    unknown: float
    words: str


@dataclass(frozen=True, slots=True)
class NightsAnswer:
    """The nights of one person or bed, or of each bed, by time."""

    nights: tuple[NightAnswer, ...]
