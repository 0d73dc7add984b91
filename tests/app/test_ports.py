import socket
from pathlib import Path

import pytest

from housefly.app.ports import port_needs, refuse_taken_ports
from housefly.cli import main
from housefly.config.site import Site, changed
from housefly.errors import LinkError


def site_at(address: str) -> Site:
    return changed(Site(), drone__address=address, tracking__address=address, web__host=address)


def test_free_ports_are_no_obstacle(loopback: str) -> None:
    refuse_taken_ports(site_at(loopback), web=True)
    assert not any(need.taken for need in port_needs(site_at(loopback), web=True))


@pytest.mark.parametrize(
    ("port", "kind", "words"),
    [
        (5556, socket.SOCK_DGRAM, "UDP 5556"),
        (5559, socket.SOCK_STREAM, "TCP 5559"),
        (8010, socket.SOCK_STREAM, "TCP 8010"),
        (8080, socket.SOCK_STREAM, "TCP 8080"),
    ],
)
def test_a_taken_port_is_refused_before_anything_starts(
    loopback: str, port: int, kind: socket.SocketKind, words: str
) -> None:
    with socket.socket(socket.AF_INET, kind) as other:
        other.bind((loopback, port))
        if kind is socket.SOCK_STREAM:
            other.listen()
        with pytest.raises(LinkError, match=words):
            refuse_taken_ports(site_at(loopback), web=True)


def test_the_port_of_the_live_view_is_looked_at_where_the_site_asks_for_it(loopback: str) -> None:
    site = changed(site_at(loopback), foxglove__host=loopback)
    with socket.create_server((loopback, 8765)):
        refuse_taken_ports(site, web=True)
        with pytest.raises(LinkError, match=r"Foxglove: TCP 8765.*foxglove\.port"):
            refuse_taken_ports(changed(site, foxglove__enabled=True), web=True)


@pytest.mark.parametrize(
    ("wire", "port", "kind", "words"),
    [
        ("natnet", 1510, socket.SOCK_DGRAM, "UDP 1510"),
        ("vrpn", 3883, socket.SOCK_DGRAM, "UDP 3883"),
        ("vrpn", 3883, socket.SOCK_STREAM, "TCP 3883"),
    ],
)
def test_each_tracking_system_needs_its_own_ports(
    loopback: str, wire: str, port: int, kind: socket.SocketKind, words: str
) -> None:
    site = changed(site_at(loopback), twin__mocap_wires=[wire])
    with socket.socket(socket.AF_INET, kind) as other:
        other.bind((loopback, port))
        if kind is socket.SOCK_STREAM:
            other.listen()
        refuse_taken_ports(site_at(loopback), web=True)
        with pytest.raises(LinkError, match=f"{words}.*tracking.{wire}_port"):
            refuse_taken_ports(site, web=True)


def test_real_hardware_needs_no_ports_but_the_consoles(loopback: str) -> None:
    names = {
        need.name for need in port_needs(changed(site_at(loopback), twin__enabled=False), web=True)
    }
    assert names == {"console"}


def test_the_command_says_which_port_and_what_to_change(
    loopback: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "site.toml"
    file.write_text(f'[drone]\naddress = "{loopback}"\n[tracking]\naddress = "{loopback}"\n')
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        other.bind((loopback, 5554))
        assert (
            main(
                [
                    "fly",
                    "entrance",
                    "--headless",
                    "--site",
                    str(file),
                    "--out",
                    str(tmp_path / "out"),
                ]
            )
            == 2
        )
    told = capsys.readouterr().err
    assert "UDP 5554" in told
    assert "drone.address" in told
