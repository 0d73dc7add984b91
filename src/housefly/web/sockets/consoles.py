"""The consoles of all drones of a room: a browser looks at one of them, STOP is for all."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from housefly.messages import OrderKind, Severity
from housefly.messages.words import Words
from housefly.web.control.restart_objection import restart_objection
from housefly.web.messages.server_messages import TasksMessage
from housefly.web.sockets.console import Console
from housefly.web.viewers.viewers import UNNAMED


@dataclass(frozen=True, slots=True)
class DroneView:
    """One drone in the list of them.

    Attributes:
        name: of the drone.
        headline: what it does, in one line.
        may_be_airborne: whether one must reckon with that it flies.
        stopped: whether a STOP holds.
        battery: charge, 0 to 1; None where it does not say.
        control: name of who has control, or "".
    """

    name: str
    headline: Words
    may_be_airborne: bool
    stopped: bool
    battery: float | None
    control: str


@dataclass(frozen=True, slots=True)
class DronesView:
    """The drones of the room, in the order of the site."""

    drones: tuple[DroneView, ...]


class Consoles(Mapping[str, Console]):
    """The consoles by the names of their drones; at least one.

    Attributes:
        first: what a browser sees that names none.
    """

    def __init__(self, consoles: Mapping[str, Console]) -> None:
        self._consoles = dict(consoles)
        self.first = next(iter(self._consoles.values()))
        for console in self._consoles.values():
            console.stop_all = self.stop

    def __getitem__(self, name: str) -> Console:
        return self._consoles[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._consoles)

    def __len__(self) -> int:
        return len(self._consoles)

    def named(self, name: str) -> Console | None:
        """Return the console of a drone, the first for "", None where there is no such drone."""
        return self._consoles.get(name) if name else self.first

    def stop(self, sender: str, session: str = "", drone: str = "") -> None:
        """Send STOP to a drone, to all for ""."""
        for name, console in self._consoles.items():
            if drone in ("", name):
                console.stop(sender, session)

    def land(self, sender: str, session: str = "", drone: str = "") -> None:
        """Let a drone land, all that may be in the air for ""."""
        for name, console in self._consoles.items():
            if drone == name or (not drone and console.flying):
                console.order_calmly(OrderKind.LAND, sender, session)

    def view(self) -> DronesView:
        """Return the list of the drones."""
        return DronesView(tuple(_seen(name, one) for name, one in self._consoles.items()))

    def name_of_owner(self, owner: str) -> str:
        """Return the name that others see for a session's owner."""
        names = (console.viewers.name_of_owner(owner) for console in self._consoles.values())
        return next((name for name in names if name != UNNAMED), UNNAMED)

    def name_of_tab(self, owner: str, tab: str) -> str:
        """Return the name that others see for a tab of a session's owner."""
        return self._in_control(owner, tab).name_of_tab(owner, tab)

    def control_objection(self, owner: str, tab: str) -> Words:
        """Return why this tab has control of no drone, in words, or UNSAID."""
        return self._in_control(owner, tab).control_objection(owner, tab)

    def _in_control(self, owner: str, tab: str) -> Console:
        """Return the console of the drone that a tab has control of; the first for none."""
        consoles = self._consoles.values()
        held = (one for one in consoles if not one.control_objection(owner, tab))
        return next(held, self.first)

    def announce(self, words: Words) -> None:
        """Put a line into everybody's event log."""
        self.first.announce(words)
        for console in self._consoles.values():
            if console is not self.first:
                console.feed.log_event(Severity.INFO, "room", words)

    def restart_objection(self, tasks: TasksMessage) -> str:
        """Return why the pilots may not be started again now, in words, or ""."""
        found = (restart_objection(one.verdict(), tasks) for one in self._consoles.values())
        return next(filter(None, found), "")


def _seen(name: str, console: Console) -> DroneView:
    verdict, step = console.verdict(), console.feed.step
    telemetry = None if step is None else step.inputs.telemetry
    return DroneView(
        name,
        verdict.headline,
        verdict.may_be_airborne,
        console.feed.stop.holds,
        None if telemetry is None else telemetry.battery,
        verdict.control,
    )
