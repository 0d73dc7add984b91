"""Several drones in one site: what all have, what a model has, what each has of its own."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.drones import drone_in_tree
from housefly.config.site import Site, changed, site_from_file, site_from_tree
from housefly.errors import ConfigError

RED = {"name": "red", "address": "127.0.0.1"}
BLUE = {"name": "blue", "address": "127.0.0.2", "pad": (4.0, 1.5, 0.0)}


def site_with(*drones: dict[str, Any], **tables: Any) -> Site:
    return site_from_tree({"drones": drones, **tables})


def test_a_site_without_the_table_has_one_drone_called_drone_and_is_its_own() -> None:
    site = Site()
    assert site.drone_names == ("drone",) and site.for_drone("drone") is site
    assert changed(site, drone__enabled=False).drone_names == ()


DRAGS = st.one_of(st.none(), st.floats(0.0, 5.0))


@given(DRAGS, DRAGS, DRAGS)
def test_the_nearer_word_counts_the_drones_before_the_models_before_that_of_all(
    of_all: float | None, of_model: float | None, own: float | None
) -> None:
    def table(value: float | None, **more: Any) -> dict[str, Any]:
        return more if value is None else {**more, "drag": value}

    site = site_with(
        table(own, **RED, model="fast"),
        BLUE,
        drone=table(of_all),
        models={"fast": table(of_model)},
    )
    nearest = next(drag for drag in (own, of_model, of_all, Site().drone.drag) if drag is not None)
    assert site.for_drone("red").drone.drag == nearest
    assert site.for_drone("blue").drone.drag == (Site().drone.drag if of_all is None else of_all)


def test_the_site_of_one_drone_has_its_body_and_pad_and_still_knows_the_others() -> None:
    site = site_with(RED, BLUE | {"body": "cf2"}, drone={"has_video": False})
    red, blue = site.for_drone("red"), site.for_drone("blue")
    assert (red.drone.name, red.tracking.body, red.drone.pad) == ("red", "red", None)
    assert (blue.tracking.body, blue.drone.pad) == ("cf2", (4.0, 1.5, 0.0))
    assert blue.drone_names == site.drone_names == ("red", "blue")
    assert not blue.has_picture and red.for_drone("blue") == blue


def test_a_site_with_drones_survives_json_and_changes_for_all(tmp_path: Path) -> None:
    site = site_with(RED, BLUE, models={"fast": {"drag": 0.3}})
    for number, one in enumerate((site, site.for_drone("blue"))):
        file = tmp_path / f"{number}.json"
        file.write_text(one.model_dump_json())
        assert site_from_file(file) == one
        assert site_from_file(file).for_drone("red") == site.for_drone("red")
    assert changed(site, drone__drag=0.7).for_drone("blue").drone.drag == 0.7


def test_the_driver_finds_its_drone_in_the_file_of_the_run_without_reading_all_of_it() -> None:
    site = site_with(RED, BLUE, models={"fast": {"drag": 0.3}}, drone={"has_video": False})
    for one in (site, site.for_drone("red")):
        tree = json.loads(one.model_dump_json())
        assert drone_in_tree(tree, "blue") == site.for_drone("blue").drone
    assert drone_in_tree(json.loads(Site().model_dump_json()), "drone") == Site().drone


def test_a_profile_gives_its_constants_to_the_one_who_names_it(tmp_path: Path) -> None:
    (tmp_path / "red.toml").write_text("[constants]\ndrag = 0.31\n")
    site = tmp_path / "site.toml"
    site.write_text(
        '[[drones]]\nname = "red"\nprofile = "red.toml"\n'
        '[[drones]]\nname = "blue"\naddress = "127.0.0.2"\npad = [4.0, 1.5, 0.0]\n'
    )
    read = site_from_file(site)
    assert read.for_drone("red").drone.drag == 0.31
    assert read.for_drone("blue").drone.drag == Site().drone.drag
    elsewhere = tmp_path / "run" / "site.json"
    elsewhere.parent.mkdir()
    elsewhere.write_text(read.model_dump_json())
    assert site_from_file(elsewhere) == read, "a run reads its site in a folder of its own"


@pytest.mark.parametrize(
    ("drones", "words"),
    [
        ([RED, BLUE | {"name": "red"}], "two are called 'red'; give each a name"),
        ([RED, BLUE | {"body": "red"}], "'red' and 'blue' have the same body"),
        ([RED, BLUE | {"address": "127.0.0.1"}], "the same address .127.0.0.1.; .*give each"),
        ([RED, {**BLUE, "pad": None}], "both stand on the room's pad; give one of them a pad"),
        (
            [RED | {"pad": (4.0, 1.0, 0.0)}, BLUE],
            r"0\.50 m apart; allowed: 1\.19 m or more",
        ),
        ([RED | {"name": "all"}], "what orders call every drone; choose another"),
        ([RED | {"name": "any"}], "what orders call whichever is free; choose another"),
        ([RED | {"name": "Red Baron"}], "drones.0.name: is 'Red Baron'"),
        ([RED | {"name": "visitor"}], "'visitor' is a person's or a piece of furniture's"),
        ([RED | {"body": "wagon"}], "'wagon', which is the drone or the visitor"),
        ([RED | {"name": "cart"}], "'cart' is a person's or a piece of furniture's"),
        ([RED | {"model": "ardron"}], "did you mean 'ardrone'"),
        ([RED | {"hull_length": 9.0}], r"drones.0.hull_length: is 9.0; allowed: .*2 m"),
        ([RED | {"attitude_lag": 0.5}], "loop would be unstable"),
    ],
)
def test_drones_that_cannot_be_told_apart_or_flown_are_refused_in_words(
    drones: list[dict[str, Any]], words: str
) -> None:
    with pytest.raises(ConfigError, match=words):
        site_with(*drones, furniture=[{"name": "cart", "body": "wagon"}], control={"beta": 2.0})


def test_an_unknown_drone_is_refused_with_those_there_are() -> None:
    with pytest.raises(ConfigError, match=r"none called 'bleu': did you mean 'blue'.*red, blue"):
        site_with(RED, BLUE).for_drone("bleu")
    with pytest.raises(ConfigError, match=r"none called 'red' .there is: drone"):
        Site().for_drone("red")
    with pytest.raises(ConfigError, match=r"drone.name .green. is none of"):
        site_with(RED, BLUE, drone={"name": "green"})
