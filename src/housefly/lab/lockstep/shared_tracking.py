"""One tracking system that several pilots listen to, without wires."""

from __future__ import annotations

from collections.abc import Sequence

from housefly.messages import Sighting
from housefly.twin.contracts import MocapFrame, TwinWorld
from housefly.twin.faults.injector import FaultInjector


class SharedTracking:
    """Hands each frame to every listener once.

    Args:
        world: whose tracking system.
        faults: what befalls the frames, one after the other.
        listeners: how many there are.
    """

    def __init__(
        self, world: TwinWorld, faults: Sequence[FaultInjector], listeners: int = 1
    ) -> None:
        self._world, self._faults = world, faults
        self._unheard: list[list[Sighting]] = [[] for _ in range(listeners)]

    def sightings(self, listener: int = 0) -> tuple[Sighting, ...]:
        """Return what tracking reported since this listener asked last, oldest first."""
        frames = self._world.mocap_frames()
        for faults in self._faults:
            frames = faults.frames(frames, self._world.now)
        fresh = [sighting for frame in frames for sighting in _sightings_of(frame)]
        for unheard in self._unheard:
            unheard.extend(fresh)
        heard, self._unheard[listener] = self._unheard[listener], []
        return tuple(heard)


def _sightings_of(frame: MocapFrame) -> tuple[Sighting, ...]:
    """Return the sightings of the bodies that a frame shows."""
    return tuple(
        Sighting(name, pose, frame.captured_at, frame.due_at)
        for name, pose in frame.bodies
        if pose is not None
    )
