"""Rosbridge on the console's port: what a client hears, what it may do, what it may not."""

from __future__ import annotations

import http.client
import json
import time
from base64 import b64decode
from collections.abc import Iterator
from typing import Any

import pytest
from filming import video
from rosbridge_stage import DRONE, KEY, ROOM, RosbridgeStage
from websockets.exceptions import ConnectionClosed, InvalidStatus

from housefly.bus.topics import OBSTACLE_TOPIC, DroneTopics
from housefly.hub.api.answers import EventAnswer, News, PlacedThing
from housefly.hub.api.topics import ROOM_NEWS_TOPIC
from housefly.messages import Obstacle, OrderKind, OrderOutcome
from housefly.ros2.topic_table import DRONE_TOPICS, ROOM_TOPICS, full_name
from housefly.tasks.api.questions import CancelTask, RequestTask, Sentence
from housefly.tasks.api.values import Confirm, RequestSurface
from housefly.web.rosbridge.outbox import TOPICS_MAX

pytestmark = pytest.mark.wire

GOAL = {
    "header": {"frame_id": "map"},
    "pose": {"position": {"x": 6.0, "y": 4.0}, "orientation": {"w": 1.0}},
}


def stage_of(folder: Any, number: int, requests: Any, **changes: Any) -> RosbridgeStage:
    return RosbridgeStage(f"127.77.{number}.1", folder, requests, **changes)


@pytest.fixture(scope="module")
def trusted(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RosbridgeStage]:
    """A site where programs and who may fly need no yes."""
    with stage_of(tmp_path_factory.mktemp("a"), 1, "auto", ros2__paper_names=True) as stage:
        yield stage


@pytest.fixture(scope="module")
def asking(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RosbridgeStage]:
    """A site where a person says yes."""
    folder = tmp_path_factory.mktemp("b")
    with stage_of(folder, 2, "ask", origins=("http://lab.example:8000",)) as stage:
        yield stage


@pytest.fixture
def stage(trusted: RosbridgeStage) -> RosbridgeStage:
    trusted.pilot.land()
    trusted.pilot.refused.clear()
    trusted.stops.clear()
    return trusted


def kinds(stage: RosbridgeStage) -> list[OrderKind]:
    return [one.kind for one in stage.pilot.orders]


# --- what it tells


def test_rosapi_lists_every_topic_of_the_table_with_its_type(stage: RosbridgeStage) -> None:
    expected = {full_name(one, "b_sen", "drone"): one.type for one in DRONE_TOPICS}
    expected |= {full_name(one, "b_sen"): one.type for one in ROOM_TOPICS}
    with stage.program() as client:
        there = client.call("/rosapi/topics")["values"]
        types = dict(zip(there["topics"], there["types"], strict=True))
        assert expected.items() <= types.items()
        asked = client.call("/rosapi/topic_type", {"topic": f"{DRONE}/odom"})
        assert asked["values"] == {"type": "nav_msgs/msg/Odometry"}
        services = client.call("/rosapi/services")["values"]["services"]
        assert {f"{DRONE}/takeoff", f"{ROOM}/stop", f"{ROOM}/tasks/visitor"} <= set(services)
        found = client.call("/rosapi/topics_for_type", ["geometry_msgs/PoseStamped"])["values"]
        assert found["topics"] == [f"{DRONE}/pose", f"{DRONE}/goal_pose"]
        refused = client.call("/rosapi/topic_type", {"topic": 7})
        assert not refused["result"] and "args.topic" in refused["values"]


def test_poses_and_odometry_come_with_the_time_of_capture(stage: RosbridgeStage) -> None:
    with stage.program() as client:
        pose = client.message(f"{DRONE}/pose", type="geometry_msgs/PoseStamped")
        stamp = pose["header"]["stamp"]
        assert abs(time.time() - stamp["sec"] - 1e-9 * stamp["nanosec"]) < 30.0
        assert pose["header"]["frame_id"] == "map"
        assert pose["pose"]["position"] == {"x": 3.0, "y": 2.0, "z": 1.1}
        odometry = client.message(f"{DRONE}/odom", type="nav_msgs/msg/Odometry")
        assert odometry["child_frame_id"] == "drone/base_link"
        assert len(odometry["pose"]["covariance"]) == 36


