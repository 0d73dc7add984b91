"""Looks at a drone as its driver does, orders nothing, and says what keeps it on the floor."""

from __future__ import annotations

import asyncio

from housefly.app.doctor import MachineCheck
from housefly.clock import RealClock
from housefly.config.airframe import airframe_names
from housefly.config.drone import DroneConfig
from housefly.config.limits import LimitsConfig
from housefly.config.text import did_you_mean
from housefly.drones import driver_of
from housefly.drones.contract import CarriesDecks, DroneDriver
from housefly.errors import ConfigError, HouseflyError
from housefly.messages import DroneStatus

_REPORTS_TIME = 1.5
"""How long its reports are listened to [s]."""
_JOIN_NETWORK = "switch it on, and join its network; then its address"
_REMEDIES = {
    "serial": "plug it in; `ls /dev/ttyACM* /dev/ttyUSB*` shows its name; close what else uses it",
    "radio": "plug the radio in, and switch the drone on; then its address",
}
"""What mends a link of each kind of address."""
_RATE_MIN = 5.0
"""Fewer reports a second say that the link is poor."""


def drone_at(uri: str) -> DroneConfig:
    """Return the drone of a URI, ``crazyflie://192.168.4.20``.

    Raises:
        ConfigError: it is none, or there is no such model.
    """
    kind, sign, address = uri.partition("://")
    if not (sign and address):
        raise ConfigError(
            "--drone", f"is {uri!r}; allowed: MODEL://ADDRESS, as crazyflie://10.0.0.2"
        )
    if kind not in airframe_names():
        known = airframe_names()
        meant = did_you_mean(kind, known) or f"; allowed: {', '.join(known)}"
        raise ConfigError("--drone", f"there is no model {kind!r}{meant}")
    return DroneConfig(kind=kind, address=address, has_video=False)


def look_at_drone(config: DroneConfig) -> tuple[MachineCheck, ...]:
    """Connect to a drone, listen for a moment, and return what was found."""
    return asyncio.run(_look(config))


async def _look(config: DroneConfig) -> tuple[MachineCheck, ...]:
    driver = driver_of(config, LimitsConfig(), RealClock())
    try:
        await driver.connect()
        await asyncio.sleep(_REPORTS_TIME)
        return _found(config, driver)
    except (HouseflyError, OSError) as error:
        remedy = _REMEDIES.get(config.address.partition(":")[0], _JOIN_NETWORK)
        return (MachineCheck(f"link to {config.address}", False, str(error), remedy),)
    finally:
        await driver.close()


def _decks(driver: DroneDriver) -> tuple[MachineCheck, ...]:
    """Return what was found on a drone that tells it where it is, if that is looked for."""
    if not isinstance(driver, CarriesDecks):
        return ()
    found = ", ".join(driver.decks) or "none that tells it where it is"
    return (MachineCheck("decks", True, found),)


def _found(config: DroneConfig, driver: DroneDriver) -> tuple[MachineCheck, ...]:
    report, rate = driver.telemetry, driver.telemetry_rate_hz
    firmware = driver.firmware or "unknown firmware"
    link = MachineCheck(
        f"link to {config.address}", True, f"{config.airframe.name} answers, {firmware}"
    )
    reports = MachineCheck(
        "reports", rate >= _RATE_MIN, f"{rate:.0f} a second", "go nearer, or free its radio channel"
    )
    if report is None:
        return link, reports
    is_ready = report.status is DroneStatus.LANDED
    return (
        link,
        reports,
        MachineCheck(
            "state", is_ready, report.status.value, "set it on the floor, upright; end an emergency"
        ),
        MachineCheck(
            "battery",
            report.battery >= LimitsConfig().battery_floor,
            f"{100 * report.battery:.0f} %",
            "charge it",
        ),
        MachineCheck(
            "settings",
            report.configured,
            "written and read back" if report.configured else "not as they should be",
            "switch it off and on, and look again",
        ),
        *_decks(driver),
        *(MachineCheck("it says", False, note) for note in report.notes),
        *(MachineCheck("it complains", False, fault.value) for fault in report.faults),
    )
