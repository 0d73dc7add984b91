"""Tries the wires of a site that is being described, as the product uses them."""

from __future__ import annotations

import asyncio

from housefly.clock import RealClock
from housefly.config.drone import DroneConfig
from housefly.config.limits import LimitsConfig
from housefly.drones import driver_of
from housefly.errors import HouseflyError
from housefly.messages.words import error_words
from housefly.room.draft.model import DraftDrone, DraftTracking
from housefly.room.draft.site_of_draft import tracking_config
from housefly.tracking.live_check import LISTEN_SECONDS, Heard, heard_from
from housefly.tracking.trackers import tracker_of

_REPORTS_TIME = 1.5
"""Time for the rate of the drone's reports to be counted [s]."""


def hear_tracking(tracking: DraftTracking, seconds: float = LISTEN_SECONDS) -> Heard:
    """Listen to a tracking system, in its own frame; raises ConfigError for a bad value."""
    config = tracking_config(tracking)
    wire = config.wire
    where = f"{config.address}:{config.port_of(wire)}" if wire else config.address
    clock = RealClock()

    async def listen() -> Heard:
        try:
            return await heard_from(tracker_of(config, clock), clock, seconds, where)
        except HouseflyError as error:  # such as a part that is not installed
            return Heard(where, 0.0, (), error_words(error))

    return asyncio.run(listen())


def check_drone(drone: DraftDrone) -> tuple[str, ...]:
    """Connect to a drone as its driver does, order nothing, and say what it answers.

    The first word is "well" or "not reached".
    """
    return asyncio.run(_drone_words(drone))


async def _drone_words(drone: DraftDrone) -> tuple[str, ...]:
    driver = driver_of(
        DroneConfig(address=drone.address, has_video=False), LimitsConfig(), RealClock()
    )
    try:
        await driver.connect()
        await asyncio.sleep(_REPORTS_TIME)
        report = driver.telemetry
        if report is None:
            return ("not reached", f"no report came from {drone.address}")
        firmware = driver.firmware or "unknown"
        return (
            "well",
            f"{drone.address} answers {driver.telemetry_rate_hz:.0f} times a second:"
            f" {report.status.value}, battery {100 * report.battery:.0f} %, firmware {firmware}",
            *driver.notes,
        )
    except (HouseflyError, OSError) as error:
        return ("not reached", str(error))
    finally:
        await driver.close()
