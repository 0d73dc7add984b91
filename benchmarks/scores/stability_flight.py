"""A hover that is pushed once, on a stepped clock: does the drone's true swing die away?"""

from __future__ import annotations

from math import ceil, floor, inf
from typing import NamedTuple

import numpy as np

from housefly.errors import LinkError
from housefly.lab.lockstep.lockstep_room import LockstepRoom
from housefly.lab.lockstep.pilot_loop import PilotLoop
from housefly.messages import Order, OrderKind, Phase, SafetyMode
from housefly.numeric import FloatArray
from housefly.pilot.assembly import make_pilot
from housefly.sites.loaded_site import LoadedSite
from housefly.twin.disturbance import NEUTRAL, Disturbances
from housefly.twin.simulated_body import CONTROL_PERIOD
from housefly.twin.world import SimulatedWorld

_PUSH = Disturbances(wind=(0.4, 0.0, 0.0))
"""So weak that nothing saturates, and no rule of the last gate ends a swing that dies away: 1 to 4
cm.
"""
_ORDER_AT, _LATE_AT, _PUSH_AT, _PUSH_END = 0.5, 4.0, 5.0, 5.5
"""When it is told to take off; counted from the hover, when the drone becomes late, when wind
begins and when it ends [s].
"""
_WINDOW, _WINDOWS = 8.0, 4
"""The swing is measured in windows of two or three periods [s]; the first is not counted."""
_GIVE_UP_AFTER = 60.0
_DYING = 0.9
"""A swing that keeps a smaller share of itself over two windows dies away."""
_STILL = 0.002
"""A swing below this is sensor noise [m]."""


class Swing(NamedTuple):
    """How far the true position swings about its mean, one sigma [m].

    Attributes:
        early: 8 to 16 s after the push.
        late: 24 to 32 s after it; infinite when the last gate had to end the hover.
    """

    early: float
    late: float

    @property
    def dies_away(self) -> bool:
        """Whether the loop is stable."""
        return self.late < max(_DYING * self.early, _STILL)


class _TiringWorld(SimulatedWorld):
    """A room whose drone can be made to obey later while it flies."""

    def obey_later(self, extra: float) -> None:
        """Add to the command delay [s]."""
        self.first.command_delay += extra


def nearest_periods(delay: float) -> tuple[float, float]:
    """Return the multiples of the firmware's period at or below a delay, and at or above it [s]."""
    count = delay / CONTROL_PERIOD
    return floor(count) * CONTROL_PERIOD, ceil(count) * CONTROL_PERIOD


def hover_swing(loaded: LoadedSite, extra: float = 0.0) -> Swing:
    """Fly a hover of the simulated drone, push it once, and return how it swings.

    Args:
        loaded: the site.
        extra: by how much later than the site says it obeys once it hovers [s]; the firmware runs
            every 5 ms, so give a multiple of that.

    Raises:
        LinkError: it did not come to hover.
    """
    world = _TiringWorld(loaded.site, loaded.room)
    pilot = make_pilot(loaded.site, loaded.room, loaded.grid)
    loop = PilotLoop(LockstepRoom(world, loaded.site), pilot, loaded.site.control.rate_hz)
    hovering_at, places, told = inf, list[float](), False
    while loop.now < hovering_at + _PUSH_END + _WINDOW * _WINDOWS:
        loop.advance()
        since = loop.now - hovering_at
        world.disturb(_PUSH if _PUSH_AT <= since < _PUSH_END else NEUTRAL)
        orders: tuple[Order, ...] = ()
        if not told and loop.now >= _ORDER_AT:
            orders, told = (Order(OrderKind.TAKE_OFF),), True
        outputs = loop.step(loop.inputs(*orders)).outputs
        if outputs.phase is Phase.HOLDING and hovering_at == inf:
            hovering_at = loop.now
        if since < _LATE_AT <= since + loop.period:
            world.obey_later(extra)
        if loop.now > _GIVE_UP_AFTER and hovering_at == inf:
            raise LinkError(f"no hover: {outputs.reason}")
        if since > _PUSH_END:
            places.append(world.truth().pose.position[0])
            if outputs.safety is not SafetyMode.NOMINAL:
                return Swing(0.0, inf)
    windows = np.split(np.array(places[: _WINDOWS * round(_WINDOW / loop.period)]), _WINDOWS)
    return Swing(_spread(windows[1]), _spread(windows[3]))


def _spread(places: FloatArray) -> float:
    return float(places.std())
