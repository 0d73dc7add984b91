"""Makes a certification authority for this machine alone, and the console's certificate with it.

The authority may only vouch for this machine's names and for private addresses, so that its key,
if it is stolen, opens nobody's bank. Browsers are told once to trust it; the certificate may be
made anew when it runs out or the address changes.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from ipaddress import IPv4Address, IPv4Network, IPv6Address, IPv6Network, ip_address, ip_network
from pathlib import Path

from housefly.errors import ConfigError, MissingPartError
from housefly.web.access.tls import AUTHORITY_FILE

try:
    from cryptography import x509
    from cryptography.hazmat.primitives import hashes, serialization
    from cryptography.hazmat.primitives.asymmetric import ec
    from cryptography.x509.oid import ExtendedKeyUsageOID, NameOID
except ImportError as error:
    raise MissingPartError("cryptography", "pip install 'housefly[lan]'") from error

AUTHORITY_LIFE, CERTIFICATE_LIFE = timedelta(days=3650), timedelta(days=800)
"""Some browsers take no certificate that is valid for more than 825 days."""
_CLOCK_TOLERANCE = timedelta(days=1)
_PRIVATE = ("10.0.0.0/8", "172.16.0.0/12", "192.168.0.0/16", "169.254.0.0/16", "127.0.0.0/8")
_PRIVATE_6 = ("fc00::/7", "fe80::/10", "::1/128")


@dataclass(frozen=True, slots=True)
class CertificateFiles:
    """The four files, in PEM; only this user may read the keys."""

    authority: Path
    authority_key: Path
    certificate: Path
    key: Path


def files_in(folder: Path) -> CertificateFiles:
    """Return the paths of the files in a folder."""
    return CertificateFiles(
        folder / AUTHORITY_FILE,
        folder / "authority-key.pem",
        folder / "console.pem",
        folder / "console-key.pem",
    )


def make_certificate(folder: Path, names: Sequence[str]) -> tuple[CertificateFiles, bool]:
    """Write a certificate for host names and addresses, and an authority unless one will do.

    Args:
        folder: made if missing, mode 0700.
        names: host names and IP addresses.

    Returns:
        The files, and whether the authority is new, so that browsers do not trust it yet.

    Raises:
        ConfigError: a name is none, or a file cannot be written.
    """
    is_new = not renew_certificate(folder, names)
    files, alternatives = files_in(folder), _general_names(names)
    if is_new:
        try:
            folder.mkdir(parents=True, exist_ok=True, mode=0o700)
            _write_certificate(files, _new_authority(files, alternatives), alternatives)
        except OSError as error:
            raise _unwritable(folder, error) from error
    return files, is_new


def renew_certificate(folder: Path, names: Sequence[str]) -> bool:
    """Write a certificate by the authority that is there; False when it may not vouch for that.

    Args:
        folder: of the files.
        names: host names and IP addresses.

    Raises:
        ConfigError: a name is none, or a file cannot be written.
    """
    files, alternatives = files_in(folder), _general_names(names)
    authority = _known_authority(files, alternatives)
    if authority is None:
        return False
    try:
        _write_certificate(files, authority, alternatives)
    except OSError as error:
        raise _unwritable(folder, error) from error
    return True


def fingerprint(certificate: Path) -> str:
    """Return the SHA-256 fingerprint of a certificate in PEM, as phones show it."""
    found = x509.load_pem_x509_certificate(certificate.read_bytes()).fingerprint(hashes.SHA256())
    return found.hex(" ").upper()


_Authority = tuple[x509.Certificate, ec.EllipticCurvePrivateKey]


def _write_certificate(
    files: CertificateFiles, authority: _Authority, alternatives: list[x509.GeneralName]
) -> None:
    key = ec.generate_private_key(ec.SECP256R1())
    certificate = _certificate(*authority, key, alternatives)
    _write_key(files.key, key)
    _write(files.certificate, certificate.public_bytes(serialization.Encoding.PEM))


def _unwritable(folder: Path, error: OSError) -> ConfigError:
    return ConfigError("--out", f"{folder} cannot be written ({error.strerror})")


def _general_names(names: Sequence[str]) -> list[x509.GeneralName]:
    return [_general_name(name) for name in dict.fromkeys(names)]


def _general_name(name: str) -> x509.GeneralName:
    try:
        return x509.IPAddress(ip_address(name))
    except ValueError:
        pass
    labels = name.removesuffix(".").split(".")
    sane = all(
        label and len(label) <= 63 and label.isascii() and label.replace("-", "a").isalnum()
        for label in labels
    )
    if not sane or len(name) > 253:
        raise ConfigError(
            "--name", f"is {name[:60]!r}; allowed: a host name such as lab.local, or an IP address"
        )
    return x509.DNSName(name.lower())


def _known_authority(
    files: CertificateFiles, alternatives: list[x509.GeneralName]
) -> _Authority | None:
    """Return the authority of last time if it still may vouch for these names."""
    try:
        authority = x509.load_pem_x509_certificate(files.authority.read_bytes())
        key = serialization.load_pem_private_key(files.authority_key.read_bytes(), None)
    except (OSError, ValueError, TypeError):
        return None
    left = authority.not_valid_after_utc - datetime.now(UTC)
    if not isinstance(key, ec.EllipticCurvePrivateKey) or left < CERTIFICATE_LIFE:
        return None
    if key.public_key() != authority.public_key():
        return None
    try:
        found = authority.extensions.get_extension_for_class(x509.NameConstraints).value
    except x509.ExtensionNotFound:
        return None
    permitted = found.permitted_subtrees or []
    return (authority, key) if all(_is_within(one, permitted) for one in alternatives) else None


def _is_within(name: x509.GeneralName, permitted: Sequence[x509.GeneralName]) -> bool:
    if isinstance(name, x509.DNSName):
        return name in permitted
    address = name.value
    assert isinstance(address, IPv4Address | IPv6Address)
    networks = [one.value for one in permitted if isinstance(one, x509.IPAddress)]
    return any(
        isinstance(network, IPv4Network | IPv6Network) and address in network
        for network in networks
    )


def _new_authority(files: CertificateFiles, alternatives: list[x509.GeneralName]) -> _Authority:
    key = ec.generate_private_key(ec.SECP256R1())
    private: list[x509.GeneralName] = [
        x509.IPAddress(ip_network(one)) for one in (*_PRIVATE, *_PRIVATE_6)
    ]
    hosts = [name for name in alternatives if isinstance(name, x509.DNSName)]
    public = [
        x509.IPAddress(ip_network(str(name.value)))
        for name in alternatives
        if isinstance(name, x509.IPAddress) and not _is_within(name, private)
    ]
    subject = _subject("Housefly's authority for this machine")
    constraints = x509.NameConstraints([*hosts, *private, *public], None)
    authority = (
        _builder(subject, subject, key.public_key(), AUTHORITY_LIFE)
        .add_extension(x509.BasicConstraints(ca=True, path_length=0), critical=True)
        .add_extension(_usage(signs_certificates=True), critical=True)
        .add_extension(constraints, critical=True)
        .sign(key, hashes.SHA256())
    )
    _write_key(files.authority_key, key)
    _write(files.authority, authority.public_bytes(serialization.Encoding.PEM))
    return authority, key


def _certificate(
    authority: x509.Certificate,
    authority_key: ec.EllipticCurvePrivateKey,
    key: ec.EllipticCurvePrivateKey,
    alternatives: list[x509.GeneralName],
) -> x509.Certificate:
    server = x509.ExtendedKeyUsage([ExtendedKeyUsageOID.SERVER_AUTH])
    vouching = x509.AuthorityKeyIdentifier.from_issuer_public_key(authority_key.public_key())
    subject = _subject("Housefly's console")
    return (
        _builder(subject, authority.subject, key.public_key(), CERTIFICATE_LIFE)
        .add_extension(x509.SubjectAlternativeName(alternatives), critical=False)
        .add_extension(x509.BasicConstraints(ca=False, path_length=None), critical=True)
        .add_extension(_usage(signs_certificates=False), critical=True)
        .add_extension(server, critical=False)
        .add_extension(vouching, critical=False)
        .sign(authority_key, hashes.SHA256())
    )


def _builder(
    subject: x509.Name, issuer: x509.Name, key: ec.EllipticCurvePublicKey, life: timedelta
) -> x509.CertificateBuilder:
    now = datetime.now(UTC)
    return (
        x509.CertificateBuilder()
        .subject_name(subject)
        .issuer_name(issuer)
        .public_key(key)
        .serial_number(x509.random_serial_number())
        .not_valid_before(now - _CLOCK_TOLERANCE)
        .not_valid_after(now + life)
        .add_extension(x509.SubjectKeyIdentifier.from_public_key(key), critical=False)
    )


def _subject(name: str) -> x509.Name:
    return x509.Name([x509.NameAttribute(NameOID.COMMON_NAME, name)])


def _usage(*, signs_certificates: bool) -> x509.KeyUsage:
    return x509.KeyUsage(
        digital_signature=not signs_certificates,
        content_commitment=False,
        key_encipherment=False,
        data_encipherment=False,
        key_agreement=False,
        key_cert_sign=signs_certificates,
        crl_sign=signs_certificates,
        encipher_only=False,
        decipher_only=False,
    )


def _write_key(file: Path, key: ec.EllipticCurvePrivateKey) -> None:
    _write(
        file,
        key.private_bytes(
            serialization.Encoding.PEM,
            serialization.PrivateFormat.PKCS8,
            serialization.NoEncryption(),
        ),
    )


def _write(file: Path, content: bytes) -> None:
    """Write a file of mode 0600 in the place of another, whatever mode that one has."""
    fresh = file.with_suffix(".new")
    fresh.unlink(missing_ok=True)
    with os.fdopen(os.open(fresh, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "wb") as target:
        target.write(content)
    fresh.replace(file)
