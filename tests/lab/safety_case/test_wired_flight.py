from __future__ import annotations

from pathlib import Path

from housefly.config.site import Site
from housefly.hub.store.lock import locked_store, refuse_shared_store
from housefly.lab.safety_case.wired_flight import write_own_site
from housefly.sites.loaded_site import read_site


def test_flights_at_the_same_time_share_no_address_and_no_memory(tmp_path: Path) -> None:
    sites = []
    for seat in range(2):
        folder = tmp_path / str(seat)
        folder.mkdir()
        sites.append(read_site(str(write_own_site(folder, seat, scanned=True))))
    first, second = sites

    assert _addresses(first).isdisjoint(_addresses(second))
    with locked_store(first):
        refuse_shared_store(second)


def _addresses(site: Site) -> set[str]:
    return {site.drone.address, site.tracking.address, *(laser.address for laser in site.lasers)}
