"""What an identification ought to find of a simulated drone, and which constants it missed.

The fit sees the whole way from a command of the pilot to a motion, so its truth is not always the
key of the site:

- ``command_delay`` is the wait for the next datagram, the drone's own delay, and its control period
  with the body rate loop: ``twin.command_delay.reaction_delay``, 60 + 10 + 5 = 75 ms as
  shipped.
- ``yaw_lag`` is fitted with the delay of the tilt. Turning has no body rate loop behind it, so the
  delay is too long by that loop's 1 / RATE_POLE, and the time constant comes out shorter by as
  much: 1 / (1/25 - 1/150) = 30 1/s as shipped. With a profile the simulated drone makes up for it.

Every other constant is the site's.
"""

from __future__ import annotations

from collections.abc import Mapping

from housefly.config.profile import CONSTANTS, Interval
from housefly.config.site import Site
from housefly.config.twin import RATE_POLE
from housefly.twin.command_delay import reaction_delay


def simulated_truth(site: Site) -> dict[str, float]:
    """Return the constants to be found in a flight of the simulated drone, by their keys."""
    drone = site.drone
    yaw = drone.yaw_lag if drone.profile else 1.0 / (1.0 / drone.yaw_lag - 1.0 / RATE_POLE)
    return {key: float(getattr(drone, key)) for key in CONSTANTS} | {
        "command_delay": reaction_delay(site),
        "yaw_lag": min(yaw, CONSTANTS["yaw_lag"].high),
    }


def missed_constants(
    constants: Mapping[str, Interval], truth: Mapping[str, float]
) -> tuple[str, ...]:
    """Return the keys whose interval does not hold the truth."""
    return tuple(
        key
        for key, found in constants.items()
        if key in truth and not found.low <= truth[key] <= found.high
    )
