"""Several simulated rooms on one machine: each instance has addresses and a memory of its own."""

from __future__ import annotations

from ipaddress import IPv4Address, ip_address
from pathlib import Path

from housefly.app.ports import port_needs
from housefly.config.site import Site, changed
from housefly.config.state import database_file
from housefly.errors import ConfigError, HouseflyError
from housefly.hub.store.lock import reserved_store

INSTANCES_MAX = 9
"""So many rooms at most run side by side."""


def site_of_instance(site: Site, instance: int) -> Site:
    """Return a simulated site as it runs beside others of its kind.

    The first stays as it is. Each other gets loopback addresses of its own for drone, tracking and
    scanners (127.0.2.1 for 127.0.0.1 of instance 2), the next ports of console and Foxglove, topics
    and a memory of its own.

    Raises:
        ConfigError: there is no such instance, or the site is not simulated.
    """
    if not 1 <= instance <= INSTANCES_MAX:
        raise ConfigError("--instance", f"is {instance}; allowed: 1 to {INSTANCES_MAX}")
    if instance == 1:
        return site
    if not site.twin.enabled:
        words = "is for simulated rooms; this site has a real drone, which only one run can fly"
        raise ConfigError("--instance", words)
    lasers = [
        laser | {"address": _moved(laser["address"], instance)}
        for laser in site.model_dump()["lasers"]
    ]
    drones = [
        drone | ({"address": _moved(drone["address"], instance)} if "address" in drone else {})
        for drone in site.model_dump()["drones"]
    ]
    return changed(
        site,
        name=f"{site.name} {instance}",
        drone__address=_moved(site.drone.address, instance),
        drones=drones,
        tracking__address=_moved(site.tracking.address, instance),
        lasers=lasers,
        web__port=site.web.port and site.web.port + instance - 1,
        foxglove__port=site.foxglove.port and site.foxglove.port + instance - 1,
        mqtt__site=f"{site.mqtt.site}-{instance}"[-40:],
        mqtt__broker=_moved(site.mqtt.broker, instance) if site.mqtt.start else site.mqtt.broker,
        hub__store=_own_store(site, instance),
    )


def free_instance(site: Site, *, web: bool) -> int:
    """Return the first instance of a site that finds its ports and its memory free; else 1."""
    for instance in range(1, INSTANCES_MAX + 1 if site.twin.enabled else 1):
        if _is_free(site_of_instance(site, instance), web=web):
            return instance
    return 1


def _is_free(site: Site, *, web: bool) -> bool:
    if any(need.taken or need.problem for need in port_needs(site, web=web)):
        return False
    try:
        with reserved_store(site):
            return True
    except HouseflyError:
        return False


def _moved(address: str, instance: int) -> str:
    """Return a loopback address of another instance; any other address stays."""
    try:
        found = ip_address(address)
    except ValueError:
        return address
    if not isinstance(found, IPv4Address) or not found.is_loopback:
        return address
    first, second, third, last = found.packed
    return f"{first}.{second}.{(third + instance) % 256}.{last}"


def _own_store(site: Site, instance: int) -> str:
    """Return where another instance keeps its memory; a default follows the site's name."""
    if not site.hub.store or "://" in site.hub.store:
        return site.hub.store
    file: Path = database_file(site)
    return str(file.with_name(f"{file.stem}-{instance}{file.suffix}"))
