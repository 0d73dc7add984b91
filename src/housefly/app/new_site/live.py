"""Tries the wires of a site that is being described, as the product uses them."""

from __future__ import annotations

import asyncio

from housefly.clock import RealClock
from housefly.config.drone import DroneConfig
from housefly.config.limits import LimitsConfig
from housefly.drones import driver_of
from housefly.errors import HouseflyError
from housefly.messages.words import Words, error_words, figure, literal, percentage, said
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


def check_drone(drone: DraftDrone) -> tuple[Words, ...]:
    """Connect to a drone as its driver does, order nothing, and return what it answers."""
    return asyncio.run(_drone_words(drone))


async def _drone_words(drone: DraftDrone) -> tuple[Words, ...]:
    driver = driver_of(
        DroneConfig(kind=drone.model, address=drone.address, has_video=False),
        LimitsConfig(),
        RealClock(),
    )
    try:
        await driver.connect()
        await asyncio.sleep(_REPORTS_TIME)
        report = driver.telemetry
        if report is None:
            return (_not_reached(Words("no report came from {name}", name=drone.address)),)
        answer = Words(
            "{name} answers {n} times a second: {words}, battery {p} %, firmware {firmware}",
            name=drone.address,
            n=figure(driver.telemetry_rate_hz, ".0f"),
            words=said(report.status),
            p=percentage(report.battery),
            firmware=driver.firmware or Words("unknown"),
        )
        return (answer, *map(literal, driver.notes))
    except (HouseflyError, OSError) as error:
        return (_not_reached(error_words(error)),)
    finally:
        await driver.close()


def _not_reached(why: Words) -> Words:
    return Words("not reached: {why}", why=why)
