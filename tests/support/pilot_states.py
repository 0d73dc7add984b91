"""What happens to a fake pilot's drone, for the pages that show it."""

from __future__ import annotations

from fake_pilot import FakePilot

from housefly.messages import DroneStatus, Phase, Severity


def ready(pilot: FakePilot) -> None:
    """Leave it on its pad."""


def flying(pilot: FakePilot) -> None:
    """Let it hover."""
    pilot.status, pilot.phase = DroneStatus.FLYING, Phase.HOLDING


def looking(pilot: FakePilot) -> None:
    """Let it look at something for long."""
    pilot.status, pilot.phase = DroneStatus.FLYING, Phase.LOOKING
    pilot.looking_until = pilot.clock.now() + 600.0


def fault(pilot: FakePilot) -> None:
    """Let it hit something, unseen by tracking."""
    pilot.status, pilot.pose_age = DroneStatus.EMERGENCY, 9.8
    pilot.add_event(Severity.FAULT, "contact", "Motors cut: the drone hit something")


def silent(pilot: FakePilot) -> None:
    """Let it fly, and the pilot say nothing more."""
    flying(pilot)
    pilot.advance(0.0)
    pilot.publishing = False
