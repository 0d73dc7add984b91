import json
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.airframe import airframe_named
from housefly.config.section import Section
from housefly.config.site import Site, changed, site_from_file, site_from_tree
from housefly.errors import ConfigError
from housefly.room.draft.codec import draft_from_json

NUMBERS = [
    (
        section,
        key,
        next(item.ge for item in found.metadata if hasattr(item, "ge")),
        next(i.le for i in found.metadata if hasattr(i, "le")),
    )
    for section, outer in Site.model_fields.items()
    if isinstance(outer.annotation, type) and issubclass(outer.annotation, Section)
    for key, found in outer.annotation.model_fields.items()
    if found.annotation is float
]


def test_an_empty_file_is_a_valid_site(tmp_path: Path) -> None:
    file = tmp_path / "site.toml"
    file.write_text("")
    assert site_from_file(file) == Site()


@pytest.mark.parametrize(("section", "key", "low", "high"), NUMBERS)
@pytest.mark.parametrize("side", ["below", "above", "nan", "text"])
def test_a_number_out_of_range_is_refused_with_its_key_and_range(
    section: str, key: str, low: float, high: float, side: str
) -> None:
    value = {"below": low - 1, "above": high + 1, "nan": float("nan"), "text": "fast"}[side]
    with pytest.raises(ConfigError) as caught:
        site_from_tree({section: {key: value}})
    assert caught.value.key == f"{section}.{key}"
    assert f"from {low:g} to {high:g}" in caught.value.problem


def test_an_unknown_key_is_named() -> None:
    with pytest.raises(ConfigError, match=r"limits\.sped: is not a known key"):
        site_from_tree({"limits": {"sped": 1.0}})


@pytest.mark.parametrize(
    ("tree", "words"),
    [
        ({"limits": {"height_min": 1.5, "height_max": 1.2}}, "height_min"),
        ({"limits": {"pose_age_level": 1.0, "pose_age_land": 0.9}}, "pose_age_level"),
        ({"map": {"flight_height": 2.3}}, "flight_height"),
        ({"control": {"alpha": 0.2, "beta": 2.0}}, "unstable"),
        ({"twin": {"natnet_group": "10.0.0.1"}}, "multicast address, 224.0.0.0 to 239.255.255.255"),
        ({"twin": {"natnet_group": "somewhere"}}, "multicast address"),
        (
            {"tracking": {"kind": "bridge", "bridge_system": "qualisys"}},
            "none that the twin poses as",
        ),
        ({"map": {"virtual_obstacles": [{"rectangle": [2, 0, 1, 1]}]}}, "x_min < x_max"),
    ],
)
def test_a_combination_that_cannot_fly_is_refused_in_words(
    tree: dict[str, object], words: str
) -> None:
    with pytest.raises(ConfigError, match=words):
        site_from_tree(tree)


@pytest.mark.parametrize(
    ("tree", "key"),
    [
        ({"tracking": {"kind": "magic"}}, "tracking.kind"),
        ({"tracking": {"natnet_port": 0}}, "tracking.natnet_port"),
        ({"tracking": {"vrpn_port": 65536}}, "tracking.vrpn_port"),
        ({"tracking": {"vrpn_transport": "pigeon"}}, "tracking.vrpn_transport"),
        ({"tracking": {"up_axis": "x"}}, "tracking.up_axis"),
        ({"tracking": {"bridge_system": "Not A Name"}}, "tracking.bridge_system"),
        ({"twin": {"mocap_wires": ["vicon", "smell"]}}, "twin.mocap_wires"),
        ({"twin": {"natnet_version": "2.0"}}, "twin.natnet_version"),
    ],
)
def test_a_choice_that_does_not_exist_is_refused_with_its_key(
    tree: dict[str, object], key: str
) -> None:
    with pytest.raises(ConfigError) as caught:
        site_from_tree(tree)
    assert caught.value.key.startswith(key)


@pytest.mark.parametrize(
    ("tracking", "beside", "served"),
    [
        ({}, [], ("vicon",)),
        ({"kind": "natnet"}, [], ("natnet",)),
        ({"kind": "vrpn"}, ["vicon", "natnet", "vrpn"], ("vrpn", "vicon", "natnet")),
        ({"kind": "bridge", "bridge_system": "optitrack"}, [], ("natnet",)),
        ({"kind": "bridge", "bridge_system": "qualisys"}, ["vicon"], ("vicon",)),
    ],
)
def test_the_twin_serves_what_the_tracking_client_reads_and_what_is_asked_beside(
    tracking: dict[str, object], beside: list[str], served: tuple[str, ...]
) -> None:
    assert (
        site_from_tree({"tracking": tracking, "twin": {"mocap_wires": beside}}).served_wires
        == served
    )


