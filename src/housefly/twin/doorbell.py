"""The doorbell of the simulated room: a visitor comes, presses it, waits, and leaves again."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from housefly.bus.simulated_bell import BellPress

_APPROACH = 1.0
"""From the wish that somebody rings to the press [s]."""
_PATIENCE = 240.0
"""So long a visitor who came to ring waits after the last press [s]: the question, and a visit."""


class _Door(Protocol):
    """Who stands at the door."""

    @property
    def visitor_present(self) -> bool:
        """Whether the visitor is at the door."""
        ...

    def set_visitor(self, present: bool) -> None:
        """A visitor comes to the door or leaves."""
        ...


@dataclass(frozen=True, slots=True)
class BellWire:
    """What the bell tells the house with.

    Attributes:
        press: sends that the bell was pressed.
        problem: why nobody would hear it, in words, or "".
    """

    press: Callable[[], None]
    problem: Callable[[], str]


class Doorbell:
    """Lets a visitor come and press the bell; all calls belong to one thread.

    Args:
        entrance: where the visitor comes to.
        wire: what the bell tells the house with; None for a bell without a wire.
    """

    def __init__(self, entrance: _Door, wire: BellWire | None = None) -> None:
        self._entrance, self._wire = entrance, wire
        self._press_at: float | None = None
        self._leave_at: float | None = None

    def ring(self, now: float, unix: float) -> BellPress:
        """Let somebody ring.

        Args:
            now: time of the room [s].
            unix: the same moment [Unix time, s].
        """
        has_wire = self._wire is not None
        if self._press_at is not None:
            return BellPress(False, "a visitor is about to press the bell", unix, has_wire)
        if self._wire is not None and (problem := self._wire.problem()):
            return BellPress(False, f"the bell cannot tell anybody: {problem}", unix, has_wire)
        waits = self._entrance.visitor_present
        if not waits:
            self._entrance.set_visitor(True)
        self._press_at = now + _APPROACH
        if not waits or self._leave_at is not None:
            self._leave_at = self._press_at + _PATIENCE
        words = "the visitor rings again" if waits else "a visitor comes to the door and rings"
        return BellPress(True, words, unix + _APPROACH, has_wire)

    def advance(self, now: float) -> None:
        """Press the bell, and leave, when it is time [s]."""
        if self._press_at is not None and now >= self._press_at:
            self._press_at = None
            if self._wire is not None:
                self._wire.press()
        if self._leave_at is not None and now >= self._leave_at:
            self._leave_at = None
            self._entrance.set_visitor(False)
