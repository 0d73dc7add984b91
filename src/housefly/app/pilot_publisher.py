"""What a pilot hears and decides, told to everybody else."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TypeVar

from housefly.bus.bus import Bus
from housefly.bus.topics import DroneTopics, Topic
from housefly.config.process_log import log_traceback
from housefly.messages import Path, PilotStep
from housefly.pilot.behavior.planned_trajectory import planned_trajectory

_Message = TypeVar("_Message")
_TRAJECTORY_PERIOD = 1.0
"""How often the trajectory in use is published again [s]."""


class PilotPublisher:
    """Publishes for a pilot; what cannot be is no reason not to fly, nor to lose a wire.

    Args:
        bus: on which it is told.
        topics: of the drone.

    Attributes:
        problem: what could not be published, in words, or "".
    """

    def __init__(self, bus: Bus, topics: DroneTopics) -> None:
        self._bus, self._topics = bus, topics
        self._path: Path | None = None
        self._path_at = 0.0
        self.problem = ""

    def publish(self, topic: Topic[_Message], message: _Message) -> None:
        """Publish a message, or note why that cannot be."""
        with self._noting(topic.key):
            self._bus.publish(topic, message)

    def publish_step(self, step: PilotStep) -> None:
        """Publish a step, and what is planned in space: when it is new, and for newcomers."""
        self.publish(self._topics.step, step)
        path, now = step.outputs.path, step.now
        if path == self._path and now - self._path_at < _TRAJECTORY_PERIOD:
            return
        self._path, self._path_at = path, now
        with self._noting(self._topics.trajectory.key):
            if (planned := planned_trajectory(path, now)) is not None:
                self._bus.publish(self._topics.trajectory, planned)

    @contextmanager
    def _noting(self, what: str) -> Iterator[None]:
        try:
            yield
        except Exception as error:
            is_first = not self.problem
            self.problem = f"{what} could not be published: {type(error).__name__}: {error}"
            if is_first:
                log_traceback()
