"""Checks whether the ports that a site needs on this machine are free."""

from __future__ import annotations

import errno
import socket
from collections.abc import Iterable
from dataclasses import dataclass

from housefly.config.laser import scip_lasers
from housefly.config.site import Site
from housefly.config.tracking import MocapWire
from housefly.errors import LinkError
from housefly.twin.drone_servers import PORTS

_BESIDE = ", or run a simulated room beside it: --instance 2"
_TCP, _UDP = (socket.SOCK_STREAM, "TCP"), (socket.SOCK_DGRAM, "UDP")
_KINDS = {word: (kind, word) for kind, word in (_TCP, _UDP)}
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
        problem: why nothing can listen at the address at all, in words; "" when it can.
        remedy: what to change.
    """

    name: str
    address: str
    taken: tuple[str, ...]
    problem: str
    remedy: str


def port_needs(site: Site, *, web: bool) -> tuple[PortNeed, ...]:
    """Return the ports that a site needs on this machine, and which are in use."""
    needs = []
    for drone in site.all_drones if site.twin.enabled else ():
        if drone.enabled and drone.kind in PORTS:
            of = f" {drone.name}" if len(site.drone_names) > 1 else ""
            remedy = "drone.address, for example 127.0.0.2"
            ports = [(port, *_KINDS[word]) for port, word in PORTS[drone.kind]]
            needs.append(_need(f"simulated drone{of}", drone.address, ports, remedy))
    if site.twin.enabled:
        if site.tracking.enabled:
            needs += [_tracking_need(site, wire) for wire in site.served_wires]
        needs += [
            _tcp(
                f"simulated scanner {laser.name}", laser.address, laser.port, "its port or address"
            )
            for laser in scip_lasers(site.lasers)
        ]
    if web and site.web.port:
        needs.append(
            _tcp("console", site.web.host, site.web.port, "web.port (or use --port) or web.host")
        )
    if site.foxglove.enabled and site.foxglove.port:
        needs.append(_tcp("Foxglove", site.foxglove.host, site.foxglove.port, "foxglove.port"))
    return tuple(needs)


def refuse_taken_ports(site: Site, *, web: bool) -> None:
    """Raise LinkError when the site cannot listen where it must; the words say why."""
    for need in port_needs(site, web=web):
        if need.problem:
            raise LinkError(
                f"{need.name}: nothing can listen at {need.address} ({need.problem}); change"
                f" {need.remedy}"
            )
        if need.taken:
            raise LinkError(
                f"{need.name}: {', '.join(need.taken)} at {need.address} is taken (does another"
                f" Housefly run?); end that program, change {need.remedy}{_BESIDE}"
            )


def _tracking_need(site: Site, wire: MocapWire) -> PortNeed:
    key, kinds = _TRACKING_PORTS[wire]
    port = site.tracking.port_of(wire)
    return _need(
        "simulated tracking system",
        site.tracking.address,
        ((port, kind, word) for kind, word in kinds),
        f"tracking.{key} or tracking.address",
    )


def _tcp(name: str, address: str, port: int, remedy: str) -> PortNeed:
    return _need(name, address, ((port, *_TCP),), remedy)


def _need(
    name: str,
    address: str,
    ports: Iterable[tuple[int, socket.SocketKind, str]],
    remedy: str,
) -> PortNeed:
    taken, problem = [], ""
    for port, kind, word in ports:
        try:
            _try_to_bind(address, port, kind)
        except OSError as error:
            if error.errno == errno.EADDRINUSE:
                taken.append(f"{word} {port}")
            else:
                problem = error.strerror or str(error)
        except (ValueError, TypeError, OverflowError) as error:  # what no resolver takes
            problem = str(error)
    return PortNeed(name, address, tuple(taken), problem, remedy)


def _try_to_bind(address: str, port: int, kind: socket.SocketKind) -> None:
    with socket.socket(socket.AF_INET6 if ":" in address else socket.AF_INET, kind) as probe:
        if kind is socket.SOCK_STREAM:
            # As servers do: a port in TIME_WAIT is free. On UDP this option would hide a listener.
            probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        probe.bind((address, port))
