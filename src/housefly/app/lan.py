"""Opens a site's console to other machines of the network: over TLS, or not at all."""

from __future__ import annotations

from datetime import timedelta
from ipaddress import ip_address

from housefly.app.certificates import CertificateFiles, files_in, renew_certificate
from housefly.config.site import Site, changed
from housefly.config.state import tls_folder
from housefly.errors import ConfigError, HouseflyError
from housefly.web.access.exposure import is_loopback
from housefly.web.access.own_names import lan_addresses, own_names
from housefly.web.access.tls import CertificateState, certificate_state

RENEW_BEFORE = timedelta(days=30)
"""A certificate is made anew so long before it runs out."""
_EVERYWHERE, _EVERYWHERE_6 = "0.0.0.0", "::"


def lan_site(site: Site, named: str) -> tuple[Site, str]:
    """Return a site whose console other machines reach, and a line that says what was renewed.

    Args:
        site: as its file has it; a certificate and an address that it names are kept.
        named: what stands behind ``--site``, for the words.

    Raises:
        ConfigError: there is no certificate, or no network.
    """
    addresses = lan_addresses()
    if not addresses:
        raise ConfigError(
            "--lan", "this machine has no address that others reach: connect it to the network"
        )
    words = ""
    if not site.web.tls_certificate:
        files, words = _usable_certificate(site, f"`housefly cert --site {named}`", addresses)
        site = changed(
            site, web__tls_certificate=str(files.certificate), web__tls_key=str(files.key)
        )
    if is_loopback(site.web.host):
        has_4 = any(ip_address(one).version == 4 for one in addresses)
        site = changed(site, web__host=_EVERYWHERE if has_4 else _EVERYWHERE_6)
    return site, words


def _usable_certificate(
    site: Site, remedy: str, addresses: tuple[str, ...]
) -> tuple[CertificateFiles, str]:
    files = files_in(tls_folder(site))
    if not files.certificate.exists():
        raise ConfigError(
            "--lan",
            "needs a certificate, for what others send and see must be encrypted, and there is"
            f" none yet: {remedy} makes one and says how a phone comes to trust it",
        )
    try:
        state = certificate_state(files.certificate)
    except HouseflyError as error:
        raise ConfigError("--lan", f"{error}; {remedy}") from error
    why = _why_renew(state, addresses)
    if not why:
        return files, ""
    hosts = [one for one in state.names if not _is_address(one)]
    now = [one for one in own_names() if _is_address(one) and _may_be_renewed(one)]
    names = dict.fromkeys((*hosts, *now))
    if not renew_certificate(files.certificate.parent, tuple(names)):
        raise ConfigError(
            "--lan",
            f"{why}, and its authority may not vouch for a new one: {remedy}, and let the"
            " phones trust the new authority",
        )
    return files, f"{why}: made anew, phones trust it as before"


def _why_renew(state: CertificateState, addresses: tuple[str, ...]) -> str:
    # Public IPv6 addresses change by themselves; the QR code does not name them.
    lacking = [one for one in filter(_may_be_renewed, addresses) if one not in state.names]
    if lacking:
        return f"the certificate does not name {', '.join(lacking)}"
    if state.left < RENEW_BEFORE:
        days = max(0, state.left.days)
        return f"the certificate runs out in {days} days" if days else "the certificate has run out"
    return ""


def _may_be_renewed(address: str) -> bool:
    """Return whether an authority of last time likely vouches for it: not for a public IPv6 one."""
    return ip_address(address).version == 4 or ip_address(address).is_private


def _is_address(name: str) -> bool:
    try:
        ip_address(name)
    except ValueError:
        return False
    return True
