"""What an airframe file must say, and how it is told what is wrong."""

from __future__ import annotations

from pathlib import Path

import pytest
from pydantic import ValidationError

from housefly.config.airframe import FOLDER, airframe_in, airframe_named, airframe_names
from housefly.config.drone import DroneConfig
from housefly.config.site import Site, site_from_tree
from housefly.errors import ConfigError
from housefly.messages import SetpointForm
from housefly.pilot.behavior.braking import REFERENCE_BRAKING

GOOD = (FOLDER / "ardrone.toml").read_text(encoding="utf-8")


def written(folder: Path, text: str) -> Path:
    path = folder / "drone.toml"
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize("name", airframe_names())
def test_every_airframe_that_ships_can_be_read_and_a_site_may_name_it(name: str) -> None:
    site = site_from_tree({"drone": {"kind": name}})
    assert site.drone.airframe is airframe_named(name)
    assert site.drone.hull_length == airframe_named(name).body.hull_length


@pytest.mark.parametrize(
    ("good", "bad", "told"),
    [
        (
            "value = 0.436",
            "value = 43.6",
            "body.mass: is 43.6; allowed: a number from 0.01 to 10 kg",
        ),
        ("value = 0.58", "value = nan", "response.drag: is nan; allowed: a number from 0 to 5 1/s"),
        ("gain = 4.0", "gian = 4.0", "brake.gain: is missing"),
        ("lead = 0.2", "lead = 0.2\nleed = 0.2", "brake.leed: is not a known key"),
        ('"tilt and climb"', '"thrust"', "capabilities.setpoints.0: is 'thrust'"),
        ('"tilt and climb"', '"trajectory"', "setpoints: a place in the room means nothing"),
        ('"tilt and climb"', '"position"', "setpoints: a place in the room means nothing"),
        ('"tilt and climb"', '"velocity"', "response.velocity_lag is missing"),
        ('answer = "lands"', 'answer = "sings"', "capabilities.silence.answer: is 'sings'"),
    ],
)
def test_what_is_wrong_is_named_with_its_value_what_is_allowed_and_the_unit(
    tmp_path: Path, good: str, bad: str, told: str
) -> None:
    assert good in GOOD
    with pytest.raises(ConfigError) as error:
        airframe_in(written(tmp_path, GOOD.replace(good, bad, 1)))
    assert told in str(error.value) and "drone.toml" in str(error.value)


def test_a_number_that_is_from_nowhere_is_refused(tmp_path: Path) -> None:
    mass = 'mass = { value = 0.436, source = "Douthwaite, ARdrone.m; with indoor hull" }'
    assert mass in GOOD
    with pytest.raises(ConfigError, match=r"body\.mass: has no source"):
        airframe_in(written(tmp_path, GOOD.replace(mass, "mass = 0.436")))
    empty = mass.replace("Douthwaite, ARdrone.m; with indoor hull", " ")
    with pytest.raises(ConfigError, match=r"body.mass.source: is ' '"):
        airframe_in(written(tmp_path, GOOD.replace(mass, empty)))


def test_what_a_site_says_of_its_drone_wins_over_the_airframe() -> None:
    assert DroneConfig(drag=0.7).drag == 0.7
    assert Site().drone.drag == Site().drone.airframe.response.drag


@pytest.mark.parametrize("kind", ["", "tello9", "../ardrone", "ardrone.toml"])
def test_a_model_that_nobody_knows_is_refused_by_name(kind: str) -> None:
    with pytest.raises(ConfigError, match=r"drone.kind: is .*; allowed: ardrone"):
        site_from_tree({"drone": {"kind": kind}})


@pytest.mark.parametrize("name", airframe_names())
def test_every_drone_brakes_as_hard_as_a_reference_does_that_is_to_stop(name: str) -> None:
    assert airframe_named(name).braking.deceleration >= REFERENCE_BRAKING


def test_a_site_may_choose_another_form_of_setpoints_of_those_that_its_drone_takes() -> None:
    usual = DroneConfig(kind="crazyflie")
    chosen = DroneConfig(kind="crazyflie", steered_by="trajectory")
    assert usual.airframe.capabilities.form is SetpointForm.TILT_AND_CLIMB
    able = chosen.airframe.capabilities
    assert able.form is SetpointForm.POSITION and able.is_told_full_state
    assert set(able.setpoints) == set(usual.airframe.capabilities.setpoints)
    assert chosen.airframe.body == usual.airframe.body


def test_a_form_that_its_drone_does_not_take_is_refused_with_those_that_it_does() -> None:
    with pytest.raises(ValidationError, match="which DJI Tello does not take; allowed: velocity"):
        DroneConfig(kind="tello", steered_by="position")
