"""What people call the program at the other end of a tracking system's wire."""

from __future__ import annotations

from ipaddress import ip_address

from housefly.messages.words import Words

_SIMULATED = Words("the simulated room")


def software_at(address: str, usual: str) -> str:
    """Return what runs at an address: on this machine that is the twin, not the makers' program.

    Args:
        address: as in the site file, a number or a name.
        usual: name of the makers' program.
    """
    try:
        is_here = ip_address(address).is_loopback
    except ValueError:
        is_here = address == "localhost"
    return _SIMULATED if is_here else usual
