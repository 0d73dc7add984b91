"""The faults that a person may make on the page of a simulated room, in the catalogue's words."""

from __future__ import annotations

from dataclasses import replace

from housefly.errors import ConfigError
from housefly.messages.words import Words
from housefly.twin.faults.catalogue import row_of
from housefly.twin.faults.fault import OF_THE_ROOM, Fault

STOPPED_MOTOR = "F22/off"
TOLD_ROWS: dict[str, Words] = {
    "F03": Words("no tracking for 5 s, or for good"),
    "F06": Words("the drone and another body are exchanged"),
    "F08": Words("frozen poses under fresh stamps"),
    "F11": Words("tracking falls to 10 Hz"),
    "F12": Words("tracking is late, with or without saying so"),
    "F13": Words("the tracked place drifts, or steps once a second"),
    "F14": Words("30 % of the datagrams to and from the drone are lost"),
    "F17": Words("the link to the drone is lost for good"),
    "F18": Words("the drone falls silent and still obeys"),
    "F19": Words("the pictures stop, are damaged or stand still"),
    "F20": Words("the charge falls off a cliff"),
    "F22": Words("a weak motor, a damaged propeller, a sagging battery"),
    STOPPED_MOTOR: Words("a motor stands still"),
    "F23": Words("held by something: tether, load, fan, wind"),
    "F33": Words("a chair is put on the way"),
    "F34": Words("somebody steps in front, walks up to it, or crosses"),
    "F44": Words("somebody or something is on the pad"),
    "F46": Words("the drone's optical flow fails"),
    "F47": Words("the drone's sonar fails"),
    "F49": Words("the scanners fail"),
}
"""A row, or a variant of one, and what happens; a test holds these against the catalogue."""


def told_fault(row: str, drone: str, now: float, seconds: float) -> tuple[Fault, ...]:
    """Return the faults of a row from now on, each over when its time or the person's is.

    Args:
        row: one of ``TOLD_ROWS``.
        drone: whom it befalls.
        now: world time [s].
        seconds: how long it lasts at most.

    Raises:
        ConfigError: there is no such row.
    """
    if row not in TOLD_ROWS:
        raise ConfigError("fault", f"{row!r} cannot be made here; there are {', '.join(TOLD_ROWS)}")
    number, _, variant = row.partition("/")
    return tuple(
        replace(
            fault.shifted(now),
            duration=min(fault.duration, seconds - fault.start),
            drone="" if fault.component in OF_THE_ROOM else drone,
        )
        for fault in row_of(number).faults_of(variant)
        if fault.start < seconds
    )
