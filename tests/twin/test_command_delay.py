"""What sending adds to a command's delay, and which delay the simulated drone takes."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from kinematic_world import KinematicWorld

from housefly.config.airframe import airframe_named
from housefly.config.profile import Interval, write_profile
from housefly.config.site import Site, changed, site_from_file
from housefly.config.twin import INNER_LOOP_DELAY
from housefly.lab.lockstep.lockstep_room import LockstepRoom
from housefly.messages import Action, Command, Setpoint
from housefly.messages.stick import Stick
from housefly.pilot.site_parameters import pilot_parameters
from housefly.twin.command_delay import (
    reaction_delay,
    sending_delay,
    simulated_command_delay,
)

COMMAND_DELAY = airframe_named("ardrone").response.command_delay

LINK = airframe_named("ardrone").link
_LOOKS = 10
"""How often in a tick the age of what the drone hears is looked at."""


def profiled(folder: Path, delay: float, more: str = "") -> Site:
    write_profile(folder / "drone.toml", {"command_delay": Interval(delay, delay, delay)}, {})
    file = folder / "site.toml"
    file.write_text(f'[drone]\nprofile = "drone.toml"\n{more}')
    return site_from_file(file)


@pytest.mark.parametrize("rate", [25.0, 50.0, 80.0, 100.0, 125.0, 200.0])
def test_the_delay_of_sending_is_the_age_of_what_the_drone_hears(rate: float) -> None:
    class Hearing(KinematicWorld):
        heard = 0.0

        def advance(self, seconds: float) -> None:
            self._now += seconds

        def set_stick(self, stick: Stick) -> None:
            self.heard = stick.forward

    world, site = Hearing(), changed(Site(), control__rate_hz=rate)
    room, ages = LockstepRoom(world, site), list[float]()
    ticks, look = round(8.0 * rate), 1.0 / rate / _LOOKS
    for tick in range(ticks):
        # The stick says in which tick its command was given.
        room.send(Command(Action.FLY, Setpoint(theta=tick / ticks * site.limits.tilt_max)))
        for _ in range(_LOOKS):
            if tick > ticks // 4:
                ages.append(room.now + 0.5 * look - world.heard * ticks / rate)
            room.advance(look)
    measured = sum(ages) / len(ages) - 0.5 / rate
    assert sending_delay(rate, LINK) == pytest.approx(measured, abs=0.002)


@given(st.floats(20.0, 200.0))
def test_sending_adds_less_than_one_datagram(rate: float) -> None:
    assert -1e-9 <= sending_delay(rate, LINK) < 0.035


def test_with_a_profile_pilot_and_simulated_drone_have_its_delay(tmp_path: Path) -> None:
    site = profiled(tmp_path, 0.11)
    params = pilot_parameters(False, site.drone, site.control, site.limits)
    assert params.estimator.delay == params.gains.delay == 0.11
    assert reaction_delay(site) == pytest.approx(0.11)
    assert simulated_command_delay(site) == pytest.approx(0.11 - 0.01 - INNER_LOOP_DELAY)


def test_a_site_as_flown_is_read_without_its_profile(tmp_path: Path) -> None:
    site = profiled(tmp_path, 0.11)
    (tmp_path / "drone.toml").unlink()
    flown = tmp_path / "elsewhere" / "site.json"
    flown.parent.mkdir()
    flown.write_text(site.model_dump_json())
    assert site_from_file(flown) == site
    assert simulated_command_delay(site_from_file(flown)) == simulated_command_delay(site)


def test_the_sites_own_delay_of_the_simulated_drone_wins_over_the_profile(tmp_path: Path) -> None:
    site = profiled(tmp_path, 0.11, "[twin]\ncommand_delay = 0.03\n")
    assert simulated_command_delay(site) == 0.03
    assert reaction_delay(site) == pytest.approx(0.04 + INNER_LOOP_DELAY)


def test_a_profile_shorter_than_sending_leaves_no_delay_of_the_drones_own(tmp_path: Path) -> None:
    assert simulated_command_delay(profiled(tmp_path, 0.005)) == 0.0


def test_without_a_profile_the_simulated_drone_has_the_shipped_delay() -> None:
    assert simulated_command_delay(Site()) == COMMAND_DELAY
    real = changed(Site(), twin__enabled=False, drone__command_delay=0.08)
    assert reaction_delay(real) == 0.08
