"""A simulated drone with an autopilot on board, driven by messages on a stepped clock."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from math import hypot
from typing import Any

from housefly.messages import AnySetpoint, VelocitySetpoint
from housefly.sites.loaded_site import load_site
from housefly.twin.contracts import FlightState
from housefly.twin.mavlink.vehicle import MavlinkVehicle
from housefly.twin.world import SimulatedWorld
from housefly.wires.mavlink import requests
from housefly.wires.mavlink.framing import FrameWriter, messages_in
from housefly.wires.mavlink.poses import pose_message
from housefly.wires.mavlink.requests import CommandId
from housefly.wires.mavlink.setpoints import setpoint_message

TARGET = (1, 1)
STEP = 0.02


@dataclass
class Room:
    """A world, the autopilot in it, and a ground station with a mocap beside it."""

    world: SimulatedWorld
    vehicle: MavlinkVehicle
    has_poses: bool = True
    has_heartbeats: bool = True
    asked: AnySetpoint | None = None
    said: list[str] = field(default_factory=list)
    _writer: FrameWriter = field(default_factory=lambda: FrameWriter(255, 190))

    @property
    def flight(self) -> FlightState:
        return self.world.onboard().flight

    @property
    def speed(self) -> float:
        return hypot(*self.world.truth().velocity[:2])

    @property
    def height(self) -> float:
        return self.world.truth().pose.position[2]

    def tell(self, message: Any) -> list[Any]:
        """Send a message over the wire; return the answers."""
        (read,) = messages_in(self._writer.packed(message))
        return self.vehicle.hear(read)

    def order(self, number: CommandId, *parameters: float) -> int:
        """Send a command; return its result."""
        return int(self.tell(requests.command(TARGET, number, *parameters))[0].result)

    def run(self, seconds: float, until: Callable[[], bool] = lambda: False) -> float:
        """Let time pass; return how much did."""
        begun, beats = self.world.now, 0
        while self.world.now < begun + seconds - 1e-6 and not until():
            if self.has_poses:
                pose = self.world.truth().pose
                self.tell(pose_message(pose, (0.0, 0.0, 0.0), 7.0 + self.world.now))
            if self.asked is not None:
                self.tell(setpoint_message(self.asked, TARGET, self.world.now))
            if self.has_heartbeats and beats % 50 == 0:
                self.tell(requests.heartbeat())
            beats += 1
            self.world.advance(STEP)
            self.said += [one.text for one in self.vehicle.step() if hasattr(one, "severity")]
        return self.world.now - begun

    def set_mode(self, mode: Any) -> int:
        return self.order(CommandId.SET_MODE, 1.0, mode.main, mode.sub)

    def take_off(self) -> None:
        """Bring it into the air, steered and at rest."""
        autopilot = self.vehicle.autopilot
        self.run(0.3)
        self.tell(requests.origin_order(1, 45.0, 7.0, 0.0))
        assert self.set_mode(autopilot.ready) == 0
        assert self.order(CommandId.ARM, 1.0) == 0
        assert self.order(CommandId.TAKE_OFF, *(0.0,) * 6, 1.0) == 0
        self.run(12.0, lambda: self.flight is FlightState.HOVERING)
        self.asked = VelocitySetpoint()
        self.run(1.0)
        assert self.set_mode(autopilot.steered) == 0
        self.run(0.3)


def room_with(model: str) -> Room:
    loaded = load_site("bsen", drone__kind=model, twin__visitor_present=False)
    world = SimulatedWorld(loaded.site, loaded.room)
    return Room(world, MavlinkVehicle(world, model))