def test_who_comes_late_gets_what_is_latched(stage: RosbridgeStage) -> None:
    with stage.program() as client:
        grid = client.message(f"{ROOM}/map")
        assert {0, 100} <= set(grid["data"])
        assert len(grid["data"]) == grid["info"]["width"] * grid["info"]["height"]
        battery = client.message(f"{DRONE}/battery")
        assert battery["percentage"] == pytest.approx(0.8) and battery["voltage"] is None
        assert client.message(f"{DRONE}/phase") == {"data": "idle"}
        assert len(client.message(f"{ROOM}/room")["markers"]) > 20
        assert json.loads(client.message(f"{ROOM}/tasks")["data"])["mode"] == "home"
        assert client.message("/tf")["transforms"][0]["child_frame_id"] == "drone/base_link"


def test_people_things_events_and_what_is_in_the_way(stage: RosbridgeStage) -> None:
    person = PlacedThing("p1", "Anna", "person", (1.0, 2.0, 0.0), 0.0, "", 1.0)
    cup = PlacedThing("cup", "cup", "object", (4.0, 1.0, 0.8), None, "", 1.0)
    event = EventAnswer("object taken", "cup", 1.0, "situations", "p1", 1.0, {})
    news = News(1.0, (person, cup), (event,), (), ())
    with stage.program() as client:
        for name in ("people", "things", "events", "obstacles", "situations"):
            client.say("subscribe", topic=f"{ROOM}/{name}")
        client.call("/rosapi/get_time")  # by now it hears them
        stage.bus.publish(ROOM_NEWS_TOPIC, news)
        people = client.hear("publish", topic=f"{ROOM}/people")["msg"]
        assert people["poses"][0]["position"] == {"x": 1.0, "y": 2.0, "z": 0.0}
        (thing,) = json.loads(client.hear("publish", topic=f"{ROOM}/things")["msg"]["data"])
        assert thing["thing"] == "cup"
        told = json.loads(client.hear("publish", topic=f"{ROOM}/events")["msg"]["data"])
        assert told["kind"] == "object taken"
        stage.bus.publish(OBSTACLE_TOPIC, Obstacle("1", (2.0, 2.0), seen_at=time.monotonic()))
        stage.until(
            lambda: client.hear("publish", topic=f"{ROOM}/obstacles")["msg"]["markers"] != []
        )


def test_pictures_are_jpeg_in_base64_while_somebody_listens(stage: RosbridgeStage) -> None:
    frames = list(video(10))
    with stage.program() as client:
        client.say("subscribe", topic=f"{DRONE}/camera/image_raw/compressed")
        client.call("/rosapi/get_time")
        for frame in frames:
            stage.bus.publish(DroneTopics().video, frame)
        topic = f"{DRONE}/camera/image_raw/compressed"
        picture = client.hear("publish", topic=topic)["msg"]
        assert picture["format"] == "jpeg"
        assert b64decode(picture["data"])[:2] == b"\xff\xd8"


def test_a_throttled_topic_sends_the_newest_so_often(stage: RosbridgeStage) -> None:
    with stage.program() as client:
        client.say("subscribe", topic=f"{DRONE}/pose", throttle_rate=400)
        stamps = []
        for _ in range(3):
            at = client.hear("publish", topic=f"{DRONE}/pose")["msg"]["header"]["stamp"]
            stamps.append(at["sec"] + 1e-9 * at["nanosec"])
        # Fifty come a second: those in between were dropped.
        assert stamps[1] - stamps[0] > 0.2 and stamps[2] - stamps[1] > 0.2


def test_unsubscribed_topics_fall_silent(stage: RosbridgeStage) -> None:
    with stage.program() as client:
        client.message(f"{DRONE}/pose", id="a")
        client.say("unsubscribe", topic=f"{DRONE}/pose", id="a")
        client.call("/rosapi/get_time")
        client.heard.clear()
        stage.until(lambda: not stage.bridge.topics.is_heard(f"{DRONE}/pose"))
        client.call("/rosapi/get_time")
        client.call("/rosapi/get_time")
        assert client.heard == []


def test_a_new_map_is_told_without_a_restart(stage: RosbridgeStage) -> None:
    before = stage.bridge.room
    with stage.program() as client:
        client.message(f"{ROOM}/map")
        stage.edition += 1
        client.hear("publish", topic=f"{ROOM}/map")
        stage.until(lambda: stage.bridge.room is not before)
        stage.until(lambda: stage.bridge.room is not None and stage.bridge.room.errands)
        assert client.call(f"{DRONE}/land")["values"]["success"]


# --- what may be asked of it