@pytest.mark.parametrize(
    ("kind", "axis", "y_up"),
    [
        ("vicon", "auto", False),
        ("natnet", "auto", True),
        ("vrpn", "auto", False),
        ("natnet", "z", False),
        ("vrpn", "y", True),
    ],
)
def test_motive_has_y_up_unless_told_otherwise(kind: str, axis: str, y_up: bool) -> None:
    assert site_from_tree({"tracking": {"kind": kind, "up_axis": axis}}).tracking.y_up is y_up


@pytest.mark.parametrize("text", ["name = ", "\x00", "[limits", "name = 3"])
def test_a_broken_file_is_refused_and_named(tmp_path: Path, text: str) -> None:
    file = tmp_path / "broken.toml"
    file.write_text(text)
    with pytest.raises(ConfigError, match=r"broken\.toml"):
        site_from_file(file)


def test_a_missing_file_is_a_clear_error(tmp_path: Path) -> None:
    with pytest.raises(ConfigError, match="cannot be read"):
        site_from_file(tmp_path / "nowhere.toml")


@given(st.integers(0, 2**31 - 1))
def test_changing_a_key_keeps_all_others(seed: int) -> None:
    site = changed(Site(), twin__seed=seed)
    assert site.twin.seed == seed
    assert changed(site, twin__seed=Site().twin.seed) == Site()


def test_a_site_whose_model_is_changed_has_the_constants_of_the_new_one() -> None:
    tello = airframe_named("tello")
    given = Site(drone={"attitude_lag": 6.5})
    twice = changed(changed(given, twin__seed=3), drone__kind="tello").drone
    assert (twice.hull_length, twice.drag) == (tello.body.hull_length, tello.response.drag)
    assert twice.attitude_lag == 6.5, "what somebody gave stays"
    own = [
        {"name": "anna", "model": "crazyflie", "address": "127.0.0.2"},
        {"name": "bert", "model": "crazyflie", "address": "127.0.0.3", "pad": [2.0, 2.0, 0.0]},
    ]
    several = changed(Site(drones=own), drone__kind="tello", twin__seed=3)
    crazyflie = airframe_named("crazyflie")
    assert {one.hull_length for one in several.all_drones} == {crazyflie.body.hull_length}


def test_a_site_survives_the_way_through_json(tmp_path: Path) -> None:
    file = tmp_path / "site.json"
    site = changed(Site(), name="lab", twin__mocap_rate_hz=30.0)
    file.write_text(site.model_dump_json())
    assert site_from_file(file) == site


def test_mode_paper_has_the_limits_that_it_always_had() -> None:
    paper = changed(Site(), mode="paper", limits__climb_command_max=1.5).limits
    assert paper.full_climb == paper.vertical_speed_max == Site().limits.vertical_speed_max
    assert paper.onboard_height_max == paper.height_max
    assert (paper.landing_height, paper.landing_lead) == (0.45, 0.0)


def test_a_drone_may_ask_for_more_climb_than_it_flies_at() -> None:
    limits = changed(Site(), limits__vertical_speed_max=1.2).limits
    assert limits.full_climb == 1.2 and limits.onboard_height_max == limits.height_max
    assert Site().limits.full_climb == 1.0 and Site().limits.onboard_height_max == 3.0


def test_a_filter_that_takes_a_millimetre_of_noise_as_motion_is_refused() -> None:
    keys = {"control__position_noise": 0.0001, "control__acceleration_noise": 13.2}
    with pytest.raises(ConfigError, match=r"control.acceleration_noise \(13.2 m/s\^2\) must not"):
        changed(Site(), **keys)
    assert changed(Site(), mode="paper", **keys).control.position_noise == 0.0001
    changed(Site(), control__position_noise=0.0001, control__acceleration_noise=0.4)


@pytest.mark.parametrize("floor", [(-1000.0, 0.0, 1000.0, 5.0), (0.0, 0.0, 5.0, 201.0)])
def test_a_floor_that_no_memory_would_hold_is_refused(
    floor: tuple[float, float, float, float],
) -> None:
    with pytest.raises(ConfigError, match="allowed: up to 200 m along each side"):
        changed(Site(), map__paper_rectangle=floor)
    with pytest.raises(ConfigError, match="allowed: up to 200 m along each side"):
        draft_from_json(json.dumps({"bounds": floor}))
