"""What the drone must hear next: the command in force against what the drone last said. Pure; the
driver sends it.

The take-off bit is sent only on the ground and under a take-off order, never while flying: a drone
that has landed by itself would rise again. The emergency bit is a toggle that acts when it rises,
so it is held until the drone's report shows the wanted state (any number of lost datagrams make no
difference), then released; a second press needs a report newer than the release.
"""

from __future__ import annotations

from collections.abc import Callable

from housefly.messages import Action, Command, DroneStatus, Setpoint, Telemetry
from housefly.wires.ardrone import at
from housefly.wires.ardrone.signs import Maxima, pcmd_from_setpoint

HOVER_AFTER = 0.25
"""Silence of the pilot after which a flying drone hovers [s]."""
LAND_AFTER = 2.0
"""Silence of the pilot after which a flying drone lands [s]."""
FRESH = 0.5
"""A report older than this says nothing about now [s]."""
TRIM_TIME = 0.1
"""How long flat trim is repeated before take-off [s]."""
HOLD_TIME = 1.0
"""Longest press of the emergency button [s]; reports later than this could make it press twice."""
RELEASE_TIME = 0.15
"""Shortest pause between two presses [s]."""

AIRBORNE = frozenset({DroneStatus.TAKING_OFF, DroneStatus.FLYING, DroneStatus.LANDING})
GROUNDED = frozenset({DroneStatus.LANDED, DroneStatus.EMERGENCY})

Datagram = tuple[at.Command, ...]

HOVER = at.Pcmd()
LAND = at.Ref(at.RefBits.LAND)
RISE = at.Ref(at.RefBits.TAKE_OFF)
PRESS = at.Ref(at.RefBits.EMERGENCY)


class EmergencyButton:
    """The toggle: held until the drone changes, then released before it may be pressed again."""

    def __init__(self) -> None:
        self._pressed_at: float | None = None
        self._released_at: float | None = None

    def release(self, now: float) -> None:
        """Let go; nothing happens when it is not held."""
        if self._pressed_at is not None:
            self._pressed_at, self._released_at = None, now

    def hold(self, now: float, told_at: float | None) -> bool:
        """Return whether the bit is set now; ``told_at`` is when the newest report came that asks
        for a press [s].
        """
        if self._pressed_at is not None:
            if now - self._pressed_at < HOLD_TIME:
                return True
            self.release(now)
        elif self._released_at is None or (
            told_at is not None and told_at - self._released_at > RELEASE_TIME
        ):
            self._pressed_at = now
            return True
        return False

    def new_order(self, now: float) -> None:
        """Begin anew: the first press does not wait for a report, unless the button was held just
        now.
        """
        self.release(now)
        if self._released_at is not None and now - self._released_at > RELEASE_TIME:
            self._released_at = None


class Orders:
    """Turns the command in force into AT commands, with the driver's own watchdog over the pilot.

    Attributes:
        maxima: what a full stick means to the drone now.
    """

    def __init__(self, maxima: Maxima, now: float) -> None:
        self.maxima = maxima
        self._action = Action.IDLE
        self._setpoint = Setpoint()
        self._heard_at = now
        self._since = now
        self._has_risen = False
        self._must_land = False
        self._button = EmergencyButton()
        self._table: dict[Action, Callable[[float, Telemetry | None], Datagram]] = {
            Action.IDLE: self._idle,
            Action.TAKE_OFF: self._take_off,
            Action.FLY: self._fly,
            Action.HOVER: lambda now, told: (HOVER,),
            Action.LAND: lambda now, told: (LAND, HOVER),
            Action.CUT: self._cut,
            Action.RESET: self._reset,
        }

    def take(self, command: Command, now: float) -> bool:
        """Put a command in force and return whether its action is another than before."""
        self._heard_at = now
        self._setpoint = command.setpoint
        changed = command.action is not self._action
        if changed:
            self._action = command.action
            self._since = now
            self._has_risen = False
            self._button.new_order(now)
        return changed

    def next(self, now: float, told: Telemetry | None) -> Datagram:
        """Return what to send now [s], given the drone's newest report."""
        action = self._watched(now, told)
        if action not in (Action.CUT, Action.RESET):
            self._button.release(now)
        return self._table[action](now, told)

    def _watched(self, now: float, told: Telemetry | None) -> Action:
        """Return the action in force, or what the driver's watchdog puts in its place."""
        airborne = told is not None and told.status in AIRBORNE
        silence = now - self._heard_at
        if silence > LAND_AFTER and airborne:
            self._must_land = True
        elif not airborne:
            self._must_land = False
        if self._action in (Action.CUT, Action.RESET):
            return self._action
        if self._must_land:
            self._has_risen = (
                True  # a take-off order from before the silence must not count again after it
            )
            return Action.LAND
        if silence > HOVER_AFTER and self._action is not Action.LAND:
            return Action.HOVER if airborne else Action.IDLE
        return self._action

    def _idle(self, now: float, told: Telemetry | None) -> Datagram:
        if told is None or now - told.received_at > FRESH:
            return (at.ComWatchdog(),)
        return (LAND, at.ComWatchdog()) if told.status in GROUNDED else (HOVER, at.ComWatchdog())

    def _take_off(self, now: float, told: Telemetry | None) -> Datagram:
        if told is not None and told.status in AIRBORNE:
            self._has_risen = self._has_risen or told.status is not DroneStatus.LANDING
            return (RISE, HOVER) if told.status is DroneStatus.TAKING_OFF else (HOVER,)
        if (
            told is None
            or now - told.received_at > FRESH
            or told.status is not DroneStatus.LANDED
            or self._has_risen
        ):
            return self._idle(now, told)
        if now - self._since < TRIM_TIME:
            return (LAND, at.FlatTrim())
        return (RISE,)

    def _fly(self, now: float, told: Telemetry | None) -> Datagram:
        return (pcmd_from_setpoint(self._setpoint, self.maxima),)

    def _cut(self, now: float, told: Telemetry | None) -> Datagram:
        return self._press(
            now, told, wanted=told is None or told.status is not DroneStatus.EMERGENCY
        )

    def _reset(self, now: float, told: Telemetry | None) -> Datagram:
        if told is not None and told.status in AIRBORNE:
            self._button.release(now)
            return self._idle(now, told)
        return self._press(
            now, told, wanted=told is not None and told.status is DroneStatus.EMERGENCY
        )

    def _press(self, now: float, told: Telemetry | None, *, wanted: bool) -> Datagram:
        if wanted and self._button.hold(now, told.received_at if told else None):
            return (PRESS,)
        self._button.release(now)
        return (LAND,)
