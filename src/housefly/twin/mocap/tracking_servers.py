"""The tracking systems that the twin poses as."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from housefly.config.site import Site
from housefly.config.tracking import MocapWire
from housefly.twin.contracts import MocapFrame
from housefly.twin.mocap.natnet_server import NatNetServer
from housefly.twin.mocap.vicon_server import ViconServer
from housefly.twin.mocap.vrpn_server import VrpnServer
from housefly.wires.natnet import NatNetVersion

NATNET_VERSIONS: dict[str, NatNetVersion] = {"3.1": (3, 1), "4.1": (4, 1)}


class TrackingServer(Protocol):
    """The simulated tracking system on one of its wires; all calls belong to one asyncio loop."""

    async def start(self) -> None:
        """Listen; raises LinkError when the address cannot be used."""
        ...

    async def stop(self) -> None:
        """Close the ports and every connection."""
        ...

    def publish(self, frame: MocapFrame) -> None:
        """Hand a frame to every client; returns at once."""
        ...


def tracking_servers(site: Site) -> tuple[TrackingServer, ...]:
    """Return the servers of a site, not started yet."""
    return tuple(MAKERS[wire](site) for wire in site.served_wires)


def _vicon(site: Site) -> TrackingServer:
    return ViconServer(site.tracking.address, site.tracking.port, site.twin.mocap_rate_hz)


def _natnet(site: Site) -> TrackingServer:
    tracking, twin = site.tracking, site.twin
    version = NATNET_VERSIONS[twin.natnet_version]
    return NatNetServer(
        tracking.address,
        tracking.natnet_port,
        twin.natnet_data_port,
        version,
        twin.natnet_group,
        y_up=tracking.up_axis != "z",
    )


def _vrpn(site: Site) -> TrackingServer:
    return VrpnServer(
        site.tracking.address, site.tracking.vrpn_port, y_up=site.tracking.up_axis == "y"
    )


MAKERS: dict[MocapWire, Callable[[Site], TrackingServer]] = {
    "vicon": _vicon,
    "natnet": _natnet,
    "vrpn": _vrpn,
}
"""The server of each protocol."""
