"""A real scheduler and real workers on loopback give the numbers that one thread gives here."""

from __future__ import annotations

import socket
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from housefly.errors import LinkError
from housefly.lab.campaigns import cluster as clusters
from housefly.lab.campaigns.cluster import ClusterFleet, fly_chunk
from housefly.lab.campaigns.folder import CampaignFolder
from housefly.lab.campaigns.plan import Plan
from housefly.lab.campaigns.provenance import processor, versions
from housefly.lab.campaigns.runner import Fleet, LocalFleet, fly_chunks

pytestmark = [pytest.mark.wire, pytest.mark.slow]


def fly(plan: Plan, path: Path, fleet: Fleet, landed: Any = lambda drones: None) -> bytes:
    with CampaignFolder(path, plan) as folder:
        fly_chunks(plan, folder.missing(), folder, fleet, landed)
        return folder.finish().read_bytes()


@pytest.fixture(autouse=True)
def _patience(monkeypatch: pytest.MonkeyPatch) -> None:
    """Wait for a worker that has to share its processor, too."""
    monkeypatch.setattr(clusters, "SCHEDULER_TIMEOUT", 60.0)


@pytest.fixture
def plan(small: Any) -> Plan:
    made: Plan = small(20, seeds=150)
    return made


@pytest.mark.interop
def test_a_worker_killed_in_the_middle_changes_no_bit(
    plan: Plan, cluster: Any, tmp_path: Path
) -> None:
    here = fly(plan, tmp_path / "one", LocalFleet(1))
    assert fly(plan, tmp_path / "four", LocalFleet(4)) == here
    for _ in range(2):
        cluster.add_worker()
    landings = iter(range(len(plan.chunks)))

    def landed(drones: int) -> None:
        if next(landings) == 3:
            cluster.workers[0].kill()
            cluster.workers[0].wait()

    with ClusterFleet(cluster.address) as fleet:
        fleet._client.wait_for_workers(2, timeout=60.0)
        assert fleet.foreign_processors() == set()
        assert fly(plan, tmp_path / "cluster", fleet, landed) == here
        assert len(fleet._client.nthreads()) == 1


@pytest.mark.interop
def test_a_cluster_whose_every_worker_dies_goes_on_when_one_comes(
    plan: Plan, cluster: Any, tmp_path: Path
) -> None:
    first = cluster.add_worker()
    landings = iter(range(len(plan.chunks)))

    def landed(drones: int) -> None:
        if next(landings) == 3:
            first.kill()
            first.wait()
            cluster.add_worker(threads=2)

    with ClusterFleet(cluster.address) as fleet:
        assert fly(plan, tmp_path / "cluster", fleet, landed) == fly(
            plan, tmp_path / "one", LocalFleet(1)
        )


@pytest.mark.interop
def test_a_scheduler_that_goes_away_is_told_and_the_rest_is_flown_here(
    plan: Plan, cluster: Any, tmp_path: Path
) -> None:
    cluster.add_worker()
    with (
        ClusterFleet(cluster.address) as fleet,
        pytest.raises(LinkError, match="is gone; what has landed is kept"),
    ):
        fly(plan, tmp_path / "a", fleet, lambda drones: cluster.scheduler.kill())
    with CampaignFolder(tmp_path / "a", plan) as folder:
        assert 0 < len(folder.missing()) < len(plan.chunks)
    assert fly(plan, tmp_path / "a", LocalFleet(2)) == fly(plan, tmp_path / "one", LocalFleet(1))


def test_an_address_where_nobody_answers_is_told(
    loopback: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(clusters, "SCHEDULER_TIMEOUT", 0.5)
    for address in (f"tcp://{loopback}:9", "nowhere", "tcp://"):
        with pytest.raises(LinkError, match=f"no scheduler answers at {address}"):
            ClusterFleet(address)


def test_somebody_else_who_listens_there_is_no_scheduler(
    loopback: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(clusters, "SCHEDULER_TIMEOUT", 0.5)
    with socket.create_server((loopback, 0)) as stranger:
        address = f"tcp://{loopback}:{stranger.getsockname()[1]}"
        with pytest.raises(LinkError, match=f"no scheduler answers at {address}"):
            ClusterFleet(address)


def test_a_scheduler_without_workers_is_told(cluster: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(clusters, "SCHEDULER_TIMEOUT", 1.0)
    with pytest.raises(LinkError, match=r"no worker at tcp://.*start one with: dask worker tcp://"):
        ClusterFleet(cluster.address)


@pytest.fixture
def other_versions(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Let this machine believe that it has another numba; the workers know nothing of it."""
    monkeypatch.setattr(clusters, "versions", _Older())
    yield


class _Older:
    """Pickled for a worker it is the worker's own ``versions``."""

    def __call__(self) -> dict[str, str]:
        return versions() | {"numba": "0.1"}

    def __reduce__(self) -> Any:
        return getattr, (
            __import__("housefly.lab.campaigns.provenance", fromlist=["versions"]).versions,
            "__wrapped__",
        )


def test_workers_with_other_versions_are_refused_by_name(
    cluster: Any, other_versions: None
) -> None:
    cluster.add_worker()
    with pytest.raises(LinkError, match=r"has numba [\d.]+, this machine 0.1"):
        ClusterFleet(cluster.address)


def test_a_worker_that_joins_later_with_other_versions_is_refused(plan: Plan) -> None:
    cases, _ = plan.cases_of(plan.chunks[0])
    with pytest.raises(LinkError, match="one that joined later has code"):
        fly_chunk(cases, plan.groups[0].mission, versions() | {"code": "another"})


def test_the_processor_has_a_name() -> None:
    assert processor()
