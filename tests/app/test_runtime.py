"""What the launcher hands on to the processes of a run, and which there are."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from housefly.app.launcher import Landing, processes_of
from housefly.app.new_runtime import discovery_entry, new_runtime
from housefly.app.runtime import runtime_from_environment
from housefly.config.site import Site, changed, site_from_tree
from housefly.errors import ConfigError

BLUE = {"name": "blue", "address": "127.0.0.2", "pad": (4.0, 4.0, 0.0)}
TWO = changed(Site(), drones=[{"name": "red"}, BLUE], hub__store="")


def test_a_process_of_the_run_knows_all_endpoints_by_the_names_of_the_drones(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    runtime = new_runtime(TWO, tmp_path)
    monkeypatch.setattr(os, "environ", runtime.environment())
    heard = runtime_from_environment()
    assert heard == runtime and list(heard.stop_ports) == ["red", "blue"]
    assert len(set(heard.stop_ports.values())) == 2
    assert heard.driver_socket("red") != heard.driver_socket("blue")
    assert discovery_entry(runtime).drones == ("red", "blue")
    monkeypatch.setitem(os.environ, "HOUSEFLY_STOP_PORTS", "red=soon")
    with pytest.raises(ConfigError, match="start this process with `housefly run`"):
        runtime_from_environment()


def test_each_drone_has_a_pilot_and_a_driver_and_the_drivers_land_last(tmp_path: Path) -> None:
    specs = {spec.name: spec for spec in processes_of(new_runtime(TWO, tmp_path))}
    for name in ("red", "blue"):
        pilot, driver = specs[f"pilot-{name}"], specs[f"driver-{name}"]
        assert pilot.arguments == driver.arguments == ("--drone", name)
        assert (pilot.lands, driver.lands) == (Landing.FIRST, Landing.LAST)
    alone = {spec.name for spec in processes_of(new_runtime(Site(), tmp_path))}
    assert {"pilot", "driver"} <= alone and not {name for name in alone if "-" in name}


def test_the_ports_of_a_run_are_none_that_an_outgoing_connection_may_take(tmp_path: Path) -> None:
    own = {"broker": "127.0.0.1", "start": True, "port": 0}
    site = site_from_tree({"mqtt": own})
    ports = {new_runtime(site, tmp_path).site().mqtt.port for _ in range(3)}
    assert all(1024 < port < 32_768 for port in ports)
