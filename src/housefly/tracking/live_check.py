"""Listens to a tracking system for a few seconds, as the pilot would, and says what it heard."""

from __future__ import annotations

import asyncio
from dataclasses import dataclass
from math import degrees

import numpy as np

from housefly.clock import Clock
from housefly.geometry import Vec3
from housefly.messages import Sighting
from housefly.messages.words import UNSAID, Words, error_words, figure, joined, percentage
from housefly.tracking.contracts import Tracker
from housefly.tracking.counts import UNIT_QUESTION

LISTEN_SECONDS = 3.0
_CONNECT_TIMEOUT = 6.0
"""How long the first frame may take [s]."""
_BODIES_MAX, _POSES_MAX = 40, 4000
_ROOM_MAX = 100.0
"""No tracked room reaches farther from its origin [m]."""
_STILL = 0.01
"""A body that strays farther from its mean was moving [m]."""


@dataclass(frozen=True, slots=True)
class HeardBody:
    """One body as heard: its mean position [m] and last heading [rad] in the tracking frame.

    Attributes:
        rate_hz: how often it was in a frame.
        spread: standard deviation of its position [m].
    """

    name: str
    position: Vec3
    yaw: float
    rate_hz: float
    spread: float

    @property
    def is_still(self) -> bool:
        """Whether it lay still meanwhile."""
        return self.spread <= _STILL


@dataclass(frozen=True, slots=True)
class Heard:
    """What a tracking system said.

    Attributes:
        where: names it.
        rate_hz: frames per second; 0 when none came.
        bodies: by name.
        problem: why nothing came, or what is wrong; UNSAID for nothing.
    """

    where: str
    rate_hz: float
    bodies: tuple[HeardBody, ...]
    problem: Words

    def body(self, name: str) -> HeardBody | None:
        """Return a body by its name, None when it was not seen."""
        return next((body for body in self.bodies if body.name == name), None)


async def heard_from(
    tracker: Tracker,
    clock: Clock,
    seconds: float = LISTEN_SECONDS,
    where: str = "tracking",
    *,
    patience: float = _CONNECT_TIMEOUT,
) -> Heard:
    """Connect as the pilot does, listen, and return what was heard; never raises.

    Args:
        tracker: the client; ends with this call.
        clock: for rates.
        seconds: how long to listen from the first frame on [s].
        where: names the system in words.
        patience: how long the first frame may take [s].
    """
    arrivals: list[float] = []
    seen: dict[str, list[Sighting]] = {}

    def take_in(sightings: tuple[Sighting, ...]) -> None:
        arrivals.append(clock.now())
        for sighting in sightings:
            if sighting.body in seen or len(seen) < _BODIES_MAX:
                poses = seen.setdefault(sighting.body, [])
                if len(poses) < _POSES_MAX:
                    poses.append(sighting)

    work = asyncio.create_task(tracker.run(take_in))
    began = clock.now()
    problem = UNSAID
    try:
        while not work.done():
            await asyncio.sleep(0.02)
            first = arrivals[0] if arrivals else began + patience
            if clock.now() - first >= (seconds if arrivals else 0.0):
                break
        problem = tracker.problem
        if work.done() and not work.cancelled() and (error := work.exception()) is not None:
            problem = error_words(error)
    finally:
        work.cancel()
        await asyncio.gather(work, return_exceptions=True)
    if not arrivals:
        return Heard(where, 0.0, (), problem or Words("nothing came from {name}", name=where))
    length = max(clock.now() - arrivals[0], 1e-3)
    bodies = tuple(_body(name, seen[name], length) for name in sorted(seen))
    return Heard(where, len(arrivals) / length, bodies, problem)


def _body(name: str, sightings: list[Sighting], length: float) -> HeardBody:
    places = np.array([sighting.pose.position for sighting in sightings])
    x, y, z = (float(value) for value in places.mean(axis=0))
    spread = float(np.linalg.norm(places.std(axis=0)))
    return HeardBody(
        name=name,
        position=(x, y, z),
        yaw=sightings[-1].pose.yaw,
        rate_hz=len(sightings) / length,
        spread=spread,
    )


def heard_words(heard: Heard, body: str) -> tuple[Words, ...]:
    """Return what was heard, and whether the drone's body is among it, in words.

    Args:
        heard: what was heard.
        body: the drone's name in the tracking software.
    """
    if heard.rate_hz == 0.0:
        return (Words("heard nothing: {why}", why=heard.problem),)
    words = [
        Words(
            "{name} sends {n} frames a second",
            name=heard.where,
            n=figure(heard.rate_hz, ".0f"),
        )
    ]
    for seen in heard.bodies:
        x, y, z = seen.position
        words.append(
            Words(
                "{name} at ({x}, {y}, {z}) m, heading {a} deg, in {n} % of the frames",
                name=repr(seen.name),
                x=figure(x, ".3f"),
                y=figure(y, ".3f"),
                z=figure(z, ".3f"),
                a=figure(degrees(seen.yaw), "+.0f"),
                n=percentage(min(1.0, seen.rate_hz / heard.rate_hz)),
            )
        )
    if heard.problem:
        words.append(Words("but: {why}", why=heard.problem))
    words += [
        Words(
            "{name} is farther away than any room is long: {ask}",
            name=repr(seen.name),
            ask=UNIT_QUESTION,
        )
        for seen in heard.bodies
        if max(map(abs, seen.position)) > _ROOM_MAX
    ]
    if heard.body(body) is None and UNIT_QUESTION not in heard.problem.values:
        names = joined(", ", (repr(seen.name) for seen in heard.bodies)) or Words("none")
        words.append(
            Words(
                "the drone's body {name} is not among them (seen: {names}): uncover its markers,"
                " or say its name as the tracking software has it",
                name=repr(body),
                names=names,
            )
        )
    if heard.rate_hz < 20.0:
        words.append(Words("fewer than 20 frames a second: fly slowly, or raise the rate"))
    return tuple(words)
