from __future__ import annotations

from itertools import product

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.house_mode import HouseMode
from housefly.tasks.api.values import Confirm, Priority, ReasonCode, RequestSurface
from housefly.tasks.rules.mode_table import MODE_TABLE, launch_permit

UNATTENDED = (
    RequestSurface.RULE,
    RequestSurface.WEBHOOK,
    RequestSurface.MQTT,
    RequestSurface.ASSISTANT,
    RequestSurface.ROS,
)
PEOPLE = (RequestSurface.CONSOLE, RequestSurface.COMMAND_LINE, RequestSurface.HTTP)
ANY = {
    "surface": st.sampled_from(RequestSurface),
    "confirm": st.sampled_from(Confirm),
    "priority": st.sampled_from(Priority),
    "names_mode": st.booleans(),
}


def test_each_mode_stands_in_the_table_and_says_what_it_allows() -> None:
    assert set(MODE_TABLE) == set(HouseMode)
    assert all(rules.words for rules in MODE_TABLE.values())


@given(**ANY)
def test_in_maintenance_no_task_flies_whoever_asks(
    surface: RequestSurface, confirm: Confirm, priority: Priority, names_mode: bool
) -> None:
    permit = launch_permit(
        HouseMode.MAINTENANCE, surface, confirm=confirm, priority=priority, names_mode=names_mode
    )
    assert permit.code is ReasonCode.MODE and "maintenance" in permit.words


@given(**ANY)
def test_in_privacy_nothing_flies_that_no_person_wanted(
    surface: RequestSurface, confirm: Confirm, priority: Priority, names_mode: bool
) -> None:
    permit = launch_permit(
        HouseMode.PRIVACY, surface, confirm=confirm, priority=priority, names_mode=names_mode
    )
    if surface in UNATTENDED and permit.is_given:
        assert priority is Priority.ALARM and permit.confirm is not Confirm.AUTO
    assert permit.is_given or surface in UNATTENDED


@given(mode=st.sampled_from(HouseMode), **ANY)
def test_a_mode_makes_a_confirmation_stricter_never_laxer(
    mode: HouseMode,
    surface: RequestSurface,
    confirm: Confirm,
    priority: Priority,
    names_mode: bool,
) -> None:
    permit = launch_permit(mode, surface, confirm=confirm, priority=priority, names_mode=names_mode)
    assert permit.confirm is confirm or (confirm, permit.confirm) == (Confirm.AUTO, Confirm.ASK)


def test_at_night_a_rule_flies_only_when_it_is_made_for_the_night_is_an_alarm_or_asks() -> None:
    def may(**given: object) -> bool:
        return launch_permit(HouseMode.NIGHT, RequestSurface.RULE, **given).is_given  # type: ignore[arg-type]

    assert not may(priority=Priority.RULE)
    assert may(priority=Priority.RULE, names_mode=True)
    assert may(priority=Priority.ALARM)
    assert may(priority=Priority.RULE, confirm=Confirm.ASK)


@pytest.mark.parametrize(
    ("mode", "surface"),
    [
        *product((HouseMode.HOME, HouseMode.AWAY), RequestSurface),
        *product((HouseMode.NIGHT, HouseMode.PRIVACY), PEOPLE),
    ],
)
def test_who_may_launch_may(mode: HouseMode, surface: RequestSurface) -> None:
    assert launch_permit(mode, surface).is_given


def test_what_does_not_fly_runs_in_every_mode() -> None:
    for mode, surface in product(HouseMode, RequestSurface):
        assert launch_permit(mode, surface, flies=False).is_given
