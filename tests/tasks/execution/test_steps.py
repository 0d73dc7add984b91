"""Single steps on a scripted pilot and room: moving subjects, compositions, memory, panoramas."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from math import atan2, pi
from typing import Any

import pytest
from scripted_pilot import UNIX_BEGIN, Flight, ScriptedPilot, ScriptedRoom, view

from housefly.errors import LinkError
from housefly.evidence.clip_values import StartClip, TakeSnapshot
from housefly.geometry import Vec2, distance, wrap_angle
from housefly.hub.api.answers import (
    AlternativePlace,
    EventAnswer,
    EventsAnswer,
    PictureAnswer,
    PlacedAnswer,
    PlacedThing,
    ThingAnswer,
    ThingsAnswer,
    WhereAnswer,
)
from housefly.hub.api.questions import PictureQuestion, Question
from housefly.hub.api.state_answers import (
    NightAnswer,
    NightsAnswer,
    PeopleAnswer,
    PersonAnswer,
    StateAnswer,
    TimeUp,
)
from housefly.messages import OrderKind
from housefly.tasks.api.values import ReasonCode, TaskStage, TaskStepState
from housefly.tasks.document.binding import bind
from housefly.tasks.document.document_parser import read_task
from housefly.tasks.document.library import load_library
from housefly.tasks.execution.flight_steps import REGO_DISTANCE, REGO_PERIOD
from housefly.tasks.execution.task_room import SeenPerson
from housefly.tasks.execution.task_run import TaskRun
from housefly.tasks.execution.values import PersonReply, PublishMqtt, Report, Say
from housefly.tasks.vantage.viewpoint import Viewpoint

LIBRARY = load_library()
WHERE = WhereAnswer(
    *("cup", "the cup", "object", "the cup: in the cabinet", (1.0, 1.0, 1.0)),
    *(None, 0.1, (), "", UNIX_BEGIN, 10.0, (), ()),
)
PERSON = PersonAnswer(
    *("p1", "the resident", "the resident sits on the sofa", "yes", "sitting", "on sofa"),
    *(0.0, (), None, 0.9, (1.0, 1.0, 0.0), 1.0, ""),
)


def room(**answers: Any) -> ScriptedRoom:
    views = [view("fridge", 2.0, 1.0), view("tv", -1.0, 2.0), view("entrance", 3.0, 0.0)]
    return ScriptedRoom({each.subject: each for each in views}, (), answers.pop("answers", {}))


def flight(steps: str, known: ScriptedRoom | None = None) -> Flight:
    bound = bind(read_task(f"name: t\nsteps:\n{steps}\n"), {})
    return Flight(TaskRun(bound, known or room()), ScriptedPilot())


def service(name: str, known: ScriptedRoom, **given: str | float | bool) -> Flight:
    return Flight(TaskRun(bind(LIBRARY[name], given), known), ScriptedPilot())


def said(flown: Flight) -> list[str]:
    return [action.words for action in flown.of(Say)]


def reported(flown: Flight) -> list[str]:
    return [action.words for action in flown.of(Report)]


class WalkingRoom(ScriptedRoom):
    """Somebody walks along y; the viewpoint keeps 2 m from them."""

    speed = 0.4
    clock: ScriptedPilot
    gone_at = 1e9

    def place(self) -> tuple[float, float, float]:
        return (4.0, self.speed * (self.clock.now - 10.0), 0.0)

    def sees(self, place: Vec2) -> bool:
        return False

    def view_from(self, subject: str, place: Vec2) -> Viewpoint | None:
        x, y, z = self.place()
        return Viewpoint("p1", place, (x, y, z + 1.4), 2.0, "") if self.sees(place) else None

    def people(self) -> tuple[SeenPerson, ...]:
        if self.clock.now > self.gone_at:
            return ()
        return (SeenPerson("p1", self.place(), (0.0, self.speed), 0.0),)

    def viewpoint(self, subject: str, drone: Any = None) -> Viewpoint:
        if self.clock.now > self.gone_at:
            return super().viewpoint("nobody")
        assert subject == "p1"
        x, y, z = self.place()
        return Viewpoint("p1", (x - 2.0, y), (x, y, z + 1.4), 2.0, "")


def walking(steps: str) -> tuple[Flight, WalkingRoom]:
    known = WalkingRoom()
    flown = flight(steps, known)
    known.clock = flown.pilot
    return flown, known


@pytest.mark.parametrize("speed", [0.4, 1.2])
def test_a_person_who_walks_is_flown_after_at_most_once_a_second(speed: float) -> None:
    flown, known = walking("  - follow: {person: anybody, time: 20 s}")
    known.speed = speed
    flown.fly()
    goals = [order for order in flown.orders if order.kind is OrderKind.GO]
    assert flown.run.stage is TaskStage.DONE
    assert len(goals) > 5
    for before, after in pairwise(goals):
        assert after.issued_at - before.issued_at >= REGO_PERIOD - 0.01
        assert before.goal and after.goal and distance(before.goal, after.goal) > REGO_DISTANCE
    assert all(order.goal and order.goal[0] <= 2.01 for order in goals)


def test_a_person_who_stands_is_not_flown_after() -> None:
    flown, known = walking("  - follow: {person: p1, time: 20 s}")
    known.speed = 0.0
    assert flown.fly().kinds == ["go", "home"]


def test_a_person_who_is_lost_is_not_followed_for_ever() -> None:
    flown, known = walking("  - follow: {person: p1, time: 100 s, lost_after: 5 s}")
    known.gone_at = 20.0
    flown.fly()
    assert (flown.run.stage, flown.run.code) == (TaskStage.FAILED, ReasonCode.UNKNOWN_THING)
    assert flown.stands_on_pad()


def assert_turns_only(flown: Flight, since: int) -> None:
    """Assert that the drone was ordered nowhere else, and then home."""
    *turns, last = flown.orders[since:]
    assert last.kind is OrderKind.HOME and turns
    stood = turns[0].goal
    assert stood is not None
    assert all(order.goal and distance(order.goal, stood) < 0.1 for order in turns)


def test_who_is_seen_from_where_the_drone_hovers_is_turned_to_and_not_flown_after() -> None:
    flown, known = walking("  - follow: {person: p1, time: 20 s}")
    known.sees = lambda place: abs(place[1] - known.place()[1]) < 3.0  # type: ignore[method-assign]
    flown.fly()
    assert flown.run.stage is TaskStage.DONE
    goals = [order.goal for order in flown.orders if order.kind is OrderKind.GO]
    looks = [order.look_at for order in flown.orders if order.kind is OrderKind.GO]
    places = [goal for n, goal in enumerate(goals) if n == 0 or goal != goals[n - 1]]
    assert 2 <= len(places) <= 4 < len(set(looks))


def test_who_stands_beside_the_drone_is_left_to_the_pilot() -> None:
    flown, known = walking("  - follow: {person: p1, time: 20 s}")
    while flown.pilot.now < 20.0:
        flown.tick()
    before = len(flown.orders)
    x, y, _ = flown.pilot.position
    known.place = lambda: (x + 1.0, y, 0.0)  # type: ignore[method-assign]
    flown.fly()
    assert [order.kind for order in flown.orders[before:]] == [OrderKind.HOME]


def test_no_goal_is_nearer_to_anybody_than_the_comfort_distance() -> None:
    flown, known = walking("  - follow: {person: p1, time: 15 s}")
    near = lambda subject, drone=None: Viewpoint("p1", known.place()[:2], known.place(), 0.1, "")  # noqa: E731
    for _ in range(60):
        flown.tick()
    before = len(flown.orders)
    known.viewpoint = near  # type: ignore[method-assign]
    flown.fly()
    assert_turns_only(flown, before)


def test_a_subject_that_moves_on_the_way_is_flown_after() -> None:
    flown, _ = walking("  - look_at: p1")
    flown.fly()
    assert flown.run.stage is TaskStage.DONE
    assert flown.kinds.count("go") > 1


def test_the_visitor_is_faced_and_not_the_door() -> None:
    known = room()
    known.seen = (SeenPerson("p9", (5.5, 0.5, 0.0), (0.0, 0.0), 0.1),)
    known.views["p9"] = view("p9", 3.5, 0.5)
    flown = service("visitor", known).fly()
    assert flown.run.stage is TaskStage.DONE
    assert flown.orders[0].goal == (3.5, 0.5)
    assert said(flown) == ["At the entrance: p9"]
    assert flown.of(StartClip) == [StartClip(5.0, "entrance", "", ("p9",))]
    assert flown.stands_on_pad()


def test_without_a_visitor_the_door_is_looked_at_and_that_is_said() -> None:
    flown = service("visitor", room()).fly()
    assert flown.orders[0].goal == (3.0, 0.0)
    assert said(flown) == ["At the entrance nobody is seen"]
    assert reported(flown) == ["At the entrance nobody was seen"]


def test_the_visitor_is_hovered_at_until_told_to_come_home() -> None:
    flown = service("visitor", room(), stay=100.0)
    while flown.run.steps[-2].state is not TaskStepState.RUNNING:
        flown.tick()
    for _ in range(500):
        flown.tick()
    assert "home" not in flown.kinds
    flown.tick(replies=(PersonReply("reply", "come home", "Anna"),))
    assert flown.fly().run.stage is TaskStage.DONE


def test_a_panorama_turns_all_around_on_the_spot() -> None:
    flown = flight("  - go_to: fridge\n  - sweep: {views: 6, subject: fridge}").fly()
    turns = [order for order in flown.orders if order.kind is OrderKind.GO][1:]
    assert len(turns) == len(flown.of(TakeSnapshot)) == 6
    yaws = []
    for order in turns:
        assert order.goal == pytest.approx((2.0, 1.0)) and order.look_at
        yaws.append((order.look_at[0] - 2.0, order.look_at[1] - 1.0))
    headings = [atan2(y, x) for x, y in yaws]
    steps = [abs(wrap_angle(b - a)) for a, b in pairwise(headings)]
    assert steps == pytest.approx([pi / 3.0] * 5)


def test_a_panorama_on_the_ground_is_refused() -> None:
    flown = flight("  - sweep").fly()
    assert flown.run.code is ReasonCode.STEP_FAILED
    assert flown.orders == []


@pytest.mark.parametrize(
    ("steps", "words"),
    [
        ("  - sequence: [{say: a}, {say: b}]", ["a", "b"]),
        ("  - parallel:\n    - [{wait: 1 s}, {say: late}]\n    - say: early", ["early", "late"]),
        ("  - first_of: [{fail: x}, {say: b}, {say: c}]", ["b"]),
        ("  - retry: 3\n    do: [{say: try}, {fail: x}]\n    may_fail: true", ["try"] * 3),
        ("  - repeat: 2\n    do: [say: again]", ["again"] * 2),
        ("  - timeout: 1 s\n    do: [{say: a}, {wait: 9 s}, {say: b}]\n    otherwise: [say: c]",
         ["a", "c"]),
        ("  - timeout: 9 s\n    do: [say: a]\n    otherwise: [say: c]", ["a"]),
        ("  - say: a\n    may_fail: true\n  - fail: x\n    may_fail: true\n  - say: b", ["a", "b"]),
        ("  - if: {any: [{set: reply}, {not: {set: reply}}]}\n    then: [say: yes]\n"
         "    else: [{ask: a}]", ["yes"]),
        ("  - for_each: [x, y]\n    do: [say: $each]", ["x", "y"]),
        ("  - say: costs 5 $$", ["costs 5 $"]),
    ],
)  # fmt: skip
def test_steps_are_composed(steps: str, words: list[str]) -> None:
    flown = flight(steps).fly()
    assert said(flown) == words
    assert flown.run.stage is TaskStage.DONE


@pytest.mark.parametrize(
    ("steps", "code", "words"),
    [
        ("  - fail: no milk", ReasonCode.STEP_FAILED, "no milk"),
        ("  - timeout: 1 s\n    do: [wait: 5 s]\n    name: milk", ReasonCode.TIMEOUT, "milk took"),
        ("  - retry: 2\n    do: [fail: sour]", ReasonCode.STEP_FAILED, "sour"),
        ("  - parallel: [{wait: 5 s}, {fail: sour}]", ReasonCode.STEP_FAILED, "sour"),
        ("  - find: milk", ReasonCode.STEP_FAILED, "there is no milk"),
        ("  - look_at: milk", ReasonCode.UNKNOWN_THING, "there is no milk"),
    ],
)
def test_a_failure_says_why(steps: str, code: ReasonCode, words: str) -> None:
    flown = flight(steps).fly()
    assert (flown.run.stage, flown.run.code) == (TaskStage.FAILED, code)
    assert words in flown.run.words


@pytest.mark.parametrize(
    ("answer", "asked", "expected"),
    [("yes", "yes", "so"), ("no", "yes", "not so"), ("unknown", "yes", "not so"),
     ("unknown", "unknown", "so"), ("no", "no", "so"), (None, "unknown", "so")],
)  # fmt: skip
def test_the_state_of_a_thing_is_yes_no_or_unknown(
    answer: str | None, asked: str, expected: str
) -> None:
    known = room()
    if answer:
        state = StateAnswer("f", "f", "open", answer, "", 1.0, 0.0, None, ())  # type: ignore[arg-type]
        known.answers["is", "f open"] = state
    steps = (
        f"  - if: {{is: {{thing: f, state: open, answer: {asked}}}}}\n"
        "    then: [say: so]\n    else: [say: not so]"
    )
    assert said(flight(steps, known).fly()) == [expected]


def test_something_is_waited_for_no_longer_than_it_takes() -> None:
    known = room()
    flown = flight("  - wait: {time: 60 s, until: {is: {thing: f, state: open}}}", known)
    for _ in range(50):
        flown.tick()
    questions = len(known.asked)
    assert questions <= 6
    known.answers["is", "f open"] = StateAnswer("f", "f", "open", "yes", "", 1.0, 0.0, None, ())
    for _ in range(12):
        flown.tick()
    assert flown.run.is_over


def test_announcing_publishes_and_a_device_gets_its_payload() -> None:
    flown = flight(
        "  - announce: Tea\n  - publish: {topic: lamp/set, payload: '{\"on\": 1}'}"
    ).fly()
    assert flown.of(PublishMqtt) == [
        PublishMqtt("housefly/announce", "Tea"),
        PublishMqtt("lamp/set", '{"on": 1}'),
    ]


def test_where_is_answered_without_a_flight_while_the_memory_is_fresh() -> None:
    known = room(answers={("where", "cup"): WHERE})
    known.views["cup"] = view("cup", 1.0, 1.0)
    flown = service("where", known, thing="cup").fly()
    assert said(flown) == ["The cup: in the cabinet"]
    assert flown.orders == []


@pytest.mark.parametrize("change", [{"age": 900.0}, {"confidence": 0.4}])
def test_where_flies_when_the_memory_is_old_or_unsure(change: dict[str, float]) -> None:
    known = room(answers={("where", "cup"): replace(WHERE, **change)})  # type: ignore[arg-type]
    known.views["cup"] = view("cup", 1.0, 1.0)
    assert service("where", known, thing="cup").fly().kinds == ["go", "home"]
    assert service("where", known, thing="cup", look="never").fly().kinds == []


def test_a_thing_that_is_not_there_is_looked_for_at_the_next_best_place() -> None:
    other = AlternativePlace("left on the sofa table", "tv", (1.0, 1.0, 1.0), 0.3)
    known = room(answers={("where", "cup"): replace(WHERE, alternatives=(other,))})
    known.views["cup"] = view("cup", 1.0, 1.0)
    flown = service("look", known, subject="cup")
    while not any(step.name == "ask" and step.state is TaskStepState.RUNNING
                  for step in flown.run.steps):  # fmt: skip
        flown.tick()
    flown.tick(replies=(PersonReply("here", "no", "Anna"),))
    flown.fly()
    assert [order.goal for order in flown.orders[:2]] == [(1.0, 1.0), (-1.0, 2.0)]
    assert reported(flown) == ["cup is not where the memory has it; this is the next best place"]
    assert flown.stands_on_pad()


def test_a_patrol_looks_at_every_place_the_nearest_first_and_goes_on_without_one() -> None:
    things = [
        ThingAnswer(f"place-{name}", name, "place", (), place, "", ())
        for name, place in (
            ("home", (0.0, 0.0, 0.0)),
            ("far", (9.0, 0.0, 0.0)),
            ("near", (1.0, 0.0, 0.0)),
            ("hidden", (2.0, 0.0, 0.0)),
        )
    ]
    known = room(answers={("catalogue", ""): ThingsAnswer(tuple(things))})
    known.views |= {"place-far": view("far", 4.0, 0.0), "place-near": view("near", 1.0, 0.0)}
    flown = service("patrol", known, dwell=1.0).fly()
    assert flown.run.stage is TaskStage.DONE
    assert [order.goal for order in flown.orders] == [(1.0, 0.0), (4.0, 0.0), None]
    assert reported(flown) == [
        "hidden could not be looked at", "The pictures show 20 % of the floor that can be seen",
    ]  # fmt: skip
    assert len(flown.of(TakeSnapshot)) == 2


@pytest.mark.parametrize("has_memory", [True, False])
def test_a_patrol_without_named_places_goes_round_the_floor(has_memory: bool) -> None:
    home = ThingAnswer("place-home", "home", "place", (), (0.0, 0.0, 0.0), "", ())
    answers = {("catalogue", ""): ThingsAnswer((home,))} if has_memory else {}
    known = room(answers=answers) if has_memory else Amnesia()
    known.views = {f"floor {n}": view(f"floor {n}", 1.0 * n, 0.0) for n in (1, 2)}
    flown = service("patrol", known, dwell=1.0).fly()
    assert flown.run.stage is TaskStage.DONE
    assert [order.goal for order in flown.orders] == [(1.0, 0.0), (2.0, 0.0), None]
    assert len(flown.of(TakeSnapshot)) == 2


def test_a_patrol_of_the_whole_floor_looks_at_all_of_its_parts() -> None:
    known = room()
    known.views |= {f"whole floor {n}": view(f"whole floor {n}", 1.0 * n, 0.0) for n in (1, 2, 3)}
    flown = service("patrol", known, dwell=1.0, places="whole floor").fly()
    assert flown.run.stage is TaskStage.DONE
    assert [order.goal for order in flown.orders] == [(1.0, 0.0), (2.0, 0.0), (3.0, 0.0), None]
    assert reported(flown) == ["The pictures show 30 % of the floor that can be seen"]


class Amnesia(ScriptedRoom):
    """Nobody remembers anything."""

    def ask(self, question: Question) -> Any:
        raise LinkError("the room's memory does not answer")


class ComparingRoom(ScriptedRoom):
    """A picture of the room then and now."""

    def ask(self, question: Question) -> Any:
        if isinstance(question, PictureQuestion):
            self.asked.append(question)
            return self.answers["picture", "now" if question.at is None else "then"]
        return super().ask(question)


def test_what_changed_since_the_last_round_is_told() -> None:
    def thing(name: str, x: float, inside: str = "", kind: str = "object") -> PlacedThing:
        return PlacedThing(name, f"the {name}", kind, (x, 0.0, 0.0), None, inside, 1.0)

    def event(at: float, name: str) -> EventAnswer:
        return EventAnswer("task ended", "drone", at, "tasks", "", 1.0, {"service": name})

    then = (
        thing("cup", 1.0),
        thing("book", 1.0),
        thing("key", 1.0, "cabinet"),
        thing("p", 0.0, "", "person"),
    )
    now = (
        thing("cup", 1.2),
        thing("book", 3.0),
        thing("key", 1.0),
        thing("p", 5.0, "", "person"),
        thing("hat", 1.0),
    )
    known = ComparingRoom(
        answers={
            ("picture", "then"): PictureAnswer(0.0, then),
            ("picture", "now"): PictureAnswer(0.0, now),
            ("events", ""): EventsAnswer((event(UNIX_BEGIN - 50.0, "t"), event(UNIX_BEGIN, "x"))),
        }
    )
    flown = flight("  - changes", known).fly()
    assert reported(flown) == [
        "The book moved by 2.0 m",
        "The key was taken out of cabinet",
        "The hat is new here",
    ]
    asked = [each.at for each in known.asked if isinstance(each, PictureQuestion)]
    assert asked == [UNIX_BEGIN - 50.0, None]


def test_an_inventory_lists_what_is_inside_and_takes_a_picture() -> None:
    inside = PlacedAnswer((PlacedThing("milk", "the milk", "object", None, None, "fridge", 1.0),))
    known = room(answers={("contents", "fridge"): inside})
    flown = service("inventory", known, subject="fridge").fly()
    assert reported(flown) == ["In fridge: the milk, as far as the room knows"]
    assert len(flown.of(TakeSnapshot)) == 1
    empty = room(answers={("contents", "fridge"): PlacedAnswer(())})
    assert reported(service("inventory", empty, subject="fridge").fly())[0].startswith("Nothing is")


def people(*those: PersonAnswer) -> PeopleAnswer:
    return PeopleAnswer(UNIX_BEGIN, those)


def test_when_everybody_is_well_nothing_flies() -> None:
    flown = service("all_right", room(answers={("people", ""): people(PERSON)})).fly()
    assert flown.run.stage is TaskStage.DONE
    assert flown.orders == []
    assert reported(flown) == ["The resident sits on the sofa", "Nobody seems to need help"]


def test_nobody_is_said_to_be_well_of_whom_nobody_knows_how_they_are() -> None:
    unknown = {
        "words": "Ann is not seen now", "name": "Ann", "person": "p2", "present": "unknown",
        "posture": "", "activity": "", "confidence": 0.0,
    }  # fmt: skip
    known = room(answers={("people", ""): people(PERSON, replace(PERSON, **unknown))})  # type: ignore[arg-type]
    flown = service("all_right", known).fly()
    assert said(flown) == ["Nobody is known to need help, but nobody knows how Ann is"]
    assert "Nobody seems to need help" not in reported(flown)
    # Who is out of the house, or only known to be here, or no guest at all, leaves no doubt.
    for change in (
        {"present": "no"}, {"present": "yes", "confidence": 0.7}, {"person": "visitor"},
    ):  # fmt: skip
        other = replace(PERSON, **{**unknown, **change})  # type: ignore[arg-type]
        known = room(answers={("people", ""): people(PERSON, other)})
        assert said(service("all_right", known).fly()) == ["Nobody seems to need help"]


@pytest.mark.parametrize(
    "change", [{"fallen": 0.85}, {"posture": "lying", "activity": "on the floor"}]
)
@pytest.mark.parametrize("reply", ["yes", "no", ""])
def test_who_may_have_fallen_is_looked_at_and_a_person_judges(
    change: dict[str, Any], reply: str
) -> None:
    known = room(
        answers={
            ("people", ""): people(PERSON, replace(PERSON, person="p2", name="the guest", **change))
        }
    )
    known.answers["where", "p2"] = replace(WHERE, thing="p2", name="the guest", kind="person")
    known.views["p2"] = view("p2", 2.0, 0.0)
    flown = service("all_right", known)
    for _ in range(120):
        flown.tick()
    if reply:
        flown.tick(replies=(PersonReply("well", reply, "Anna"),))
    flown.fly()
    assert said(flown)[0] == "the guest may have fallen: going to look"
    assert flown.of(StartClip)[0].people == ("p2",)
    assert flown.stands_on_pad()
    wanted = "is well" if reply == "yes" else "Nobody says that the guest is well"
    assert wanted in reported(flown)[-1]
    assert ("Please look after the guest now" in said(flown)) is (reply != "yes")


def test_who_left_the_bed_at_night_and_is_not_seen_is_looked_for_everywhere() -> None:
    night = NightAnswer(
        "p1", UNIX_BEGIN - 3600.0, UNIX_BEGIN + 3600.0, (TimeUp(UNIX_BEGIN - 1800.0, None),),
        None, 0.0, 0.0, "",
    )  # fmt: skip
    away = replace(PERSON, present="unknown", posture="", activity="")
    place = ThingAnswer("place-tv", "tv", "place", (), (1.0, 0.0, 0.0), "", ())
    known = room(answers={("people", ""): people(away), ("nights", ""): NightsAnswer((night,)),
                          ("catalogue", ""): ThingsAnswer((place,))})  # fmt: skip
    known.views["place-tv"] = view("tv", 1.0, 0.0)
    flown = service("all_right", known).fly()
    assert "the resident left the bed and is not seen: looking everywhere" in said(flown)
    assert flown.kinds == ["go", "home"]
    # Who was up only a moment, or is seen, is not missing.
    for change in ({"present": "yes"}, {}):
        known.answers["people", ""] = people(replace(away, **change))  # type: ignore[arg-type]
        if not change:
            lately = replace(night, times_up=(TimeUp(UNIX_BEGIN - 100.0, None),))
            known.answers["nights", ""] = NightsAnswer((lately,))
        assert service("all_right", known).fly().orders == []


def test_a_night_round_tells_that_the_stove_is_on_and_makes_its_round() -> None:
    state = StateAnswer("stove", "stove", "on", "yes", "", 1.0, 0.0, None, ())
    known = room(answers={("is", "stove on"): state, ("people", ""): people(PERSON)})
    flown = service("night_round", known, places="fridge, tv").fly()
    assert flown.run.stage is TaskStage.DONE
    assert said(flown) == ["The stove is still on"]
    assert [order.goal for order in flown.orders[:2]] == [(2.0, 1.0), (-1.0, 2.0)]


@pytest.mark.parametrize("place", ["", "fridge"])
def test_looking_around_starts_above_the_pad_or_at_a_place(place: str) -> None:
    given = {"place": place} if place else {}
    flown = service("panorama", room(), views=4.0, **given).fly()
    assert flown.run.stage is TaskStage.DONE
    assert len(flown.of(TakeSnapshot)) == 4
    assert flown.kinds[0] == ("go" if place else "take_off")


def test_coming_faces_the_nearest_person_and_goes_home_when_told() -> None:
    flown, known = walking("  - wait: 0 s")
    known.speed = 0.0
    flown = service("come", known)
    known.clock = flown.pilot
    while not said(flown):
        flown.tick()
    assert said(flown) == ["Here I am"]
    flown.tick(replies=(PersonReply("reply", "go home", "Anna"),))
    assert flown.fly().stands_on_pad()


def test_following_somebody_who_is_lost_ends_well_at_home() -> None:
    known = WalkingRoom()
    flown = service("follow", known)
    known.clock, known.gone_at = flown.pilot, 25.0
    flown.fly()
    assert flown.run.stage is TaskStage.DONE
    assert reported(flown) == ["Lost sight of them: coming home"]
    assert flown.stands_on_pad()


class ForgetfulRoom(WalkingRoom):
    """Nobody sees the person any more; the memory has them where they were last."""

    back_at = 1e9

    @property
    def is_gone(self) -> bool:
        return self.gone_at < self.clock.now < self.back_at

    def place(self) -> tuple[float, float, float]:
        now = self.gone_at if self.is_gone else self.clock.now
        return (4.0, self.speed * (now - 10.0), 0.0)

    def people(self) -> tuple[SeenPerson, ...]:
        seen = SeenPerson("p1", self.place(), (0.0, self.speed), 0.0)
        return () if self.is_gone else (seen,)

    def ask(self, question: Question) -> Any:
        if getattr(question, "thing", "") != "p1" or question.ask != "where":
            return super().ask(question)
        age = self.clock.now - self.gone_at if self.is_gone else 0.0
        return replace(WHERE, thing="p1", name="Anna", kind="person", age=age, confidence=0.9)

    def viewpoint(self, subject: str, drone: Any = None) -> Viewpoint:
        x, y, z = self.place()
        return Viewpoint("p1", (x - 2.0, y), (x, y, z + 1.4), 2.0, "")


def forgetful(name: str, gone_at: float = 25.0, **given: str | float) -> Flight:
    known = ForgetfulRoom()
    flown = service(name, known, **given)
    known.clock, known.gone_at = flown.pilot, gone_at
    return flown


def test_a_stale_place_is_not_followed() -> None:
    """The memory keeps the old place for ever: the age tells that nobody is seen there."""
    flown = forgetful("follow", person="p1", time=200.0).fly()
    after = [order for order in flown.orders if order.issued_at > 25.0]
    assert [order.kind for order in after] == [OrderKind.HOVER, OrderKind.GO, OrderKind.HOME]
    assert 28.0 < after[0].issued_at < 30.0
    assert 35.0 < after[1].issued_at < 37.0
    assert 45.0 < after[2].issued_at < 48.0
    last = 0.4 * (25.0 - 10.0)
    assert after[1].goal == pytest.approx((2.0, last), abs=0.7)
    assert said(flown)[0].startswith("Anna was not seen for")
    assert said(flown)[1:] == [
        "Anna is lost: looking where they were last",
        "Lost sight of them: coming home",
    ]
    assert flown.stands_on_pad()


@pytest.mark.parametrize("lost_for", [6.0, 14.0])
def test_who_is_seen_again_is_followed_again(lost_for: float) -> None:
    flown = forgetful("follow", person="p1", time=40.0)
    known = flown.run._context.room
    assert isinstance(known, ForgetfulRoom)
    known.back_at = 25.0 + lost_for
    flown.fly()
    assert flown.run.stage is TaskStage.DONE
    assert "Anna is seen again" in said(flown) and reported(flown) == []
    goals = [o.goal for o in flown.orders if o.kind is OrderKind.GO and o.issued_at > known.back_at]
    assert len(goals) > 3


def test_who_is_seen_again_beside_the_goal_is_not_flown_to() -> None:
    flown = forgetful("follow", person="p1", time=40.0)
    known = flown.run._context.room
    assert isinstance(known, ForgetfulRoom)
    known.back_at = 31.0
    while flown.pilot.now < 30.5:
        flown.tick()
    before = len(flown.orders)
    near = lambda subject, drone=None: Viewpoint("p1", known.place()[:2], known.place(), 0.1, "")  # noqa: E731
    known.viewpoint = near  # type: ignore[method-assign]
    flown.fly()
    assert_turns_only(flown, before)


def test_coming_to_somebody_who_is_not_there_any_more_is_said() -> None:
    flown = forgetful("come", gone_at=-15.0, person="p1")
    flown.fly()
    assert said(flown) == [
        "I do not see p1 here, where they were last", "p1 was not seen: going home",
    ]  # fmt: skip
    assert flown.run.stage is TaskStage.DONE and flown.stands_on_pad()


def test_coming_to_somebody_who_shows_up_is_as_ever() -> None:
    flown = forgetful("come", gone_at=-15.0, person="p1")
    known = flown.run._context.room
    assert isinstance(known, ForgetfulRoom)
    while not said(flown):
        flown.tick()
    known.speed, known.back_at = 0.0, flown.pilot.now + 2.0
    flown.fly()
    assert "Here I am" in said(flown)
