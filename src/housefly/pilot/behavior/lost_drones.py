"""Says when another drone is lost sight of in the air, and when it is seen again."""

from __future__ import annotations

from housefly.messages.event_code import EventCode
from housefly.messages.flight import Event, Severity
from housefly.messages.words import Words
from housefly.pilot.behavior.navigator import Navigator


class LostDronesMonitor:
    """Tells what a navigator finds out about the other drones."""

    def __init__(self, navigator: Navigator) -> None:
        self._navigator = navigator
        self._told: tuple[str, ...] = ()

    def step(self, now: float) -> list[Event]:
        """Return what is new at a time [s]."""
        lost, told = self._navigator.lost_drones, self._told
        self._told = lost
        gone = [
            Event(
                now,
                Severity.WARNING,
                EventCode.DRONE_LOST,
                Words(
                    "{who} flew and is not seen any more: its last place is kept clear", who=name
                ),
            )
            for name in lost
            if name not in told
        ]
        back = [
            Event(
                now,
                Severity.INFO,
                EventCode.DRONE_SEEN,
                Words("the last place of {who} is no longer kept clear", who=name),
            )
            for name in told
            if name not in lost
        ]
        return [*gone, *back]
