"""Obstacles that nobody expected: what the way touches is decided by where they truly stand."""

from __future__ import annotations

from dataclasses import asdict

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.site import Site, changed
from housefly.lab.reproduction.routes import MappedSite, mapped_site
from housefly.lab.reproduction.unexpected import PERSON, STOOL, put_unexpected, touches

WAY = ((1.0, 1.0), (4.0, 1.0), (4.0, 3.0))
HERE = mapped_site(Site(), "default")


@pytest.fixture(scope="module")
def here(site: Site) -> MappedSite:
    return mapped_site(site, "default")


@given(st.floats(0.0, 5.0), st.floats(-1.0, 5.0), st.floats(0.0, 2.5), st.floats(0.0, 2.5))
def test_a_taller_obstacle_is_in_the_way_where_a_lower_one_is(
    x: float, y: float, one: float, other: float
) -> None:
    low, high = sorted((one, other))
    assert touches(HERE, WAY, (x, y), high) or not touches(HERE, WAY, (x, y), low)


@pytest.mark.parametrize(
    ("gap", "hit"), [(0.0, True), (0.2 + 0.33, True), (0.2 + 0.36, False), (1.5, False)]
)
def test_the_hull_touches_what_is_closer_than_half_its_diagonal(gap: float, hit: bool) -> None:
    assert touches(HERE, WAY, (2.5, 1.0 - gap), PERSON) is hit


def test_people_on_the_way_are_hit_stools_are_not_and_the_updated_way_passes_both(
    here: MappedSite,
) -> None:
    found = put_unexpected(here)
    assert found.hit_static == found.on_way > 5
    assert found.hit_low == 0 == found.hit_updated
    assert 0 < found.hit_all_over < found.all_over
    assert 0 < found.hit_walked < found.walked == 4 * found.on_way


def test_the_old_way_stays_good_over_everybodys_head(site: Site) -> None:
    found = put_unexpected(mapped_site(changed(site, map__flight_height=2.0), "default"))
    assert found.hit_static == found.hit_all_over == 0 < found.on_way


def test_a_map_that_does_not_see_them_is_no_better_than_the_old_one(here: MappedSite) -> None:
    found = put_unexpected(here, seen=False)
    assert found.hit_updated == found.hit_static == found.on_way


def test_stools_everywhere_are_as_harmless_as_the_stools_on_the_way(here: MappedSite) -> None:
    assert asdict(put_unexpected(here, height=STOOL))["hit_static"] == 0
