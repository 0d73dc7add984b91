"""The console for the network: with a certificate that fits, or not at all; renewed by itself."""

from __future__ import annotations

import stat
from datetime import timedelta
from pathlib import Path

import pytest

from housefly.app import certificates, lan
from housefly.app.certificates import files_in, make_certificate
from housefly.app.lan import lan_site
from housefly.config.site import Site, changed
from housefly.errors import ConfigError
from housefly.web.access.exposure import checked_exposure, console_address, guest_address
from housefly.web.access.tls import authority_of, certificate_state

HERE = ("192.168.4.4", "10.8.0.2")


@pytest.fixture
def site(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Site:
    """A site of a machine with two addresses."""
    for module in ("housefly.app.lan", "housefly.web.access.exposure"):
        monkeypatch.setattr(f"{module}.lan_addresses", lambda: HERE)
    monkeypatch.setattr(lan, "own_names", lambda: ("lab", "lab.local", "127.0.0.1", *HERE))
    return changed(Site(), hub__store=str(tmp_path / "room.db"))


def tls(site: Site) -> Path:
    return Path(site.hub.store).with_name("room-edits").with_name("tls")


def test_without_a_certificate_nothing_is_opened_and_the_way_to_one_is_said(site: Site) -> None:
    with pytest.raises(ConfigError, match=r"--lan.*encrypted.*`housefly cert --site lab`"):
        lan_site(site, "lab")


def test_without_a_network_that_is_said(site: Site, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(lan, "lan_addresses", tuple)
    with pytest.raises(ConfigError, match="connect it to the network"):
        lan_site(site, "lab")


def test_with_one_it_listens_everywhere_and_phones_find_the_likeliest_address(site: Site) -> None:
    make_certificate(tls(site), ("lab.local", "127.0.0.1", *HERE))
    opened, words = lan_site(site, "lab")
    assert words == "" and opened.web.host == "0.0.0.0"
    assert guest_address(opened) == console_address(opened) == "https://192.168.4.4:8080"
    assert {*HERE, "lab.local", "localhost"} <= checked_exposure(opened).names
    assert guest_address(site) == ""


def test_a_machine_with_ipv6_alone_listens_there(
    site: Site, monkeypatch: pytest.MonkeyPatch
) -> None:
    for module in ("housefly.app.lan", "housefly.web.access.exposure"):
        monkeypatch.setattr(f"{module}.lan_addresses", lambda: ("fd00::2",))
    make_certificate(tls(site), ("lab.local", "fd00::2"))
    opened, _ = lan_site(site, "lab")
    assert opened.web.host == "::" and guest_address(opened) == "https://[fd00::2]:8080"


def test_a_new_address_renews_the_certificate_and_phones_trust_it_as_before(site: Site) -> None:
    files, _ = make_certificate(tls(site), ("lab.local", "127.0.0.1", HERE[0]))
    authority = files.authority.read_bytes()
    opened, words = lan_site(site, "lab")
    assert "does not name 10.8.0.2" in words and "as before" in words
    assert set(HERE) <= set(certificate_state(files.certificate).names)
    assert files.authority.read_bytes() == authority
    assert authority_of(opened.web) is not None
    for file in files.key.parent.iterdir():
        assert stat.S_IMODE(file.stat().st_mode) == 0o600, file


@pytest.mark.parametrize(("days", "said"), [(29, "runs out in 28 days"), (-1, "has run out")])
def test_what_runs_out_is_renewed(
    site: Site, monkeypatch: pytest.MonkeyPatch, days: int, said: str
) -> None:
    with monkeypatch.context() as patch:
        patch.setattr(certificates, "CERTIFICATE_LIFE", timedelta(days=days))
        files, _ = make_certificate(tls(site), ("lab.local", *HERE))
    _, words = lan_site(site, "lab")
    assert said in words
    assert certificate_state(files.certificate).left > timedelta(days=700)


def test_an_authority_that_may_not_vouch_for_it_is_not_made_anew_in_silence(site: Site) -> None:
    files, _ = make_certificate(tls(site), ("lab.local", HERE[0]))
    files.authority_key.unlink()
    before = files.authority.read_bytes()
    with pytest.raises(ConfigError, match="trust the new authority"):
        lan_site(site, "lab")
    assert files.authority.read_bytes() == before


@pytest.mark.parametrize("spoiled", ["certificate", "key"])
def test_a_spoiled_file_is_told_before_anything_starts(site: Site, spoiled: str) -> None:
    files, _ = make_certificate(tls(site), ("lab.local", *HERE))
    getattr(files, spoiled).write_text("?")
    with pytest.raises(ConfigError, match="housefly cert"):
        checked_exposure(lan_site(site, "lab")[0])


def test_what_the_site_file_says_is_kept(site: Site, tmp_path: Path) -> None:
    own = make_certificate(tmp_path / "own", ("lab.example", "192.168.4.4"))[0]
    named = changed(
        site,
        web__host="192.168.4.4",
        web__tls_certificate=str(own.certificate),
        web__tls_key=str(own.key),
    )
    assert lan_site(named, "lab") == (named, "")


def test_only_who_vouched_for_the_console_is_handed_to_phones(site: Site, tmp_path: Path) -> None:
    files, _ = make_certificate(tls(site), ("lab.local", *HERE))
    web = lan_site(site, "lab")[0].web
    found = authority_of(web)
    assert found is not None and b"PRIVATE" not in found
    other = files_in(make_certificate(tmp_path / "other", HERE)[0].authority.parent)
    files.authority.write_bytes(other.authority.read_bytes())
    assert authority_of(web) is None
    files.authority.write_bytes(files.authority_key.read_bytes())
    assert authority_of(web) is None
    assert authority_of(Site().web) is None
