"""The console's certificate: read, checked, and made into what the server encrypts with."""

from __future__ import annotations

import os
import ssl
import stat
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import TYPE_CHECKING

from housefly.config.text import read_text_file, shortened
from housefly.config.web import WebConfig
from housefly.errors import ConfigError, HouseflyError, MissingPartError

if TYPE_CHECKING:
    from cryptography.x509 import Certificate

AUTHORITY_FILE = "authority.pem"
"""The certificate of the authority, beside the console's."""
_OPEN_TO_OTHERS = 0o077
_REMEDY = "make one with `housefly cert`"


@dataclass(frozen=True, slots=True)
class ServerCertificate:
    """A certificate with its key.

    Attributes:
        context: for the server; TLS 1.2 or newer.
        names: host names and addresses that the certificate is for, in small letters.
    """

    context: ssl.SSLContext
    names: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class CertificateState:
    """For which names, in small letters, and for how long a certificate is good."""

    names: tuple[str, ...]
    left: timedelta


def load_certificate(web: WebConfig) -> ServerCertificate | None:
    """Return the certificate that a site names, or None when it names none.

    Raises:
        ConfigError: it cannot be used; says which file, why, and what to do.
        MissingPartError: the extra ``lan`` is not installed.
    """
    if not web.tls_certificate:
        return None
    certificate, key = _path(web.tls_certificate), _path(web.tls_key)
    _refuse_open_key(key)
    names = _checked_names(certificate)
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.minimum_version = ssl.TLSVersion.TLSv1_2
    try:
        # A key with a password would be asked for on a terminal that nobody sees.
        context.load_cert_chain(certificate, key, password=lambda: b"")
    except (OSError, ValueError) as error:
        reason = getattr(error, "reason", None) or getattr(error, "strerror", None) or str(error)
        raise ConfigError(
            "web.tls_key",
            f"{shortened(str(key))} does not belong to {shortened(str(certificate))} ({reason});"
            f" {_REMEDY}",
        ) from error
    return ServerCertificate(context, names)


def authority_of(web: WebConfig) -> bytes | None:
    """Return the certificate that browsers are to trust, in DER; None when there is none.

    It is the one beside the site's certificate, as `housefly cert` leaves it there, and must have
    vouched for it.
    """
    if not web.tls_certificate:
        return None
    from cryptography.exceptions import InvalidSignature
    from cryptography.hazmat.primitives.serialization import Encoding

    certificate = _path(web.tls_certificate)
    try:
        authority = _parsed(certificate.with_name(AUTHORITY_FILE))
        _parsed(certificate).verify_directly_issued_by(authority)
    except (HouseflyError, InvalidSignature, ValueError, TypeError):
        return None
    return authority.public_bytes(Encoding.DER)


def certificate_state(certificate: Path) -> CertificateState:
    """Return for which names and how long a certificate is good; raises ConfigError."""
    parsed = _parsed(certificate)
    return CertificateState(_names_of(parsed), parsed.not_valid_after_utc - datetime.now(UTC))


def _path(name: str) -> Path:
    try:
        return Path(name).expanduser()
    except RuntimeError as error:  # an unknown home
        raise ConfigError("web.tls_certificate", f"{shortened(name)}: {error}") from error


def _refuse_open_key(key: Path) -> None:
    try:
        found = key.stat()
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise ConfigError("web.tls_key", f"{shortened(str(key))}: {reason}; {_REMEDY}") from error
    if not stat.S_ISREG(found.st_mode):
        raise ConfigError("web.tls_key", f"{shortened(str(key))} is no ordinary file; {_REMEDY}")
    if found.st_mode & _OPEN_TO_OTHERS or found.st_uid not in (os.geteuid(), 0):
        raise ConfigError(
            "web.tls_key",
            f"{shortened(str(key))} may be read by other users; `chmod 600` it, and make a new one"
            " if you do not trust them",
        )


def _checked_names(file: Path) -> tuple[str, ...]:
    """Return the names of a certificate that is valid now."""
    certificate = _parsed(file)
    now = datetime.now(UTC)
    if not certificate.not_valid_before_utc <= now < certificate.not_valid_after_utc:
        days = (
            f"{certificate.not_valid_before_utc:%Y-%m-%d} to"
            f" {certificate.not_valid_after_utc:%Y-%m-%d}"
        )
        raise _unusable(file, f"is valid from {days} only; {_REMEDY}, or set the clock")
    names = _names_of(certificate)
    if not names:
        raise _unusable(file, f"names no host (no subject alternative name); {_REMEDY}")
    return names


def _parsed(file: Path) -> Certificate:
    try:
        from cryptography.x509 import load_pem_x509_certificate
    except ImportError as error:
        raise MissingPartError("cryptography", "pip install 'housefly[lan]'") from error
    try:
        return load_pem_x509_certificate(read_text_file(file).encode())
    except OSError as error:
        raise _unusable(file, f"cannot be read ({error.strerror}); {_REMEDY}") from error
    except ValueError as error:
        raise _unusable(file, f"is no certificate in PEM; {_REMEDY}") from error


def _names_of(certificate: Certificate) -> tuple[str, ...]:
    from cryptography.x509 import DNSName, ExtensionNotFound, IPAddress, SubjectAlternativeName

    try:
        found = certificate.extensions.get_extension_for_class(SubjectAlternativeName).value
    except (ExtensionNotFound, ValueError):
        return ()
    hosts = [name.lower() for name in found.get_values_for_type(DNSName)]
    return (*hosts, *map(str, found.get_values_for_type(IPAddress)))


def _unusable(file: Path, problem: str) -> ConfigError:
    return ConfigError("web.tls_certificate", f"{shortened(str(file))} {problem}")
