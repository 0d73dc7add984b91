from __future__ import annotations

import ssl
import stat
from pathlib import Path

import pytest
from cryptography import x509

from housefly.app import certificates
from housefly.app.certificates import CertificateFiles, files_in, make_certificate
from housefly.errors import ConfigError
from housefly.web.access.own_names import own_names

NAMES = ("lab.local", "127.0.0.1", "192.168.4.4", "fd00::2")


def shaken(files: CertificateFiles, trusted: Path, name: str) -> str:
    """Return "" when a client that trusts an authority accepts the certificate, else why not."""
    server = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    server.load_cert_chain(files.certificate, files.key)
    client = ssl.create_default_context(cafile=str(trusted))
    to_server, to_client = ssl.MemoryBIO(), ssl.MemoryBIO()
    ends = (
        client.wrap_bio(to_client, to_server, server_hostname=name),
        server.wrap_bio(to_server, to_client, server_side=True),
    )
    for _ in range(4):
        for end in ends:
            try:
                end.do_handshake()
            except ssl.SSLWantReadError:
                pass
            except ssl.SSLCertVerificationError as error:
                return error.verify_message
    return ""


@pytest.mark.parametrize("name", NAMES)
def test_who_trusts_the_authority_trusts_the_console_under_each_of_its_names(
    tmp_path: Path, name: str
) -> None:
    files, is_new = make_certificate(tmp_path / "tls", NAMES)
    assert is_new and shaken(files, files.authority, name) == ""
    assert shaken(files, files.authority, "evil.example") != ""
    other, _ = make_certificate(tmp_path / "other", NAMES)
    assert shaken(files, other.authority, name) != ""


def test_all_files_are_for_this_user_alone_also_in_the_place_of_open_ones(tmp_path: Path) -> None:
    files = files_in(tmp_path / "tls")
    files.key.parent.mkdir()
    for file in (files.key, files.authority_key):
        file.write_text("")
        file.chmod(0o644)
    make_certificate(tmp_path / "tls", NAMES)
    for file in files.key.parent.iterdir():
        assert stat.S_IMODE(file.stat().st_mode) == 0o600, file
    make_certificate(tmp_path / "new", NAMES)
    assert stat.S_IMODE((tmp_path / "new").stat().st_mode) == 0o700


def test_a_second_certificate_keeps_the_authority_and_a_new_host_name_does_not(
    tmp_path: Path,
) -> None:
    files, _ = make_certificate(tmp_path, NAMES)
    before, authority = files.certificate.read_bytes(), files.authority.read_bytes()
    _, is_new = make_certificate(tmp_path, ["lab.local", "10.1.2.3"])
    assert not is_new and files.authority.read_bytes() == authority
    assert files.certificate.read_bytes() != before
    assert shaken(files, files.authority, "10.1.2.3") == ""
    _, is_new = make_certificate(tmp_path, ["elsewhere.local"])
    assert is_new and shaken(files, files.authority, "elsewhere.local") == ""


def test_a_stolen_authority_vouches_for_no_other_place(tmp_path: Path) -> None:
    files, _ = make_certificate(tmp_path / "ours", ["lab.local", "192.168.4.4"])
    loot = files_in(tmp_path / "loot")
    loot.key.parent.mkdir()
    authority = x509.load_pem_x509_certificate(files.authority.read_bytes())
    found = certificates._known_authority(files, [])
    assert found is not None and found[0] == authority
    key = certificates.ec.generate_private_key(certificates.ec.SECP256R1())
    names = [x509.DNSName("bank.example")]
    forged = certificates._certificate(*found, key, names)
    loot.certificate.write_bytes(forged.public_bytes(certificates.serialization.Encoding.PEM))
    certificates._write_key(loot.key, key)
    assert "permitted subtree violation" in shaken(loot, files.authority, "bank.example")


@pytest.mark.parametrize("name", ["", "a b", "a..b", "*", "a" * 64, "a.b/c", "é.local", "x\0y"])
def test_a_name_that_is_none_is_refused_in_words(tmp_path: Path, name: str) -> None:
    with pytest.raises(ConfigError, match="--name"):
        make_certificate(tmp_path, [name])
    assert not list(tmp_path.iterdir())


def test_a_folder_that_cannot_be_written_is_told(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(ConfigError, match="cannot be written"):
        make_certificate(tmp_path / "file", NAMES)


def test_this_machine_knows_its_names_and_each_is_fit_for_a_certificate(tmp_path: Path) -> None:
    names = own_names()
    assert {"localhost", "127.0.0.1", "::1"} <= set(names) and len(set(names)) == len(names)
    make_certificate(tmp_path, names)
