"""What the tables and findings are measured from, once for all tests, with few drones."""

from __future__ import annotations

import pytest

from housefly.config.site import Site, site_from_file
from housefly.lab.reproduction.angular_step import simulated_step
from housefly.lab.reproduction.evidence import Evidence, gather

SEEDS = 6


@pytest.fixture(scope="session")
def site() -> Site:
    """Return the shipped site, with its virtual obstacles."""
    from pathlib import Path

    from housefly import sites

    return site_from_file(Path(sites.__file__).parent / "bsen.toml")


@pytest.fixture(scope="session")
def evidence(site: Site) -> Evidence:
    """Return the evidence of a small run, with the step in pitch of a drone that answers late."""
    from dataclasses import replace

    return replace(gather(site, SEEDS), pitch=simulated_step(site.drone.attitude_lag, 0.07))