def test_a_goal_flies_there_where_the_site_trusts(stage: RosbridgeStage) -> None:
    with stage.program() as client:
        topic = f"{DRONE}/goal_pose"
        client.say("set_level", level="info")
        client.say("advertise", topic=topic, type="geometry_msgs/PoseStamped", id="ad")
        client.say("publish", topic=topic, msg=GOAL)
        assert "x 6.00, y 4.00" in client.hear("status", level="info")["msg"]
        order = stage.pilot.orders[0]
        assert (order.kind, order.goal, order.sender) == (OrderKind.GO, (6.0, 4.0), "rosbridge")
        stage.until(lambda: "goal_pose" in stage.audit_file.read_text())


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ({"header": {"frame_id": "odom"}}, "its frame is 'odom'"),
        ({"pose": {"position": {"x": None}}}, "no point"),
        ({"pose": {"position": {"x": "6"}}}, "msg.pose.position.x is '6'; allowed: a number"),
        ({"pose": {"place": 1}}, "msg.pose.'place': no such field; there are: orientation"),
        ({"header": {"stamp": {"sec": 2**40}}}, "allowed: a whole number"),
        ([1], "msg is [1]; allowed: an object"),
    ],
)
def test_a_goal_that_makes_no_sense_flies_nowhere(
    stage: RosbridgeStage, wrong: Any, words: str
) -> None:
    with stage.program() as client:
        told = client.refusal("publish", topic=f"{DRONE}/goal_pose", msg=wrong)
        assert words in told
        assert not stage.pilot.orders


def test_the_services_give_orders_and_say_what_the_pilot_says(stage: RosbridgeStage) -> None:
    with stage.program() as client:
        for name, kind in (
            ("takeoff", OrderKind.TAKE_OFF),
            ("home", OrderKind.HOME),
            ("land", OrderKind.LAND),
        ):
            time.sleep(0.3)
            assert client.call(f"{DRONE}/{name}")["values"]["success"], name
            assert kinds(stage)[-1] is kind
        time.sleep(0.3)
        stage.pilot.refused[OrderKind.TAKE_OFF] = OrderOutcome.BATTERY
        assert not client.call(f"{DRONE}/takeoff")["values"]["success"]


def test_stop_goes_its_own_path_too(stage: RosbridgeStage) -> None:
    with stage.program() as client:
        for name in (f"{DRONE}/stop", f"{ROOM}/stop"):
            stage.stops.clear()
            answer = client.call(name)
            assert answer["result"] and answer["values"]["success"]
            assert stage.stops and OrderKind.STOP in kinds(stage)


def test_who_flies_the_drone_keeps_it_but_stop_and_land_pass(stage: RosbridgeStage) -> None:
    stage.pilot.flown_by("Anna")
    time.sleep(0.5)
    with stage.program() as client:
        refused = client.call(f"{DRONE}/home")["values"]
        assert refused == {"success": False, "message": "Anna flies it"}
        assert client.call(f"{DRONE}/land")["values"]["success"]
        assert client.call(f"{DRONE}/stop")["values"]["success"]


def test_the_papers_node_is_served_too(stage: RosbridgeStage) -> None:
    with stage.program() as client:
        client.say("publish", topic="/ardrone/takeoff", msg={})
        stage.until(lambda: OrderKind.TAKE_OFF in kinds(stage))
        assert client.message("/ardrone/navdata")["state"] == 2


def test_where_a_person_says_yes_a_goal_becomes_a_question(asking: RosbridgeStage) -> None:
    asking.tasks.asked.clear()
    with asking.program() as client:
        client.say("set_level", level="info")
        answer = client.call(f"{ROOM}/tasks/visitor")["values"]
        assert answer["success"] and "a person must say yes" in answer["message"]
        asked = next(one for one in asking.tasks.asked if isinstance(one, RequestTask))
        assert (asked.confirm, asked.surface) == (Confirm.ASK, RequestSurface.ROS)
        assert asking.pilot.orders == []


