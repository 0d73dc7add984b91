"""Beyond loopback only with a certificate; what is wrong with it is said in words."""

from __future__ import annotations

from datetime import timedelta
from pathlib import Path
from typing import Any

import pytest

from housefly.app import certificates
from housefly.app.certificates import CertificateFiles, make_certificate
from housefly.config.site import Site, changed
from housefly.config.state import users_file
from housefly.errors import ConfigError
from housefly.web.access.exposure import checked_exposure, console_address
from housefly.web.access.roles import Role
from housefly.web.access.users import UserBook

LAN = ("0.0.0.0", "::", "192.168.1.2", "housefly.local", "fd00::2", "127.0.0.1.evil.example", "")


@pytest.fixture
def files(tmp_path: Path) -> CertificateFiles:
    return make_certificate(tmp_path / "tls", ["lab.local", "127.0.0.1", "10.0.0.7"])[0]


@pytest.fixture
def lan(
    files: CertificateFiles,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    cheap_passwords: None,
) -> Site:
    """A site that may be reached from elsewhere."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    site = changed(
        Site(),
        web__host="0.0.0.0",
        web__tls_certificate=str(files.certificate),
        web__tls_key=str(files.key),
    )
    UserBook(users_file(site)).put("anna", Role.FLY, "correct horse battery")
    return site


@pytest.mark.parametrize("host", ["127.0.0.1", "127.9.9.9", "::1", "localhost"])
def test_loopback_needs_nothing(host: str) -> None:
    exposure = checked_exposure(changed(Site(), web__host=host))
    assert exposure.certificate is None and host in exposure.names


@pytest.mark.parametrize("host", LAN)
def test_other_addresses_need_a_certificate(host: str) -> None:
    with pytest.raises(ConfigError, match=r"web\.host.*not be encrypted.*housefly cert"):
        checked_exposure(changed(Site(), web__host=host))


def test_with_one_browsers_ask_under_the_names_of_the_certificate_only(lan: Site) -> None:
    exposure = checked_exposure(lan)
    assert exposure.certificate is not None
    assert exposure.names == {"lab.local", "127.0.0.1", "10.0.0.7", "localhost", "::1"}
    assert console_address(lan) == "https://lab.local:8080"
    assert console_address(changed(lan, web__host="::1")) == "https://[::1]:8080"


def test_a_key_without_a_certificate_is_refused(lan: Site) -> None:
    with pytest.raises(ConfigError, match="belong together"):
        changed(lan, web__tls_certificate="")


def spoil(files: CertificateFiles, how: str) -> None:
    match how:
        case "no key":
            files.key.unlink()
        case "no certificate":
            files.certificate.unlink()
        case "key for all":
            files.key.chmod(0o644)
        case "another's key":
            files.key.write_bytes(files.authority_key.read_bytes())
        case "no key at all":
            files.key.write_text("?")
        case "no certificate at all":
            files.certificate.write_text("?")


@pytest.mark.parametrize(
    ("how", "words"),
    [
        ("no key", "No such file"),
        ("no certificate", "cannot be read"),
        ("key for all", "chmod 600"),
        ("another's key", "does not belong"),
        ("no key at all", "does not belong"),
        ("no certificate at all", "no certificate in PEM"),
    ],
)
def test_a_certificate_that_cannot_be_used_is_refused_in_words(
    lan: Site, files: CertificateFiles, how: str, words: str
) -> None:
    spoil(files, how)
    with pytest.raises(ConfigError, match=words):
        checked_exposure(lan)


def test_a_certificate_that_has_run_out_is_refused_in_words(
    lan: Site, files: CertificateFiles, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(certificates, "CERTIFICATE_LIFE", timedelta(seconds=-1))
    make_certificate(files.key.parent, ["lab.local"])
    with pytest.raises(ConfigError, match=r"valid from .* only; make one with `housefly cert`"):
        checked_exposure(lan)


@pytest.mark.parametrize("value", ["x\0y", "~nobody-of-that-name/x", "/dev/zero", "a" * 300, "/"])
def test_odd_paths_are_refused_in_words(lan: Site, value: str) -> None:
    for key in ("tls_certificate", "tls_key", "users"):
        with pytest.raises(ConfigError):
            checked_exposure(changed(lan, **{f"web__{key}": value}))


def test_paths_of_a_site_file_are_relative_to_it(tmp_path: Path) -> None:
    from housefly.sites.loaded_site import read_site

    text = '[web]\ntls_certificate = "tls/a.pem"\ntls_key = "tls/b.pem"\nusers = "who.json"\n'
    (tmp_path / "site.toml").write_text(text)
    web: Any = read_site(str(tmp_path / "site.toml")).web
    assert web.tls_key == str(tmp_path / "tls" / "b.pem")
    assert web.users == str(tmp_path / "who.json")
