"""What the tables and findings are measured from, once for all tests, with few drones."""

from __future__ import annotations

import pytest

from housefly.config.site import Site, site_from_file
from housefly.lab.reproduction.angular_step import AngularStep
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
    """Return the evidence of a small run, with a step in pitch as the twin answers it."""
    from dataclasses import replace

    step = AngularStep(
        lag=7.0, gain=1.0, delay=0.07, misfit=0.01, lag_without_delay=3.0, misfit_without_delay=0.06
    )
    return replace(gather(site, SEEDS), pitch=step)
