"""What is known of the room now, and what Home Assistant is to show of it."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from dataclasses import replace

from housefly.clock import Clock
from housefly.config.house_mode import HouseMode
from housefly.config.site import Site
from housefly.homeassistant.device_entities import (
    bell_message,
    device_entities,
    device_states,
    is_device,
)
from housefly.homeassistant.drone_entities import drone_entities
from housefly.homeassistant.drone_state import drone_states, shown_estimate
from housefly.homeassistant.entities import HomeEntity
from housefly.homeassistant.room_entities import (
    REPLY,
    board_states,
    room_device,
    room_entities,
    situation_states,
    text_state,
)
from housefly.homeassistant.topics import HomeTopics
from housefly.hub.api.answers import News, SensorAnswer, SituationAnswer, SourceAnswer
from housefly.messages import Estimate, PilotStep
from housefly.room.model import Place, Room
from housefly.tasks.api.answers import TaskBoard

STEP_AGE_MAX = 2.0
"""A pilot that was not heard for longer is not there [s]."""
BOARD_AGE_MAX = 4.0
"""Tasks that neither told nor answered anything for longer are not there [s]."""
_EVENT_AGE_MAX = 30.0
"""Older events are no news [s]."""
_HOME = "home"
"""The place of the pad: one comes there by returning."""

HomeMessage = tuple[str, bytes]
"""A topic, and what is published there once."""


class HomeView:
    """Keeps the newest of everything; all methods are safe from any thread.

    Args:
        site: what is shown, and what may be asked for.
        room: its places and pads.
        clock: for ages.
    """

    def __init__(self, site: Site, room: Room, clock: Clock) -> None:
        home = site.homeassistant
        self.topics = HomeTopics(site.mqtt.site, home.prefix)
        self._site, self._clock, self._lock = site, clock, threading.Lock()
        self._room, self._may_ask = room_device(site.name), home.requests != "off"
        self._pads = {name: pad_of(site, room, name) for name in site.drone_names}
        self.places: tuple[Place, ...] = room.places
        self._steps: dict[str, tuple[float, PilotStep]] = {}
        self._shown_at: dict[str, Estimate | None] = {}
        self._board: tuple[float, TaskBoard] | None = None
        self._situations: tuple[SituationAnswer, ...] = ()
        self._sensors: dict[str, SensorAnswer] = {}
        self._sources: dict[str, SourceAnswer | None] = {}
        self._tell_battery: set[str] = set()
        self._reply = "none"
        self._entities: tuple[HomeEntity, ...] = ()
        self._shown: object = None

    def hear_step(self, drone: str, step: PilotStep) -> None:
        """Take a step of a pilot."""
        self._steps[drone] = self._clock.now(), step

    def hear_board(self, board: TaskBoard) -> None:
        """Take what the tasks tell."""
        self._board = self._clock.now(), board

    def hear_news(self, news: News) -> list[HomeMessage]:
        """Take what changed in the room; returns what is to be told at once."""
        self._situations = news.situations
        fresh = [event for event in news.events if news.at - event.at <= _EVENT_AGE_MAX]
        return [told for event in fresh if (told := bell_message(event, self.topics))]

    def hear_sensors(self, sensors: Sequence[SensorAnswer]) -> None:
        """Take how the sensors do; one that is no longer told of stays, as not there."""
        with self._lock:
            gone = {
                name: replace(sensor, connected=False) for name, sensor in self._sensors.items()
            }
            self._sensors = gone | {sensor.sensor: sensor for sensor in sensors}

    def hear_source(self, sensor: str, source: SourceAnswer | None) -> None:
        """Take what a device last reported."""
        with self._lock:
            self._sources[sensor] = source
            if source is not None and "battery" in source.facts:
                self._tell_battery.add(sensor)

    def hear_situations(self, situations: tuple[SituationAnswer, ...]) -> None:
        """Take what holds now."""
        self._situations = situations

    def hear_reply(self, words: str) -> None:
        """Take what became of the last thing that was asked for."""
        self._reply = words

    @property
    def devices(self) -> tuple[str, ...]:
        """The devices whose reports are shown."""
        with self._lock:
            return tuple(name for name, sensor in self._sensors.items() if is_device(sensor))

    def board(self) -> TaskBoard | None:
        """Return the board of the tasks; None while nobody keeps it."""
        known = self._board
        fresh = known is not None and self._clock.now() - known[0] <= BOARD_AGE_MAX
        return known[1] if known is not None and fresh else None

    def mode(self) -> HouseMode | None:
        """Return the mode of the house; None while nobody tells it."""
        board = self.board()
        return board.mode if board is not None else None

    def entities(self) -> tuple[HomeEntity, ...]:
        """Return all entities; the same value as long as there are no others."""
        with self._lock:
            told = [
                (sensor, name in self._tell_battery)
                for name, sensor in sorted(self._sensors.items())
            ]
            key = [(one.sensor, one.kind, one.title, tells) for one, tells in told]
            if key != self._shown:
                self._shown, self._entities = key, self._all_entities(told)
            return self._entities

    def states(self) -> dict[str, bytes]:
        """Return what every topic is to hold now, attributes first.

        Whoever reacts to a state finds the attributes that belong to it.
        """
        with self._lock:
            sensors, sources = tuple(self._sensors.values()), dict(self._sources)
        found = {
            **board_states(self.board(), self.topics),
            **situation_states(self._situations, self.topics),
            self.topics.state(REPLY): text_state(self._reply),
        }
        for sensor in sensors:
            found |= device_states(sensor, sources.get(sensor.sensor), self.topics)
        now = self._clock.now()
        for name, pad in self._pads.items():
            heard = self._steps.get(name)
            if heard is not None:
                self._shown_at[name] = shown_estimate(self._shown_at.get(name), heard[1])
            found |= drone_states(
                name,
                heard[1] if heard else None,
                self._shown_at.get(name),
                pad,
                self.places,
                self.topics,
                is_heard=heard is not None and now - heard[0] <= STEP_AGE_MAX,
            )
        return dict(
            sorted(found.items(), key=lambda shown: not self.topics.is_attributes(shown[0]))
        )

    def _all_entities(self, told: list[tuple[SensorAnswer, bool]]) -> tuple[HomeEntity, ...]:
        topics, home = self.topics, self._site.homeassistant
        found = list(room_entities(self._room, topics, may_ask=self._may_ask))
        for name in self._pads:
            shown = self._site.for_drone(name).drone
            found += drone_entities(
                name,
                (place for place in self.places if place.name != _HOME),
                topics,
                may_ask=self._may_ask,
                has_pictures=home.pictures and shown.has_video and shown.has_camera,
            )
        for sensor, tells_battery in told:
            found += device_entities(sensor, self._room, topics, has_battery=tells_battery)
        return tuple(found)


def pad_of(site: Site, room: Room, drone: str) -> tuple[float, float]:
    """Return where a drone starts and lands, world xy [m]."""
    own = site.for_drone(drone).drone.pad
    return (own[0], own[1]) if own is not None else room.home
