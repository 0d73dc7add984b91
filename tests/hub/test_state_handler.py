"""Yes, no or that nobody knows: of devices and people, now, then, and while nothing runs."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path
from typing import Any

import pytest

from housefly.errors import ThingError, WireError
from housefly.hub.api.answers import SituationAnswer
from housefly.hub.api.questions import NightsQuestion, PeopleQuestion, StateQuestion
from housefly.hub.person_status import RoomMoment, person_answer
from housefly.hub.query_handler import QueryHandler
from housefly.hub.situations.device_traits import DeviceTraits
from housefly.hub.things.thing import Thing, ThingKind
from housefly.hub.things.world_model import WorldModel
from housefly.messages import Fact, Observation, RoomEvent
from housefly.sensors.contracts import SensorHealth

DEVICES = {
    "stove-plug": DeviceTraits("stove", "power", 50.0, 20.0, 60.0),
    "a-stove-switch": DeviceTraits("stove", "switch", heartbeat=60.0),
    "oven-probe": DeviceTraits("oven", "temperature", 60.0, 30.0, 300.0),
}
NOW = 1_800_000_000.0
ON, OFF = "appliance on", "appliance on ended"


class Asked:
    """A room with devices and people that is asked yes-or-no questions."""

    def __init__(self, house: Any) -> None:
        self.house = house
        house.answers = QueryHandler(house.memory, house.status, lambda: house.now, DEVICES)
        for thing in (
            Thing("stove", "the stove"),
            Thing("oven", "the oven"),
            Thing("kitchen-window", "the kitchen window"),
            Thing("person-1", "the resident", ThingKind.PERSON, ("resident",)),
        ):
            house.memory.world.add_thing(thing)
        house.status.add_health_source(lambda: (SensorHealth("x", "x", "x", True),))

    def says(
        self, device: str, ago: float, *facts: tuple[str, Fact], received: float | None = None
    ) -> None:
        at = self.house.now - ago
        self.house.memory.add(Observation(device, device, at, received or at, facts=facts))

    def happens(self, kind: str, thing: str, ago: float, *facts: tuple[str, Fact]) -> None:
        source = "hub" if kind == "memory started" else "situations/test"
        at = self.house.now - ago
        self.house.memory.add(RoomEvent(kind, thing, at, source, facts=facts))

    def holds(self, *rows: tuple[str, str, float, str, dict[str, Any]]) -> None:
        self.house.status.set_situations(
            SituationAnswer(
                kind, thing, self.house.now - ago, 0.8, evidence, facts, (evidence.split(":")[0],)
            )
            for kind, thing, ago, evidence, facts in rows
        )

    def words(self, thing: str, state: str, at: float | None = None) -> str:
        return str(self.house.ask(StateQuestion(thing, state, at)).words)


@pytest.fixture
def asked(house: Any) -> Asked:
    return Asked(house)


def test_a_stove_that_draws_power_is_on_and_the_power_and_its_age_are_told(asked: Asked) -> None:
    asked.says("stove-plug", 12.0, ("power", 1420.0))
    assert asked.words("stove", "on") == "Yes: the stove draws 1 420 W, 12 s ago"
    assert asked.words("stove", "off") == "No: the stove draws 1 420 W, 12 s ago"
    answer = asked.house.ask(StateQuestion("stove", "on"))
    assert (answer.answer, answer.age, answer.sources) == ("yes", 12.0, ("stove-plug",))
    assert answer.confidence >= 0.9


def test_a_stove_that_draws_next_to_nothing_is_off(asked: Asked) -> None:
    asked.says("stove-plug", 12.0, ("power", 0.4))
    assert asked.words("stove", "on") == "No: the stove draws 0.4 W, 12 s ago"


def test_a_sensor_that_has_been_silent_for_two_hours_knows_nothing(asked: Asked) -> None:
    asked.says("stove-plug", 7200.0, ("power", 1420.0))
    answer = asked.house.ask(StateQuestion("stove", "on"))
    assert answer.answer == "unknown" and answer.confidence == 0.0
    assert answer.words == (
        "I do not know: its sensor has been silent for 2 h; then it drew 1 420 W"
    )


def test_a_state_that_the_broker_kept_from_no_known_time_is_no_answer(asked: Asked) -> None:
    asked.says("stove-plug", 3.0, ("power", 1420.0), ("retained", True))
    assert asked.words("stove", "on").startswith("I do not know: its sensor was not heard yet")


def test_between_its_thresholds_a_stove_is_as_it_was_last(asked: Asked) -> None:
    asked.says("stove-plug", 3.0, ("power", 30.0))
    assert asked.words("stove", "on") == (
        "I do not know: the stove draws 30 W, 3 s ago; it is off below 20 W and on from 50 W"
    )
    asked.happens(ON, "stove", 100.0)
    assert asked.words("stove", "on").startswith("Yes: the stove draws 30 W")
    asked.happens(OFF, "stove", 50.0)
    assert asked.words("stove", "on").startswith("No: the stove draws 30 W")
    asked.happens(OFF, "stove", 40.0, ("because", "not known any more"))
    assert asked.words("stove", "on").startswith("I do not know")


def test_power_is_believed_before_the_switch_and_the_contradiction_is_told(asked: Asked) -> None:
    asked.says("a-stove-switch", 5.0, ("on", True))
    assert asked.words("stove", "on") == "Yes: the stove is switched on, 5 s ago"
    asked.says("stove-plug", 12.0, ("power", 0.4))
    answer = asked.house.ask(StateQuestion("stove", "on"))
    assert answer.words == (
        "No: the stove draws 0.4 W, 12 s ago; but a-stove-switch says that it is switched on"
    )
    assert answer.confidence < 0.9
    asked.says("stove-plug", -200.0, ("power", 0.4))
    asked.house.now += 500.0
    asked.says("a-stove-switch", 5.0, ("on", True))
    assert asked.words("stove", "on") == "Yes: the stove is switched on, 5 s ago"


def test_since_when_it_is_on_is_told_by_the_detectors(asked: Asked) -> None:
    asked.says("stove-plug", 12.0, ("power", 1420.0))
    asked.holds((ON, "stove", 600.0, "stove-plug: 1420 W", {}))
    assert asked.words("stove", "on") == "Yes: the stove draws 1 420 W, 12 s ago (on for 10 min)"


def test_an_oven_is_hot_from_its_threshold_and_without_one_nobody_knows(asked: Asked) -> None:
    asked.says("oven-probe", 30.0, ("temperature_c", 182.0))
    assert asked.words("oven", "hot") == "Yes: the oven has a temperature of 182 °C, 30 s ago"
    assert asked.words("oven", "cold") == "No: the oven has a temperature of 182 °C, 30 s ago"
    asked.says("tank", 30.0, ("level_percent", 35.0))
    assert asked.words("tank", "full") == (
        "I do not know: the tank has a level of 35 %, 30 s ago; mqtt.sensors has no above for it"
    )


def test_a_window_is_open_or_closed_and_is_asked_for_with_or_without_article(asked: Asked) -> None:
    asked.says("kitchen-window", 4.0, ("open", True), ("kind", "contact"))
    for name in ("kitchen-window", "kitchen window", "the kitchen window", "Kitchen Window"):
        assert asked.words(name, "open") == "Yes: the kitchen window is open, 4 s ago"
    assert asked.words("kitchen-window", "shut").startswith("No: ")


def test_a_window_whose_contact_is_not_understood_is_neither_open_nor_closed(asked: Asked) -> None:
    asked.says("kitchen-window", 5.0, ("open", True), ("kind", "contact"))
    at, refused = (
        asked.house.now - 3.0,
        (
            ("refused", "contact is 'ajar'; allowed: true"),
            ("refused_key", "contact"),
        ),
    )
    asked.house.memory.add(
        Observation("kitchen-window", "kitchen-window", at, at, valid=False, facts=refused)
    )
    assert asked.words("kitchen window", "open") == (
        "I do not know: its sensor sent a state that is not understood, 3 s ago:"
        " contact is 'ajar'; allowed: true"
    )


def test_a_thing_without_a_sensor_is_not_guessed(asked: Asked) -> None:
    assert asked.words("cup", "on") == (
        "I do not know: no sensor tells whether the red cup is on;"
        " mqtt.sensors in the site file names one (docs/devices.md)"
    )


def test_a_sensor_that_never_spoke_is_named(asked: Asked) -> None:
    assert asked.words("stove", "on") == (
        "I do not know: its sensor was never heard"
        " (stove-plug, a-stove-switch; housefly sensors says why)"
    )
    assert asked.words("stove", "open").startswith("I do not know: no sensor tells whether")


def test_a_sensor_that_says_it_is_offline_is_not_believed_however_fresh(asked: Asked) -> None:
    asked.says("stove-plug", 12.0, ("power", 1420.0))
    gone = SensorHealth("stove-plug", "power", "Power meter", False, is_offline=True)
    asked.house.status.add_health_source(lambda: (gone,))
    answer = asked.house.ask(StateQuestion("stove", "on"))
    assert (answer.answer, answer.confidence) == ("unknown", 0.0)
    assert answer.words == (
        "I do not know: its sensor says that it is offline; it drew 1 420 W, 12 s ago"
    )
    asked.says("a-stove-switch", 5.0, ("on", True))
    assert asked.words("stove", "on") == "Yes: the stove is switched on, 5 s ago"
    assert asked.words("stove", "on", asked.house.now - 1.0).startswith("Yes: the stove draws")


def test_a_device_that_takes_a_things_name_does_not_outvote_the_named_one(asked: Asked) -> None:
    asked.says("stove-plug", 12.0, ("power", 0.4))
    asked.says("stove", 1.0, ("power", 2000.0))
    answer = asked.house.ask(StateQuestion("stove", "on"))
    assert answer.words == (
        "No: the stove draws 0.4 W, 12 s ago; but stove says that it draws 2 000 W"
    )
    assert answer.confidence < 0.9


def test_a_device_asked_by_its_own_name_says_what_its_thing_says(asked: Asked) -> None:
    asked.says("stove-plug", 3.0, ("power", 30.0))
    asked.happens(ON, "stove", 100.0)
    asked.holds((ON, "stove", 100.0, "stove-plug: 30 W", {}))
    asked.house.memory.world.add_thing(Thing("stove-plug", "stove-plug"))
    for name in ("stove", "stove-plug"):
        assert asked.words(name, "on") == f"Yes: the {name} draws 30 W, 3 s ago (on for 100 s)"


def test_a_sensor_that_was_not_heard_by_then_is_told_of_then(asked: Asked) -> None:
    asked.says("stove-plug", 3.0, ("power", 30.0))
    assert asked.words("stove", "on", asked.house.now - 60.0) == (
        "I do not know: its sensor had not been heard by then (stove-plug, a-stove-switch)"
    )


def test_a_state_and_a_thing_that_nobody_knows_are_refused(asked: Asked) -> None:
    with pytest.raises(WireError, match="state is 'boiling'; allowed here: on, running"):
        asked.words("stove", "boiling")
    with pytest.raises(WireError, match="allowed here: lying, sitting"):
        asked.words("resident", "open")
    with pytest.raises(ThingError, match="did you mean 'stove'"):
        asked.words("stov-e", "on")


def test_it_was_on_then(asked: Asked) -> None:
    asked.says("stove-plug", 3600.0, ("power", 1420.0))
    asked.says("stove-plug", 3.0, ("power", 0.4))
    then = asked.house.now - 3590.0
    assert asked.words("stove", "on", then) == "Yes: the stove draws 1 420 W, 10 s ago"
    assert asked.words("stove", "on").startswith("No: ")


def test_somebody_in_bed_is_in_bed_and_not_up(asked: Asked) -> None:
    asked.says("bed", 4.0, ("load", 58.0))
    evidence = "bed: load 58.0 kg; last seen beside bed"
    asked.holds(
        ("person present", "person-1", 3 * 3600.0, evidence, {"on": "bed"}),
        ("person lying", "person-1", 3 * 3600.0, evidence, {"on": "bed"}),
    )
    said = f"the resident lies in bed for 3 h (80 % sure; {evidence}, 4 s ago)"
    assert asked.words("resident", "in bed") == f"Yes: {said}"
    assert asked.words("resident", "up") == f"No: {said}"
    assert asked.words("resident", "home") == f"Yes: {said}"
    (who,) = asked.house.ask(PeopleQuestion("resident")).people
    assert (who.posture, who.activity, who.present, who.fallen) == ("lying", "in bed", "yes", 0.0)
    assert who.words == said


def test_lying_on_the_sofa_and_on_the_floor_and_a_fall_are_told_apart(asked: Asked) -> None:
    asked.says("camera", 0.5)
    lying, fallen = "person lying", "person fallen"
    asked.holds((lying, "person-1", 60.0, "camera: on seat", {"on": "sofa seat 1"}))
    assert "lies on the sofa" in asked.words("resident", "lying")
    assert asked.words("resident", "fallen").startswith("No: ")
    asked.holds((lying, "person-1", 60.0, "camera: head near the floor", {"on": "floor"}))
    assert asked.words("resident", "on the floor").startswith("Yes: the resident lies on the floor")
    assert asked.words("resident", "fallen").startswith("I do not know: the resident lies on the")
    asked.holds(
        (lying, "person-1", 60.0, "camera: head near the floor", {"on": "floor"}),
        (fallen, "person-1", 60.0, "camera: on the floor, head at 0.25 m", {"descent": 0.6}),
    )
    assert asked.words("resident", "fallen") == (
        "Yes: the resident may have fallen and lies on the floor for 60 s"
        " (80 % sure; camera: on the floor, head at 0.25 m, now)"
    )


def test_what_somebody_carries_is_said_only_as_surely_as_it_is_known() -> None:
    world = WorldModel(
        (Thing("ann", "Ann", ThingKind.PERSON), Thing("cup", "the cup", inside="ann"))
    )
    walking = SituationAnswer("person walking", "ann", NOW, 0.9, "floor-1: moves over the floor")
    for confidence, words in ((0.9, "; carries the cup"), (0.3, "")):
        moment = RoomMoment(NOW, world, (walking,), True, lambda thing, sure=confidence: sure)
        who = person_answer(moment, "ann", gone=False)
        assert who.words == f"Ann walks (90 % sure; floor-1: moves over the floor){words}"


def test_who_left_is_away_and_of_whom_nothing_speaks_nobody_knows(asked: Asked) -> None:
    asked.house.see("person-1", 300.0, (3.0, 4.0, 0.0), source="floor-1")
    assert asked.words("resident", "home") == (
        "I do not know: the resident is not seen now, last seen 5 min ago by floor-1"
    )
    asked.happens("person present ended", "person-1", 299.0, ("because", "floor-1: no longer"))
    assert asked.words("resident", "away") == (
        "Yes: the resident is not here, last seen 5 min ago by floor-1"
    )
    asked.happens("person present ended", "person-1", 298.0, ("because", "not known any more"))
    assert asked.words("resident", "away").startswith("I do not know")


def test_how_somebody_was_then_is_read_from_what_began_and_ended(asked: Asked) -> None:
    evidence = ("evidence", "floor-1: on seat")
    asked.says("floor-1", 3601.0)
    asked.happens("person sitting", "person-1", 4000.0, ("on", "sofa seat 1"), evidence)
    asked.happens("person sitting ended", "person-1", 3000.0)
    asked.happens("person walking", "person-1", 3000.0, evidence)
    now = asked.house.now
    at = now - 3600.0
    assert "sits on the sofa" in asked.words("resident", "sitting", at)
    assert "Yes: the resident walks" in asked.words("resident", "up", now - 2900.0)
    asked.happens("memory started", "hub", 2000.0)
    assert asked.words("resident", "up", now - 1900.0).startswith("I do not know")


def test_while_nothing_runs_nothing_is_claimed_of_now(tmp_path: Path, house: Any) -> None:
    house.memory.world.add_thing(Thing("person-1", "Ann", ThingKind.PERSON))
    house.status.set_situations([SituationAnswer("person lying", "person-1", 0.0, 0.9, "bed")])
    answer = house.ask(StateQuestion("Ann", "lying"))
    assert answer.words == "I do not know: Ann was never seen by a sensor"


def test_while_nothing_runs_a_report_of_a_moment_ago_is_no_answer_of_now(house: Any) -> None:
    house.answers = QueryHandler(house.memory, house.status, lambda: house.now, DEVICES)
    house.memory.world.add_thing(Thing("stove", "the stove"))
    at = house.now - 7.0
    house.memory.add(Observation("stove-plug", "stove-plug", at, at, facts=(("power", 1420.0),)))
    answer = house.ask(StateQuestion("stove", "on"))
    assert (answer.answer, answer.confidence, answer.age) == ("unknown", 0.0, 7.0)
    assert answer.words == "I do not know: nothing listens to it now; it drew 1 420 W, 7 s ago"
    assert house.ask(StateQuestion("stove", "on", house.now - 1.0)).answer == "yes"


def test_nights_of_a_bed_a_person_and_of_nobody(asked: Asked) -> None:
    house = asked.house
    asked.happens("bed occupied", "bed", 7000.0)
    asked.happens("bed occupied ended", "bed", 5000.0, ("because", "load 0"))
    asked.happens("bed occupied", "bed", 4700.0)
    (night, *more) = house.ask(NightsQuestion(house.now - 2 * 86_400.0, "", None, 0.0, 24.0)).nights
    nights = [night, *more]
    assert {one.thing for one in nights} == {"bed"}
    assert sum(len(one.times_up) for one in nights) <= 1  # midnight may lie in between
    assert sum(one.in_bed for one in nights) == pytest.approx(6700.0, abs=5.0)
    assert house.ask(NightsQuestion(house.now - 86_400.0, "resident", None, 0.0, 24.0)).nights
    with pytest.raises(ThingError):
        house.ask(NightsQuestion(0.0, "nobody-at-all"))


def test_who_went_to_bed_before_the_night_began_is_in_bed_in_the_night_that_runs(
    asked: Asked,
) -> None:
    house = asked.house
    midnight = datetime.fromtimestamp(house.now).replace(hour=0, minute=0, second=0)
    house.now = midnight.timestamp() + 1133.0
    asked.happens("bed occupied", "bed", 4700.0)
    nights = house.ask(NightsQuestion(house.now - 86_400.0, "", None, 0.0, 24.0)).nights
    assert [one.in_bed for one in nights] == [pytest.approx(1133.0)]


def test_of_whom_no_bed_spoke_nobody_knows_whether_they_were_in_one(asked: Asked) -> None:
    asked.happens("bell pressed", "doorbell", 7000.0)
    for thing in ("resident", "cup"):
        question = NightsQuestion(asked.house.now - 2 * 86_400.0, thing, None, 0.0, 24.0)
        nights = asked.house.ask(question).nights
        assert nights and all(one.unknown == one.end - one.begin for one in nights)
        assert not any("nobody was in bed" in one.words for one in nights)
