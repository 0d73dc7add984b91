"""What the pilot may ask of an estimator; mode default and mode paper have one each."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from housefly.geometry import Vec2
from housefly.messages import Estimate, Event, Sighting
from housefly.pilot.estimation.intake import Refused


@dataclass(frozen=True, slots=True)
class Forecast:
    """What control needs: the horizontal state at the moment when a command given now will act.

    Attributes:
        position: world xy [m].
        velocity: world xy [m/s].
        disturbance: steady push that the command must cancel [m/s^2].
    """

    position: Vec2
    velocity: Vec2
    disturbance: Vec2


class Estimator(Protocol):
    """Turns stamped sightings and the commands given into where the drone is."""

    def see(self, sightings: tuple[Sighting, ...], now: float, grounded: bool) -> tuple[Event, ...]:
        """Take in sightings of the drone's body; on the ground the filter may start anew where the
        drone was carried to.
        """
        ...

    def sent(self, now: float, acceleration: Vec2, flown: bool) -> None:
        """Note the world acceleration [m/s^2] commanded from now on; not flown means that the drone
        flies itself.
        """
        ...

    def estimate(self, now: float) -> Estimate | None:
        """Return where the drone is now, or None before the first sighting."""
        ...

    def forecast(self, now: float) -> Forecast | None:
        """Return the state for control, or None before the first sighting."""
        ...

    @property
    def believed(self) -> Sighting | None:
        """The newest sighting that was taken in."""
        ...

    @property
    def refused(self) -> Refused:
        """How many sightings were not believed, and why."""
        ...
