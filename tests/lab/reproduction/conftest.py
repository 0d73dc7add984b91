"""What the tables and findings are measured from, once for all tests, with few drones."""

from __future__ import annotations

import pytest

from housefly.config.site import Site, site_from_file
from housefly.lab.experiments.cases import Cases
from housefly.lab.experiments.engine import Progress, fly_many
from housefly.lab.experiments.flight_plan import FlightPlan
from housefly.lab.experiments.outcomes import Outcomes
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
def flown() -> list[int]:
    """Return how many drones each batch of the evidence has."""
    return []


@pytest.fixture(scope="session")
def evidence(site: Site, flown: list[int]) -> Evidence:
    """Return the evidence of a small run, with the step in pitch of a drone that answers late."""
    from dataclasses import replace

    def fly(cases: Cases, mission: FlightPlan, *, on_progress: Progress | None = None) -> Outcomes:
        flown.append(len(cases))
        return fly_many(cases, mission, on_progress=on_progress)

    pitch = simulated_step(site.drone.attitude_lag, 0.07)
    return replace(gather(site, SEEDS, fly=fly), pitch=pitch)