def test_a_sentence_is_answered_to_who_asked_alone(asking: RosbridgeStage) -> None:
    with asking.program() as client, asking.page("fly") as other:
        for one in (client, other):
            one.say("subscribe", topic=f"{ROOM}/answers")
            one.call("/rosapi/get_time")
        client.say("publish", topic=f"{ROOM}/ask", msg={"data": "where is the cup"})
        answer = json.loads(client.hear("publish", topic=f"{ROOM}/answers")["msg"]["data"])
        assert "cabinet" in answer["words"]
        client.say("publish", topic=f"{ROOM}/ask", msg={"data": '{"ask":"where","thing":"cup"}'})
        answer = json.loads(client.hear("publish", topic=f"{ROOM}/answers")["msg"]["data"])
        assert answer["asked"]["thing"] == "cup"
        other.call("/rosapi/get_time")
        assert other.heard == []
    said = [one for one in asking.tasks.asked if isinstance(one, Sentence)]
    assert said[-1].by == "rosbridge" and not said[-1].may_fly


# --- who may what


def test_a_viewer_sees_and_stops_and_flies_nothing(stage: RosbridgeStage) -> None:
    with stage.page("watch") as client:
        client.message(f"{DRONE}/pose")
        for service in (f"{DRONE}/takeoff", f"{DRONE}/home", f"{ROOM}/tasks/visitor"):
            values = client.call(service)["values"]
            assert not values["success"] and "your role" in values["message"]
        for topic, message in (
            (f"{DRONE}/goal_pose", GOAL),
            ("/ardrone/takeoff", {}),
            ("/ardrone/reset", {}),
        ):
            assert "your role" in client.refusal("publish", topic=topic, msg=message)
        client.say("subscribe", topic=f"{ROOM}/answers")
        client.say("publish", topic=f"{ROOM}/ask", msg={"data": "where is the cup"})
        answer = client.hear("publish", topic=f"{ROOM}/answers")["msg"]["data"]
        assert "not ask" in json.loads(answer)["error"]
        assert kinds(stage) == []
        assert client.call(f"{DRONE}/stop")["values"]["success"]
        assert client.call(f"{DRONE}/land")["values"]["success"]
        assert stage.stops


def test_who_may_only_ask_asks_a_person_and_ends_only_their_own(stage: RosbridgeStage) -> None:
    stage.tasks.asked.clear()
    with stage.page("ask") as client:
        assert client.call(f"{DRONE}/takeoff")["values"]["success"] is False  # no fly_to here
        assert client.call(f"{ROOM}/tasks/visitor")["values"]["success"]
        asked = [one for one in stage.tasks.asked if isinstance(one, RequestTask)]
        assert {one.confirm for one in asked} == {Confirm.ASK}
        client.say("subscribe", topic=f"{ROOM}/answers")
        client.say("publish", topic=f"{ROOM}/ask", msg={"data": '{"ask":"cancel","task":0}'})
        client.hear("publish", topic=f"{ROOM}/answers")
        (cancelled,) = [one for one in stage.tasks.asked if isinstance(one, CancelTask)]
        assert cancelled.only_of == asked[0].owner != ""
    assert kinds(stage) == []


def test_who_may_fly_flies(stage: RosbridgeStage) -> None:
    with stage.page("fly") as client:
        assert client.call(f"{DRONE}/takeoff")["values"]["success"]
    assert stage.pilot.orders[-1].sender.endswith("(rosbridge)")


@pytest.mark.parametrize(
    "options",
    [
        {},
        {"additional_headers": {"Authorization": "Bearer wrong"}},
        {"path": "/rosbridge?key=wrong"},
        {"path": f"/rosbridge?key={KEY}", "origin": "http://evil.example"},
        {
            "additional_headers": {"Authorization": f"Bearer {KEY}"},
            "origin": "http://evil.example",
        },
    ],
    ids=["nobody", "wrong key", "wrong parameter", "other page", "other page with a header"],
)
def test_nobody_else_gets_in(asking: RosbridgeStage, options: dict[str, Any]) -> None:
    with pytest.raises((ConnectionClosed, InvalidStatus)), asking._connected(**options) as client:
        client.call("/rosapi/topics")


def test_a_page_of_another_origin_has_no_use_of_a_session(asking: RosbridgeStage) -> None:
    cookie, proof = asking.session("fly")
    headers = {"Cookie": cookie, "X-Housefly-Proof": proof}
    for origin in ("http://evil.example", "http://lab.example:8000", None):
        options: dict[str, Any] = {"additional_headers": headers, "origin": origin}
        with pytest.raises((ConnectionClosed, InvalidStatus)), asking._connected(**options) as one:
            one.call("/rosapi/topics")


