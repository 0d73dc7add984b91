"""What is typed becomes the site; wrong answers are told, and nothing is lost."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from math import cos, pi, sin
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from housefly.app.new_site.answers import answered
from housefly.app.new_site.asker import DefaultsAsker, OutOfAnswers
from housefly.app.new_site.dialog import LeftDialog, NewSiteDialog, Wires
from housefly.errors import ConfigError, HouseflyError
from housefly.messages.words import Words
from housefly.room.draft.files import load_draft
from housefly.room.draft.missing import DraftStep, missing
from housefly.room.draft.model import DraftDrone, DraftTracking, SiteDraft, with_size
from housefly.tracking.live_check import Heard, HeardBody


class TypedLines:
    """Somebody who types lines and reads everything."""

    def __init__(self, lines: Iterable[str], *, is_patient: bool = True) -> None:
        self.is_patient = is_patient
        self.shown: list[str] = []
        self._lines = iter(lines)

    def ask(self, words: str, default: str) -> str:
        self.shown.append(f"{words} [{default}]")
        try:
            return next(self._lines)
        except StopIteration:
            raise OutOfAnswers("the answers ended") from None

    def tell(self, words: str) -> None:
        self.shown.append(words)

    @property
    def text(self) -> str:
        return "\n".join(self.shown)


def dialog(
    folder: Path, *lines: str, draft: SiteDraft | None = None, **options: object
) -> tuple[NewSiteDialog, TypedLines]:
    typed = TypedLines(lines)
    return NewSiteDialog(draft or SiteDraft("lab"), folder, typed, **options), typed  # type: ignore[arg-type]


def heard_at(places: Iterable[tuple[float, float]]) -> Callable[[DraftTracking, float], Heard]:
    """Return a tracking system that sees the drone at these places, one after the other."""
    spots = iter(places)

    def hear(tracking: DraftTracking, seconds: float) -> Heard:
        x, y = next(spots)
        body = HeardBody(tracking.body, (x, y, 0.05), 0.0, 100.0, 0.0005)
        return Heard("10.0.0.5:801", 100.0, (body,), "")

    return hear


def test_a_size_and_enter_are_a_whole_site(tmp_path: Path) -> None:
    asks, typed = dialog(tmp_path, "6x4", "", "", "", "", "", "")
    draft = asks.run()
    assert missing(draft) == ()
    assert draft.bounds == (0.0, 0.0, 6.0, 4.0)
    assert not draft.hardware
    assert draft.drone == DraftDrone()
    assert "asking the drone" not in typed.text
    assert load_draft(tmp_path) == draft


def test_everything_that_is_typed_is_in_the_site(tmp_path: Path) -> None:
    asks, _ = dialog(
        tmp_path,
        *("6 x 4 x 3", "Dining Table 3,1 1.2x.8x.75 turn=90deg", "lamp 5,3 .4x.4x.3 from=1.6"),
        *("wall 2,0 2,0.8", ""),
        *("1.2,2 90deg", "kitchen 5,2", "door 1,3 look=0,3,1", "", "0,0,.5,.5 the door swings", ""),
        *("natnet 10.0.0.5:1500 cf1 up=z", "", "192.168.1.7"),
    )
    draft = asks.run()
    assert draft.height == 3.0
    table, lamp = draft.furniture
    assert (table.name, table.top) == ("Dining Table", 0.75)
    assert table.yaw == pytest.approx(pi / 2, abs=1e-4)
    assert (lamp.bottom, lamp.top) == (1.6, 1.9)
    assert len(draft.walls) == 5
    assert draft.pad == (1.2, 2.0)
    assert [place.name for place in draft.places] == ["kitchen", "door"]
    assert draft.places[1].look_at == (0.0, 3.0, 1.0)
    assert draft.zones[0].reason == "the door swings"
    assert draft.tracking == DraftTracking("natnet", "10.0.0.5", 1500, "cf1", up_axis="z")
    assert draft.drone is not None and draft.drone.address == "192.168.1.7"


@pytest.mark.parametrize(
    ("text", "drone"),
    [
        ("crazyflie", DraftDrone(model="crazyflie")),
        ("tello", DraftDrone("192.168.10.1", model="tello")),
        ("crazyflie 10.0.0.2", DraftDrone("10.0.0.2", model="crazyflie")),
        ("crazyflie://10.0.0.2", DraftDrone("10.0.0.2", model="crazyflie")),
        ("10.0.0.2", DraftDrone("10.0.0.2")),
        ("drone.local", DraftDrone("drone.local")),
    ],
)
def test_a_drone_is_a_model_an_address_or_both(text: str, drone: DraftDrone) -> None:
    assert answered(SiteDraft(), DraftStep.DRONE, text, Path())[0].drone == drone


def test_the_profile_of_another_model_is_left_behind(tmp_path: Path) -> None:
    draft = SiteDraft(drone=DraftDrone("10.0.0.2", "mine.toml", "crazyflie"))
    other, _ = answered(draft, DraftStep.DRONE, "tello", tmp_path)
    assert other.drone == DraftDrone("192.168.10.1", "", "tello")


@pytest.mark.parametrize("text", ["two words", "crazyflie 10.0.0.2 twice", "drohne"])
def test_what_is_no_drone_is_refused(text: str) -> None:
    with pytest.raises(ConfigError, match="drone"):
        answered(SiteDraft(), DraftStep.DRONE, text, Path())


@pytest.mark.parametrize(
    ("text", "body"),
    [
        ("natnet 10.0.0.5 Rigid Body 1", "Rigid Body 1"),  # Motive's own name for a new body
        ("natnet 10.0.0.5:1500  Rigid  Body  up=z", "Rigid  Body"),
        ('vicon 10.0.0.5 "my drone"', "my drone"),
        ("vicon 10.0.0.5 'a drone'", "a drone"),
        ("vicon 10.0.0.5", "ardrone"),
    ],
)
def test_a_body_may_have_any_name(text: str, body: str) -> None:
    changed, _ = answered(with_size(SiteDraft("lab"), 6.0, 4.0), DraftStep.TRACKING, text, Path())
    assert changed.tracking is not None
    assert (changed.tracking.address, changed.tracking.body) == ("10.0.0.5", body)


def test_what_stands_in_brackets_may_be_typed(tmp_path: Path) -> None:
    asks, _ = dialog(
        tmp_path, "6x4", "that is all", "", "auto", "that is all", "that is all",
        "natnet 10.0.0.5 Body 1", "later", "192.168.1.1",
    )  # fmt: skip
    draft = asks.run()
    assert draft.tracking is not None and draft.tracking.body == "Body 1"
    assert draft.drone is not None


def test_help_back_map_and_missing_answer_at_any_question(tmp_path: Path) -> None:
    asks, typed = dialog(
        tmp_path, "help", "missing", "map", "6x4", "map", "back", "5x4", "", "", "", "", "", ""
    )
    assert asks.run().bounds == (0.0, 0.0, 5.0, 4.0)
    assert "layers=A,B" in typed.text
    assert "the room has no size yet" in typed.text
    assert "nothing to draw" in typed.text
    assert "H home" in typed.text


def test_a_wrong_answer_is_told_and_asked_again(tmp_path: Path) -> None:
    asks, typed = dialog(
        tmp_path,
        *("6x", "nowhere.yaml", "6x4", "sofa", "remove sofa", "", "90,90", "1,1", "home 2,2"),
        *("kitchen 9,9", "remove kitchen", "auto", "", "1,1", "", "wifi here", "", "tellp", ""),
    )
    assert missing(asks.run()) == ()
    for words in (
        "allowed: a size such as 6x4x2.5",
        "is no file",
        "NAME X,Y LENGTHxWIDTHxHEIGHT",
        "nothing is called 'sofa'",
        "is roomy",
        "choose another",
        "cannot hover at 'kitchen'",
        "x_min,y_min,x_max,y_max REASON",
        "KIND one of vicon",
        "did you mean 'tello'",
    ):
        assert words in typed.text


def test_a_script_ends_at_its_first_wrong_answer(tmp_path: Path) -> None:
    typed = TypedLines(("6x4", "sofa"), is_patient=False)
    with pytest.raises(ConfigError, match="NAME X,Y"):
        NewSiteDialog(SiteDraft("lab"), tmp_path, typed).run()


@pytest.mark.parametrize("text", ["6,5x4", "6.5x4,2", "6,5 x 4,2", "6,4"])
def test_a_decimal_comma_is_no_size(tmp_path: Path, text: str) -> None:
    with pytest.raises(ConfigError, match=r"allowed: a size such as 6x4x2\.5"):
        answered(SiteDraft("lab"), DraftStep.ROOM, text, tmp_path)


@pytest.mark.parametrize("text", ["6.5x4", "6.5 x 4 m", "6.5m x 4m x 2.5m", "6.5\u00d74", "6.5 4"])
def test_a_size_is_read_however_it_is_written(tmp_path: Path, text: str) -> None:
    draft, _ = answered(SiteDraft("lab"), DraftStep.ROOM, text, tmp_path)
    assert draft.bounds == (0.0, 0.0, 6.5, 4.0) and draft.height == 2.5


def test_a_decimal_comma_is_no_size_of_furniture(tmp_path: Path) -> None:
    room = with_size(SiteDraft("lab"), 6.0, 4.0)
    with pytest.raises(ConfigError, match="furniture"):
        answered(room, DraftStep.OBJECTS, "table 3,1 1,2x0.8", tmp_path)


@pytest.mark.parametrize("unit", ["0", "-1", "1e9", "100000"])
def test_a_unit_out_of_range_is_refused(tmp_path: Path, unit: str) -> None:
    (tmp_path / "scan.ply").write_text("ply")
    with pytest.raises(ConfigError, match="unit"):
        answered(SiteDraft("lab"), DraftStep.ROOM, f"scan.ply unit={unit}", tmp_path)


def test_a_script_ends_at_a_pad_that_cannot_be(tmp_path: Path) -> None:
    script = TypedLines(["6x4", "", "0,0", "kitchen 5,2", "", "", ""], is_patient=False)
    with pytest.raises(ConfigError, match="pad: the drone cannot start"):
        NewSiteDialog(SiteDraft("lab"), tmp_path, script).run()


def test_what_was_said_before_the_end_is_gone_on_with(tmp_path: Path) -> None:
    asks, _ = dialog(tmp_path, "6x4", "table 3,1 1x1x.7", "", "1,2")
    with pytest.raises(OutOfAnswers):
        asks.run()
    kept = load_draft(tmp_path)
    assert kept is not None
    again, typed = dialog(tmp_path, "", "quit", draft=kept)
    with pytest.raises(LeftDialog):
        again.run()
    assert typed.shown[0].startswith("Places")
    assert again.draft.furniture[0].name == "table"


def test_each_line_is_kept_before_the_next_one_is_read(tmp_path: Path) -> None:
    asks, _ = dialog(tmp_path, "6x4", "table 3,1 1x1x.7")
    with pytest.raises(OutOfAnswers):
        asks.run()
    kept = load_draft(tmp_path)
    assert kept is not None and kept.furniture[0].name == "table"


def test_enter_all_the_way_changes_nothing_of_a_finished_site(tmp_path: Path) -> None:
    asks, _ = dialog(tmp_path, "6x4", "table 3,1 1x1x.7", "", "", "", "", "", "")
    draft = asks.run()
    again, typed = dialog(tmp_path, "", "", "", "", "", "", "", draft=draft)
    assert again.run() == draft
    assert typed.shown[0].startswith("Room")


def test_options_are_answers_and_are_not_asked(tmp_path: Path) -> None:
    given = {DraftStep.ROOM: ("6x4",), DraftStep.PLACES: ("kitchen 5,2", "door 1,3")}
    draft = NewSiteDialog(SiteDraft("lab"), tmp_path, DefaultsAsker(), given=given).run()
    assert [place.name for place in draft.places] == ["kitchen", "door"]
    with pytest.raises(ConfigError, match="room"):
        NewSiteDialog(SiteDraft("lab"), tmp_path, DefaultsAsker()).run()


def test_three_points_align_the_frame_from_what_tracking_sees(tmp_path: Path) -> None:
    def seen(x: float, y: float) -> tuple[float, float]:
        turn, dx, dy = 0.5, x - 2.0, y - 1.0
        return cos(turn) * dx + sin(turn) * dy, -sin(turn) * dx + cos(turn) * dy

    places = [(0.0, 0.0), (1.0, 2.0), (5.0, 2.0), (1.0, 3.5)]
    asks, typed = dialog(
        tmp_path,
        *("6x4", "", "1,2", "", "", "vicon 10.0.0.5", "pad", "5,2", "1,3.5", "", ""),
        wires=Wires(heard_at(seen(*place) for place in places), lambda drone: (Words("well"),)),
    )
    draft = asks.run()
    assert [item.step for item in missing(draft)] == [DraftStep.DRONE]  # advice: identify
    assert "origin at (2.000, 1.000, 0.000) m" in typed.text
    assert "100 frames a second" in typed.text
    assert len(draft.frame_points) == 3


def test_a_drone_that_is_carried_while_it_is_measured_is_refused(tmp_path: Path) -> None:
    body = HeardBody("ardrone", (1.0, 1.0, 0.0), 0.0, 100.0, 0.3)
    asks, typed = dialog(
        tmp_path,
        *("6x4", "", "", "", "", "vicon 10.0.0.5", "pad", "", ""),
        wires=Wires(lambda tracking, seconds: Heard("vicon", 100.0, (body,), "")),
    )
    assert asks.run().frame_points == ()
    assert "put it down" in typed.text


def test_another_tracking_system_forgets_the_points_of_the_last(tmp_path: Path) -> None:
    draft = with_size(SiteDraft("lab"), 6.0, 4.0)
    draft = replace(draft, hardware=True, tracking=DraftTracking("vicon", "10.0.0.5"))
    draft, _ = answered(draft, DraftStep.FRAME, "1,2 = 0,0,0", tmp_path)
    same, _ = answered(draft, DraftStep.TRACKING, "vicon 10.0.0.5", tmp_path)
    other, _ = answered(draft, DraftStep.TRACKING, "vicon 10.0.0.6", tmp_path)
    assert len(same.frame_points) == 1
    assert other.frame_points == ()


@settings(max_examples=150, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.sampled_from(DraftStep), st.text(min_size=1, max_size=60) | st.from_regex(
    r"[a-z]{0,8} ?(-?\d{1,9}(\.\d)?[,x =]){0,8}[a-z0-9=]{0,6}", fullmatch=True
))  # fmt: skip
def test_any_line_changes_the_draft_or_is_refused_in_words(
    tmp_path: Path, step: DraftStep, text: str
) -> None:
    draft = with_size(SiteDraft("lab"), 6.0, 4.0)
    try:
        changed, _ = answered(draft, step, text, tmp_path)
    except HouseflyError as error:
        assert str(error)
        return
    missing(changed)
