"""Scores the memory's answers on the truth of scenes that are played in fast time.

Devices of the twin -> their codec -> memory and detectors -> the answer to "where is it", wired as
the hub wires them; no process, no broker, no waiting.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import StrEnum
from math import hypot
from pathlib import Path

from housefly.app.loaded_site import LoadedSite
from housefly.geometry import Vec3
from housefly.hub.api.answers import AlternativePlace, PlacedAnswer, WhereAnswer
from housefly.hub.api.questions import ContentsQuestion, WhereQuestion
from housefly.hub.memory import RoomMemory
from housefly.hub.query_handler import QueryHandler
from housefly.hub.room_status import RoomStatus
from housefly.hub.situation_service import SituationService
from housefly.hub.store.open import open_store
from housefly.hub.things_of_room import catalogue_of, surfaces_of
from housefly.messages import Observation, RoomEvent
from housefly.twin.people import Scene, SceneState
from housefly.twin.sensors.devices import SimulatedDevices
from housefly.wires.devices import Delivered, Placement, decode_reading

_DEVICE_PERIOD = 0.1
"""Time between two looks at what the devices send [s]: the floor reports as often."""
_DETECTORS_EVERY, _ASK_EVERY = 2, 10
"""Device periods between two runs of the detectors, and between two rounds of questions."""
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
        site, store = loaded.site, folder / "room.db"
        things = catalogue_of(site, loaded.room, folder)
        self._memory = RoomMemory(things, lambda: open_store(store), surfaces_of(loaded.room))
        status = RoomStatus(self._memory.writer.report)
        self._situations = SituationService(site, loaded.room, self._memory, status)
        self._now = begin
        self._queries = QueryHandler(self._memory, status, lambda: self._now)
        self._site = site.mqtt.site
        self._surfaces = surfaces_of(loaded.room)

    def close(self) -> None:
        """Close the memory."""
        self._memory.close()

    def play(self, scene: Scene) -> Iterator[JudgedAnswer]:
        """Play one round of a scene, ask once a second, and yield the answers, judged."""
        devices = SimulatedDevices(scene, self._site)
        tags = Placement(things={thing.tag: thing.name for thing in scene.script.things})
        began = self._now
        for step in range(int(scene.length / _DEVICE_PERIOD)):
            self._now = began + step * _DEVICE_PERIOD
            for message in devices.messages(self._now - began, self._now):
                sent = Delivered(message.address, message.channel, message.payload, self._now)
                reading = decode_reading(sent, tags)
                told: tuple[Observation | RoomEvent, ...]
                told = (*reading.observations, *reading.events)
                for item in told:
                    self._memory.add(item)
            if step % _DETECTORS_EVERY == 0:
                self._situations.update(self._now)
            if step % _ASK_EVERY == 0:
                yield from self._judged(scene, scene.at(self._now - began))
        self._now += _DEVICE_PERIOD

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
        answer = self._queries.answer(WhereQuestion(name))
        assert isinstance(answer, WhereAnswer)
        right = _is_right(answer, name, truth)
        named = right or any(self._is_there(one, name, truth) for one in answer.alternatives)
        verdict = _verdict(answer, right, named)
        return JudgedAnswer(self._now, name, kind, verdict, right, answer.confidence, answer.words)

    def _is_there(self, other: AlternativePlace, name: str, truth: SceneState) -> bool:
        """Return whether an alternative is the truth: its place, or the top that it names."""
        if _is_near(other.position, name, truth):
            return True
        thing = truth.things.get(name)
        tops = [top for top in self._surfaces if top.thing == other.thing]
        return thing is not None and any(top.distance(thing.position[:2]) == 0.0 for top in tops)

    def _judge_contents(self, box: str, truth: SceneState) -> JudgedAnswer:
        answer = self._queries.answer(ContentsQuestion(box))
        assert isinstance(answer, PlacedAnswer)
        told = {thing.thing for thing in answer.things}
        right = told == {thing.name for thing in truth.inside(box)}
        verdict = AnswerGrade.RIGHT if right else AnswerGrade.WRONG
        words = ", ".join(sorted(told))
        return JudgedAnswer(self._now, box, "contents", verdict, right, 1.0, words)


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
