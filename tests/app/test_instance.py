"""Rooms side by side share no address, no port, no topic and no memory."""

from __future__ import annotations

import socket
from argparse import Namespace
from pathlib import Path

import pytest

from housefly.app.commands.asked_room import asked_site
from housefly.app.instance import free_instance, site_of_instance
from housefly.app.ports import port_needs, refuse_taken_ports
from housefly.config.site import Site, changed
from housefly.config.state import database_file, edits_folder, tasks_folder
from housefly.errors import ConfigError, LinkError
from housefly.hub.store.lock import reserved_store
from housefly.sites.loaded_site import read_site
from housefly.twin.demo_site import demo_site


@pytest.fixture(autouse=True)
def _own_state(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))


def demo(**changes: object) -> Site:
    return changed(demo_site(read_site("bsen"), has_broker=True)[0], **changes)


def owned(site: Site) -> set[str]:
    """Return everything that a room has to itself."""
    return {
        f"drone {site.drone.address}",
        f"tracking {site.tracking.address}",
        *(f"laser {laser.address}:{laser.port}" for laser in site.lasers),
        f"console {site.web.port}",
        f"foxglove {site.foxglove.port}",
        f"topic {site.mqtt.site}",
        site.name,
        *(str(folder(site)) for folder in (database_file, edits_folder, tasks_folder)),
    }


def test_instances_share_nothing_and_the_first_is_the_site_as_it_is() -> None:
    sites = [site_of_instance(demo(), number) for number in range(1, 10)]
    assert sites[0] == demo()
    everything = [one for site in sites for one in owned(site)]
    assert len(everything) == len(set(everything))
    assert sites[1].drone.address == "127.0.2.1" and sites[1].web.port == 8081
    kept = site_of_instance(demo(hub__store="/tmp/x/mine.db"), 3)
    assert kept.hub.store == "/tmp/x/mine-3.db"


def test_each_drone_of_an_instance_has_an_address_of_its_own() -> None:
    blue = {"name": "blue", "address": "127.0.0.2", "pad": (4.0, 4.0, 0.0)}
    site = site_of_instance(changed(Site(), drones=[{"name": "red"}, blue]), 2)
    assert [drone.address for drone in site.all_drones] == ["127.0.2.1", "127.0.2.2"]
    needs = {need.name: need.address for need in port_needs(site, web=False)}
    assert needs["simulated drone red"] == "127.0.2.1"
    assert needs["simulated drone blue"] == "127.0.2.2"


def test_what_cannot_stand_beside_another_is_refused_in_words() -> None:
    with pytest.raises(ConfigError, match=r"--instance: is 0; allowed: 1 to 9"):
        site_of_instance(demo(), 0)
    with pytest.raises(ConfigError, match="real drone, which only one run can fly"):
        site_of_instance(changed(Site(), twin__enabled=False), 2)


def test_the_next_free_instance_is_found_and_named_where_a_port_is_taken(loopback: str) -> None:
    here = {"drone__address": loopback, "tracking__address": loopback, "web__host": loopback}
    site = demo(lasers=[], **here)
    assert free_instance(site, web=True) == 1
    with reserved_store(site):
        assert free_instance(site, web=True) == 2
    with socket.socket() as other:
        other.bind((loopback, 8010))
        other.listen()
        assert free_instance(site, web=True) == 2
        with pytest.raises(LinkError, match="--instance 2"):
            refuse_taken_ports(site, web=True)


def test_a_question_finds_the_memory_of_its_instance() -> None:
    assert asked_site(Namespace(site=None, instance=None)).name == "B-sen"
    second = asked_site(Namespace(site=None, instance=2))
    assert second.name == "B-sen 2" and second.twin.scene == "demo"