def test_a_session_that_ends_ends_its_sockets(stage: RosbridgeStage) -> None:
    cookie, proof = stage.session("fly")
    headers = {"Cookie": cookie, "X-Housefly-Proof": proof}
    options: dict[str, Any] = {"additional_headers": headers, "origin": stage.origin}
    with stage._connected(**options) as client:
        client.call("/rosapi/nodes")
        connection = http.client.HTTPConnection(stage.host, stage.port, timeout=30.0)
        connection.request("POST", "/logout", headers={**headers, "Origin": stage.origin})
        connection.getresponse().read()
        connection.close()
        with pytest.raises(ConnectionClosed) as closed:
            client.hear("publish", topic="nothing")
    assert closed.value.rcvd is not None and closed.value.rcvd.code == 4003


def test_a_page_that_the_site_names_gets_in_with_the_key(asking: RosbridgeStage) -> None:
    origin: Any = "http://lab.example:8000"
    with asking._connected(f"/rosbridge?key={KEY}", origin=origin) as client:
        assert client.call("/rosapi/nodes")["values"] == {"nodes": ["/housefly"]}


# --- what is refused in words


@pytest.mark.parametrize(
    ("op", "rest", "words"),
    [
        ("subscribe", {"topic": f"{DRONE}/pose", "compression": "png"}, "compression 'png'"),
        ("subscribe", {"topic": f"{DRONE}/pose", "compression": "cbor"}, "compression 'cbor'"),
        ("subscribe", {"topic": f"{DRONE}/pose", "fragment_size": 100}, "fragments"),
        ("subscribe", {"topic": f"{DRONE}/pose", "throttle_rate": -1}, "throttle_rate"),
        ("subscribe", {"topic": f"{DRONE}/pose", "type": "std_msgs/String"}, "PoseStamped"),
        ("subscribe", {"topic": "/moon"}, "there is no topic '/moon'"),
        ("subscribe", {}, "topic"),
        ("advertise", {"topic": f"{ROOM}/map", "type": "std_msgs/String"}, "nobody may publish"),
        ("publish", {"topic": f"{DRONE}/odom", "msg": {}}, "nobody may publish"),
        ("advertise_service", {"service": "/a", "type": "b"}, "op"),
        ("fragment", {"id": "1"}, "op"),
    ],
)
def test_what_is_not_served_is_refused_in_words(
    asking: RosbridgeStage, op: str, rest: dict[str, Any], words: str
) -> None:
    with asking.program() as client:
        assert words in client.refusal(op, **rest)


def test_a_call_that_fails_says_so_in_its_response(asking: RosbridgeStage) -> None:
    with asking.program() as client:
        answer = client.call("/moon")
        assert not answer["result"] and "there is no service '/moon'" in answer["values"]


def test_nesting_noise_and_size_end_in_words_or_in_a_closed_socket(
    asking: RosbridgeStage,
) -> None:
    with asking.program() as client:
        for text in ("", "[", '{"op":' + "[" * 5000, "\x00", "null", "[1]", '"a"'):
            client.socket.send(text)
            assert client.hear("status", level="error")["msg"]
        client.socket.send(b"\x00\x01")
        assert client.hear("status", level="error")["msg"]
        client.socket.send('{"op":"publish","topic":"' + "a" * 20_000)
        with pytest.raises(ConnectionClosed):
            client.call("/rosapi/nodes")


def test_topics_and_messages_are_bounded_but_stop_passes(stage: RosbridgeStage) -> None:
    with stage.program() as client:
        there = client.call("/rosapi/topics")["values"]["topics"]
        assert len(there) < TOPICS_MAX
        for number in range(40):
            client.say("subscribe", topic=f"{ROOM}/answers", id=f"{number}")
        assert "16 subscriptions" in client.hear("status", level="error")["msg"]
        for _ in range(300):
            client.say("unadvertise", topic="/a")
            client.say("set_level", level="error")
        answer = client.call(f"{DRONE}/stop")
        assert answer["values"]["success"] and stage.stops
        words = [one["msg"] for one in client.heard if one["op"] == "status"]
        assert any("too many messages" in one for one in words)


def test_who_does_not_read_drops_messages_and_holds_up_nobody(stage: RosbridgeStage) -> None:
    with stage.program(max_queue=1) as slow, stage.program() as client:
        slow.say("subscribe", topic=f"{ROOM}/room", throttle_rate=0)
        slow.say("subscribe", topic=f"{DRONE}/odom")
        big = stage.bridge.topics
        for _ in range(40):
            client.message(f"{DRONE}/pose")
        assert big.is_heard(f"{DRONE}/odom")
        assert client.call(f"{DRONE}/stop")["values"]["success"]
