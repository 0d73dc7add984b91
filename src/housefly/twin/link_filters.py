"""What stands between a client and a simulated drone, whatever its wire; by default nothing."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from housefly.twin.contracts import OnboardState

Deliver = Callable[[bytes], None]
"""Takes a datagram."""


@dataclass(frozen=True, slots=True)
class LinkFilters:
    """What stands between the client and the drone; by default nothing.

    Attributes:
        uplink: makes of what receives commands what the client's datagrams meet.
        downlink: makes of what sends navdata what the drone's packets meet.
        reported: what is reported of the drone's state.
    """

    uplink: Callable[[Deliver], Deliver] = lambda deliver: deliver
    downlink: Callable[[Deliver], Deliver] = lambda deliver: deliver
    reported: Callable[[OnboardState], OnboardState] = lambda onboard: onboard


UNFILTERED = LinkFilters()
