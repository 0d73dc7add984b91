"""How much later than asked a tilt begins: what sending adds, and what the simulated drone does.

A pilot decides at its own rate, datagrams leave at the driver's. So a command waits for the next
datagram, and the one in force is held longer than a tick of the pilot.
"""

from __future__ import annotations

from functools import lru_cache
from math import floor

from housefly.config.airframe import LinkConstants
from housefly.config.site import Site
from housefly.config.twin import INNER_LOOP_DELAY

_DATAGRAMS = 400
"""Sent until the pattern of ticks and datagrams counts as known."""
_ROUNDING = 1e-9


@lru_cache(maxsize=64)
def sending_delay(rate_hz: float, link: LinkConstants) -> float:
    """Return how much later commands act on average because they leave as datagrams [s].

    Against a drone that takes each command at once and holds it for a tick of 1 / ``rate_hz``.
    """
    tick, sent, taken, age = 1.0 / rate_hz, 0.0, 0.0, 0.0
    for _ in range(_DATAGRAMS):
        decided = (floor((sent + link.interval_min) / tick - _ROUNDING) + 1) * tick
        following = min(decided, sent + link.repeat_after)
        held = following - sent
        age += held * (sent - taken + 0.5 * held)
        taken = floor(following / tick + _ROUNDING) * tick
        sent = following
    return age / sent - 0.5 * tick


def simulated_command_delay(site: Site) -> float:
    """Return how long the simulated drone takes from a datagram to obeying it [s].

    It is ``twin.command_delay``. Left out, a drone with a profile takes what makes the whole of its
    way that of the profile; any other takes its airframe's.
    """
    if site.twin.command_delay is not None:
        return site.twin.command_delay
    if not site.drone.profile:
        return site.drone.airframe.response.command_delay
    rest = sending_delay(site.control.rate_hz, site.drone.airframe.link) + INNER_LOOP_DELAY
    return max(0.0, site.drone.command_delay - rest)


def reaction_delay(site: Site) -> float:
    """Return the time from a command of the pilot to the drone's first reaction [s].

    As ``housefly identify`` measures it: sending and the drone's inner loops are in it. Of a real
    drone it is ``drone.command_delay``; of the simulated one it is what its parts add up to.
    """
    if not site.twin.enabled:
        return site.drone.command_delay
    sending = sending_delay(site.control.rate_hz, site.drone.airframe.link)
    whole = simulated_command_delay(site) + sending + INNER_LOOP_DELAY
    return max(0.0, whole)
