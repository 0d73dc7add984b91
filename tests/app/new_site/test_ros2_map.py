"""A room of the map that a real ROS 2 node, of another process, publishes."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from ros_map_server import EDGE, ORIGIN, SIZE, ros_map_server

from housefly.app.new_site.answers import answered
from housefly.app.new_site.ros2_map import MapTopic, hear_map, map_topic
from housefly.cli import main
from housefly.errors import ConfigError, LinkError, RoomError
from housefly.room.draft.missing import DraftStep
from housefly.room.draft.model import SiteDraft
from housefly.sites.loaded_site import load_site

pytestmark = [pytest.mark.wire, pytest.mark.slow]
DOMAIN = 10 + os.getpid() % 90


def heard(topic: str, patience: float = 30.0) -> object:
    return hear_map(MapTopic(topic, DOMAIN), patience)


@pytest.fixture(autouse=True)
def _rclpy() -> None:
    pytest.importorskip("rclpy")


@pytest.mark.parametrize("manner", ["latched", "repeated"])
def test_a_map_is_heard_latched_or_told_again(manner: str) -> None:
    with ros_map_server(DOMAIN, f"/{manner}", manner):
        found = hear_map(MapTopic(f"/{manner}", DOMAIN), 30.0)
    assert found.free.shape == SIZE
    assert found.resolution == pytest.approx(EDGE) and found.origin == ORIGIN


def test_a_site_is_made_of_it_that_flies(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    line = f"ros2:/room/map domain={DOMAIN}"
    with ros_map_server(DOMAIN, "/room/map"):
        assert main(["new", str(tmp_path / "lab"), "--room", line, "--yes"]) == 0
    said = capsys.readouterr().out
    assert "never seen" in said and "which the ROS map calls (-1.05, -2.05) m" in said
    room = load_site(str(tmp_path / "lab")).room
    assert {solid.thing for solid in room.solids} >= {"wall", "unexplored"}
    assert room.bounds == pytest.approx((0.0, 0.0, 6.1, 4.1), abs=0.01)


def test_unexplored_floor_is_free_where_that_is_said() -> None:
    line = f"ros2:/free domain={DOMAIN} unexplored=free"
    with ros_map_server(DOMAIN, "/free"):
        draft, words = answered(SiteDraft(name="lab"), DraftStep.ROOM, line, Path())
    assert not any(box.thing == "unexplored" for box in draft.scanned)
    assert any("counts as free" in word for word in words)
    assert draft.source == "ros2:/free"


def test_where_nobody_publishes_that_is_said() -> None:
    with pytest.raises(LinkError, match="nobody publishes on ros2:/nobody in 1 s"):
        heard("/nobody", 1.0)


def test_who_publishes_there_but_tells_nothing_is_said() -> None:
    with ros_map_server(DOMAIN, "/silent", "silent"), pytest.raises(LinkError, match="latched"):
        heard("/silent", 5.0)


@pytest.mark.parametrize(
    ("manner", "error", "words"),
    [
        ("turned", RoomError, "turned by 0.786 rad"),
        ("short", RoomError, "9599 values for 120 x 80 cells"),
        ("text", LinkError, "std_msgs/msg/String"),
    ],
)
def test_what_is_no_map_is_refused_in_words(
    manner: str, error: type[Exception], words: str
) -> None:
    with ros_map_server(DOMAIN, f"/{manner}", manner), pytest.raises(error, match=words):
        heard(f"/{manner}", 5.0 if manner == "text" else 30.0)


@pytest.mark.parametrize(
    ("line", "key"),
    [
        ("ros2:map", "room"),
        ("ros2:", "room"),
        ("ros2:/map/", "room"),
        ("ros2:/map domain=233", "domain"),
        ("ros2:/map domain=-1", "domain"),
        ("ros2:/map discovery=world", "discovery"),
        ("ros2:/map unexplored=yes", "unexplored"),
    ],
)
def test_a_line_that_names_no_topic_is_refused(line: str, key: str) -> None:
    with pytest.raises(ConfigError) as refused:
        answered(SiteDraft(name="lab"), DraftStep.ROOM, line, Path())
    assert refused.value.key == key


def test_a_line_names_topic_domain_and_network() -> None:
    keys = {"domain": "7", "discovery": "subnet"}
    assert map_topic("ros2:/a/map", keys) == MapTopic("/a/map", 7, "subnet")
