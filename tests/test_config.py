from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config import Section, Site, changed, load_site, site_from_tree
from housefly.errors import ConfigError

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
    assert load_site(file) == Site()


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
        ({"map": {"virtual_obstacles": [{"rectangle": [2, 0, 1, 1]}]}}, "x_min < x_max"),
    ],
)
def test_a_combination_that_cannot_fly_is_refused_in_words(tree: dict[str, object], words: str) -> None:
    with pytest.raises(ConfigError, match=words):
        site_from_tree(tree)


@pytest.mark.parametrize("text", ["name = ", "\x00", "[limits", "name = 3"])
def test_a_broken_file_is_refused_and_named(tmp_path: Path, text: str) -> None:
    file = tmp_path / "broken.toml"
    file.write_text(text)
    with pytest.raises(ConfigError, match=r"broken\.toml"):
        load_site(file)


def test_a_missing_file_is_a_clear_error(tmp_path: Path) -> None:
    with pytest.raises(ConfigError, match="cannot be read"):
        load_site(tmp_path / "nowhere.toml")


@given(st.integers(0, 2**31 - 1))
def test_changing_a_key_keeps_all_others(seed: int) -> None:
    site = changed(Site(), twin__seed=seed)
    assert site.twin.seed == seed
    assert changed(site, twin__seed=Site().twin.seed) == Site()


def test_a_site_survives_the_way_through_json(tmp_path: Path) -> None:
    file = tmp_path / "site.json"
    site = changed(Site(), name="lab", twin__mocap_rate_hz=30.0)
    file.write_text(site.model_dump_json())
    assert load_site(file) == site
