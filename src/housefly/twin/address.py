"""Where the twin may listen: on loopback, unless asked for more."""

from __future__ import annotations

from ipaddress import ip_address

from housefly.errors import ConfigError

PeerAddress = tuple[str, int]
"""IP address and port of a peer."""


def check_address(key: str, address: str, beyond_loopback: bool) -> None:
    """Refuse an address that other machines can reach, unless asked for.

    Args:
        key: the site's key that holds it.
        address: IP address in numbers.
        beyond_loopback: whether the user asked to serve other machines.

    Raises:
        ConfigError: not an IP address, or not loopback.
    """
    try:
        loopback = ip_address(address).is_loopback
    except ValueError as error:
        raise ConfigError(
            key, f"is {address!r}; allowed: an IP address in numbers, as 127.0.0.1"
        ) from error
    if not (loopback or beyond_loopback):
        raise ConfigError(
            key,
            f"is {address}; the twin serves other machines only when started with"
            " --beyond-loopback",
        )
