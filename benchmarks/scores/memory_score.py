"""Scores the memory's answers on the truth of scenes that are played in fast time.

``scores.played_memory`` is asked "where is it" once a second.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import StrEnum
from math import hypot
from pathlib import Path

from housefly.geometry import Vec3
from housefly.hub.api.answers import AlternativePlace, PlacedAnswer, WhereAnswer
from housefly.hub.api.questions import ContentsQuestion, WhereQuestion
from housefly.hub.things_of_room import surfaces_of
from housefly.sites.loaded_site import LoadedSite
from housefly.twin.people import Scene, SceneState
from scores.played_memory import DEVICE_PERIOD, PlayedMemory

_ASK_EVERY = 10
"""Device periods between two rounds of questions."""
_SAME_PLACE = 0.5
"""An answer within this distance of the truth over the floor is right [m]."""
_BOXES = ("cabinet", "refrigerator")
"""Kinds of devices that list their contents."""


class AnswerGrade(StrEnum):
    """What an answer is worth."""

    RIGHT = "right"
    DOUBT = "honest doubt"
    UNNAMED = "doubt, truth not named"
    WRONG = "confident error"


@dataclass(frozen=True, slots=True)
class JudgedAnswer:
    """One answer, judged on the truth.

    Attributes:
        at: when it was asked [s, Unix time].
        thing: what it is about.
        kind: "object", "person", or "contents" of a box.
        verdict: what it is worth.
        first_right: whether its first hypothesis holds, whatever doubt it names.
        confidence: in that one, 0 to 1.
        words: the answer.
    """

    at: float
    thing: str
    kind: str
    verdict: AnswerGrade
    first_right: bool
    confidence: float
    words: str


class ScoredRoom:
    """One room whose memory is asked while scenes are played in it, one after the other.

    Args:
        loaded: site and room.
        folder: for the memory's file.
        begin: Unix time of the first scene's begin [s].
    """

    def __init__(self, loaded: LoadedSite, folder: Path, begin: float) -> None:
        self._memory = PlayedMemory(loaded, folder, begin)
        self._surfaces = surfaces_of(loaded.room)

    def close(self) -> None:
        """Close the memory."""
        self._memory.close()

    def play(self, scene: Scene) -> Iterator[JudgedAnswer]:
        """Play one round of a scene, ask once a second, and yield the answers, judged."""
        self._memory.listen_to(scene)
        began = self._memory.now
        for step in range(int(scene.length / DEVICE_PERIOD)):
            self._memory.advance()
            if step % _ASK_EVERY == 0:
                yield from self._judged(scene, scene.at(self._memory.now - began))
        self._memory.now += DEVICE_PERIOD

    def _judged(self, scene: Scene, truth: SceneState) -> Iterator[JudgedAnswer]:
        for name in truth.things:
            yield self._judge(name, "object", truth)
        for person in scene.script.people:
            if not person.visitor:  # seen by tracking, which a scene alone does not have
                yield self._judge(person.name, "person", truth)
        for device in scene.script.devices:
            if device.kind in _BOXES:
                yield self._judge_contents(device.id, truth)

    def _judge(self, name: str, kind: str, truth: SceneState) -> JudgedAnswer:
        answer = self._memory.ask(WhereQuestion(name))
        assert isinstance(answer, WhereAnswer)
        right = _is_right(answer, name, truth)
        named = right or any(self._is_there(one, name, truth) for one in answer.alternatives)
        verdict = _verdict(answer, right, named)
        return JudgedAnswer(
            self._memory.now, name, kind, verdict, right, answer.confidence, answer.words
        )

    def _is_there(self, other: AlternativePlace, name: str, truth: SceneState) -> bool:
        """Return whether an alternative is the truth: its place, or the top that it names."""
        if _is_near(other.position, name, truth):
            return True
        thing = truth.things.get(name)
        tops = [top for top in self._surfaces if top.thing == other.thing]
        return thing is not None and any(top.distance(thing.position[:2]) == 0.0 for top in tops)

    def _judge_contents(self, box: str, truth: SceneState) -> JudgedAnswer:
        answer = self._memory.ask(ContentsQuestion(box))
        assert isinstance(answer, PlacedAnswer)
        told = {thing.thing for thing in answer.things}
        right = told == {thing.name for thing in truth.inside(box)}
        verdict = AnswerGrade.RIGHT if right else AnswerGrade.WRONG
        words = ", ".join(sorted(told))
        return JudgedAnswer(self._memory.now, box, "contents", verdict, right, 1.0, words)


def _verdict(answer: WhereAnswer, right: bool, named: bool) -> AnswerGrade:
    if answer.alternatives:
        return AnswerGrade.DOUBT if named else AnswerGrade.UNNAMED
    if answer.position is None and not answer.inside:
        return AnswerGrade.UNNAMED
    return AnswerGrade.RIGHT if right else AnswerGrade.WRONG


def _is_right(answer: WhereAnswer, name: str, truth: SceneState) -> bool:
    """Return whether the first hypothesis names who holds the thing, or where it stands."""
    thing = truth.things.get(name)
    holder = "" if thing is None else thing.inside or thing.held_by
    if answer.inside or holder:
        return bool(answer.inside) and answer.inside[0] == holder
    return _is_near(answer.position, name, truth)


def _is_near(position: Vec3 | None, name: str, truth: SceneState) -> bool:
    """Return whether a place is that of a thing or a person, over the floor."""
    people = {person.name: person.position for person in truth.people}
    x, y = people[name] if name in people else truth.things[name].position[:2]
    return position is not None and hypot(position[0] - x, position[1] - y) <= _SAME_PLACE
