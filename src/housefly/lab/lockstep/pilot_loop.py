"""A pilot and what it flies on one stepped clock, one control period at a time."""

from __future__ import annotations

from dataclasses import replace

from housefly.lab.lockstep.lockstep_room import LockstepRoom
from housefly.messages import Inputs, Order, PilotStep
from housefly.pilot.pilot import Pilot


class PilotLoop:
    """The round of every lock-step flight: ``advance``, ``inputs``, ``step``.

    Args:
        room: world, driver and tracking client.
        pilot: decides.
        rate_hz: of the pilot's steps.

    Attributes:
        room, pilot: as given.
        period: of the pilot's steps [s].
    """

    def __init__(self, room: LockstepRoom, pilot: Pilot, rate_hz: float) -> None:
        self.room, self.pilot, self.period = room, pilot, 1.0 / rate_hz
        self._sequence = 0

    @property
    def now(self) -> float:
        """World time [s]."""
        return self.room.now

    def advance(self) -> None:
        """Let the world run for one period of the pilot."""
        self.room.advance(self.period)

    def inputs(self, *orders: Order) -> Inputs:
        """Return what the pilot is told now; orders that name no time count as given now."""
        return Inputs(
            self.room.sightings(),
            self.room.telemetry(),
            tuple(
                order if order.issued_at else replace(order, issued_at=self.now) for order in orders
            ),
        )

    def step(self, inputs: Inputs) -> PilotStep:
        """Let the pilot decide, and hand its command to the drone."""
        outputs = self.pilot.step(self.now, inputs)
        self.room.send(outputs.command, self.pilot.known_motion)
        self.room.send_pose(self.pilot.external_pose)
        step = PilotStep(self._sequence, self.now, inputs, outputs)
        self._sequence += 1
        return step
