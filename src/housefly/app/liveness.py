"""Who is still there: pipes that the kernel closes when their processes are gone.

A pipe tells what the parent-death signal cannot: that signal follows the *thread* that started a
child, and comes again and again.

launcher pipe  written by nobody, held open by the launcher alone; who lands the drone watches it
flight pipe    held open by the launcher and by all who land the drone; everybody else watches it,
               so that the room, the console and the memory stay until the drone is down
"""

from __future__ import annotations

import os
from contextlib import suppress
from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class LivenessPipe:
    """One pipe: it is readable, at its end, as soon as nobody holds its write end any more."""

    read_end: int
    write_end: int

    def release(self) -> None:
        """Close the write end of this process; a second call does nothing."""
        with suppress(OSError):
            os.close(self.write_end)

    def close(self) -> None:
        """Close both ends."""
        self.release()
        with suppress(OSError):
            os.close(self.read_end)


def _new_pipe() -> LivenessPipe:
    return LivenessPipe(*os.pipe())


@dataclass(frozen=True, slots=True)
class ChildDescriptors:
    """What one child inherits.

    Attributes:
        watched: file descriptor that ends when the child shall end.
        held: file descriptor that others watch for the end of this child; -1 for none.
    """

    watched: int
    held: int = -1

    @property
    def inherited(self) -> tuple[int, ...]:
        """The file descriptors to pass on."""
        return (self.watched,) if self.held < 0 else (self.watched, self.held)


@dataclass(frozen=True, slots=True)
class RunLiveness:
    """The two pipes of one run."""

    launcher: LivenessPipe = field(default_factory=_new_pipe)
    flight: LivenessPipe = field(default_factory=_new_pipe)

    def descriptors(self, *, lands: bool) -> ChildDescriptors:
        """Return what a child inherits that lands the drone, or one that stays until it is down."""
        if lands:
            return ChildDescriptors(self.launcher.read_end, self.flight.write_end)
        return ChildDescriptors(self.flight.read_end)

    def close(self) -> None:
        """Close all ends of this process."""
        self.launcher.close()
        self.flight.close()
