"""The names and addresses under which other machines know this one."""

from __future__ import annotations

import fcntl
import socket
import struct
from contextlib import suppress
from ipaddress import IPv6Address, ip_address
from pathlib import Path

_GET_ADDRESS = 0x8915
"""SIOCGIFADDR of Linux."""
_ADDRESSES_6 = Path("/proc/net/if_inet6")
_ELSEWHERE = ("198.51.100.1", 9)
"""An address of nobody (RFC 5737)."""


def own_names() -> tuple[str, ...]:
    """Return host names, then IP addresses, without doubles; loopback is among them."""
    host = socket.gethostname().lower()
    hosts = [host] if "." in host else [host, f"{host}.local"]
    return tuple(dict.fromkeys([*hosts, "localhost", *_addresses_4(), *_addresses_6()]))


def lan_addresses() -> tuple[str, ...]:
    """Return the IP addresses that other machines may reach, the likeliest first."""
    found = [one for one in (*_addresses_4(), *_addresses_6()) if not ip_address(one).is_loopback]
    return tuple(dict.fromkeys([*_address_of_the_way_out(), *found]))


def _address_of_the_way_out() -> list[str]:
    """Return the address with which this machine speaks to others: not that of a container."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as asking, suppress(OSError):
        asking.connect(_ELSEWHERE)  # sends nothing
        return [str(asking.getsockname()[0])]
    return []


def _addresses_4() -> list[str]:
    found = ["127.0.0.1"]
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as asking:
        for _, interface in socket.if_nameindex():
            with suppress(OSError):  # an interface without an address
                request = struct.pack("256s", interface.encode()[:15])
                answer = fcntl.ioctl(asking.fileno(), _GET_ADDRESS, request)
                found.append(socket.inet_ntoa(answer[20:24]))
    return found


def _addresses_6() -> list[str]:
    found = [IPv6Address("::1")]
    with suppress(OSError, ValueError):
        for line in _ADDRESSES_6.read_text(encoding="ascii").splitlines():
            found.append(IPv6Address(bytes.fromhex(line.split()[0])))
    return [str(address) for address in found if not address.is_link_local]
