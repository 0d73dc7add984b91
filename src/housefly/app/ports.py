"""Checks whether the ports that a site needs on this machine are free."""

from __future__ import annotations

import socket
from dataclasses import dataclass

from housefly.config.site import Site
from housefly.config.tracking import MocapWire
from housefly.errors import LinkError

_DRONE_PORTS = (
    (5554, socket.SOCK_DGRAM, "UDP"),
    (5556, socket.SOCK_DGRAM, "UDP"),
    (5555, socket.SOCK_STREAM, "TCP"),
    (5559, socket.SOCK_STREAM, "TCP"),
)
_TCP, _UDP = (socket.SOCK_STREAM, "TCP"), (socket.SOCK_DGRAM, "UDP")
_TRACKING_PORTS: dict[MocapWire, tuple[str, tuple[tuple[socket.SocketKind, str], ...]]] = {
    "vicon": ("port", (_TCP,)),
    "natnet": ("natnet_port", (_UDP,)),
    "vrpn": ("vrpn_port", (_TCP, _UDP)),
}
"""The key of each protocol's port, and what listens there."""


@dataclass(frozen=True, slots=True)
class PortNeed:
    """Ports that one process or device of a run listens on.

    Attributes:
        name: who listens on them.
        address: IP address or host.
        taken: those that are in use, in words.
        remedy: what to change.
    """

    name: str
    address: str
    taken: tuple[str, ...]
    remedy: str


def port_needs(site: Site, *, web: bool) -> tuple[PortNeed, ...]:
    """Return the ports that a site needs on this machine, and which are in use."""
    needs = []
    if site.twin.enabled:
        address = site.drone.address
        taken = tuple(
            f"{word} {port}" for port, kind, word in _DRONE_PORTS if not _free(address, port, kind)
        )
        needs.append(
            PortNeed("simulated drone", address, taken, "drone.address, for example 127.0.0.2")
        )
        needs += [_tracking_need(site, wire) for wire in site.served_wires]
        needs += [
            _tcp(f"simulated scanner {laser.name}", laser.address, laser.port, "its port")
            for laser in site.lasers
        ]
    if web and site.web.port:
        needs.append(_tcp("console", site.web.host, site.web.port, "web.port, or use --port"))
    return tuple(needs)


def refuse_taken_ports(site: Site, *, web: bool) -> None:
    """Raise LinkError when a port that the site needs is taken, most likely by another Housefly."""
    for need in port_needs(site, web=web):
        if need.taken:
            raise LinkError(
                f"{need.name}: {', '.join(need.taken)} at {need.address} is taken (does another"
                f" Housefly run?); end that program, or change {need.remedy}"
            )


def _tracking_need(site: Site, wire: MocapWire) -> PortNeed:
    address, port = site.tracking.address, site.tracking.port_of(wire)
    key, kinds = _TRACKING_PORTS[wire]
    taken = tuple(f"{word} {port}" for kind, word in kinds if not _free(address, port, kind))
    return PortNeed("simulated tracking system", address, taken, f"tracking.{key}")


def _tcp(name: str, address: str, port: int, remedy: str) -> PortNeed:
    return PortNeed(
        name, address, () if _free(address, port, socket.SOCK_STREAM) else (f"TCP {port}",), remedy
    )


def _free(address: str, port: int, kind: socket.SocketKind) -> bool:
    with socket.socket(socket.AF_INET6 if ":" in address else socket.AF_INET, kind) as probe:
        if kind is socket.SOCK_STREAM:
            # As servers do: a port in TIME_WAIT is free. On UDP this option would hide a listener.
            probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind((address, port))
        except OSError:
            return False
    return True
