"""Where the console may listen: beyond loopback only encrypted; and where others find it."""

from __future__ import annotations

import ipaddress
from dataclasses import dataclass

from housefly.config.site import Site
from housefly.config.state import users_file
from housefly.errors import ConfigError, HouseflyError
from housefly.web.access.own_names import lan_addresses
from housefly.web.access.security import LOOPBACK_NAMES
from housefly.web.access.tls import ServerCertificate, load_certificate
from housefly.web.access.users import UserBook

_WILDCARDS = frozenset({"0.0.0.0", "::"})
_WAY_OUT = (
    "To let them in: `housefly cert`, then `housefly run --lan`. Otherwise"
    ' web.host = "127.0.0.1", and from elsewhere an SSH tunnel'
)


@dataclass(frozen=True, slots=True)
class Exposure:
    """How the console may be reached.

    Attributes:
        certificate: what it is encrypted with; None for plain HTTP, on loopback.
        names: host names that browsers may ask for.
    """

    certificate: ServerCertificate | None
    names: frozenset[str]


def checked_exposure(site: Site, host: str = "") -> Exposure:
    """Return how the console of a site may be reached.

    Args:
        site: its configuration.
        host: listen there instead of at ``web.host``.

    Raises:
        ConfigError: others could reach it without encryption; or the file of the users is bad.
        MissingPartError: the certificate cannot be read without the extra ``lan``.
    """
    host = host or site.web.host
    certificate = load_certificate(site.web)
    users = UserBook(users_file(site))
    if not is_loopback(host):
        if certificate is None:
            raise _refused(host, "the link would not be encrypted")
        users.all()  # a file that is damaged, or that others may read, is told before the start
    names = LOOPBACK_NAMES | frozenset(certificate.names if certificate else ())
    return Exposure(certificate, names if host in _WILDCARDS else names | {host.lower()})


def is_loopback(host: str) -> bool:
    """Return whether only this machine reaches an address."""
    try:
        return host == "localhost" or ipaddress.ip_address(host).is_loopback
    except ValueError:
        return False


def console_address(site: Site) -> str:
    """Return the address that browsers open, without a path; for a wildcard that of the network."""
    host = _found_host(site) if site.web.host in _WILDCARDS else site.web.host
    host = f"[{host}]" if ":" in host else host
    return f"http{'s' if site.web.tls_certificate else ''}://{host}:{site.web.port}"


def guest_address(site: Site) -> str:
    """Return the address that other machines open, without a path; "" where none gets in."""
    return "" if is_loopback(site.web.host) else console_address(site)


def _found_host(site: Site) -> str:
    """Return the likeliest of this machine's addresses that its certificate names."""
    try:
        certificate = load_certificate(site.web)
    except HouseflyError:  # whoever starts a console checks it, and says so
        certificate = None
    names = certificate.names if certificate else ()
    return next((one for one in (*lan_addresses(), *names) if one in names), "127.0.0.1")


def _refused(host: str, problem: str) -> ConfigError:
    return ConfigError(
        "web.host",
        f"is {host!r}, where other machines reach the console: {problem}. {_WAY_OUT}",
    )
