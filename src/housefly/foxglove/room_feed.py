"""What is where and what happens in the room, as channels of the live view."""

from __future__ import annotations

from collections.abc import Sequence

from housefly.bus.bus import Bus, Subscription
from housefly.bus.topics import FRAME_TOPIC, OBSTACLE_TOPIC
from housefly.foxglove.channels import body_topic, tracked_bodies
from housefly.foxglove.demand import Feed
from housefly.foxglove.house_board import HouseBoard, house_tasks
from housefly.foxglove.json_values import RoomHappening, RoomSituations, SituationRow, to_json
from housefly.foxglove.live_server import LiveServer
from housefly.foxglove.markers import obstacle_markers, solid_markers, tracked_markers
from housefly.hub.api.answers import News
from housefly.hub.api.topics import ROOM_NEWS_TOPIC
from housefly.hub.wall_clock import WallClock
from housefly.messages import Obstacle, TrackedFrame
from housefly.record import ros_messages
from housefly.room.tracked import untracked
from housefly.sites.loaded_site import LoadedSite
from housefly.tasks.api.answers import TaskBoard

_MARKER_PERIOD = 0.1
"""Furniture and people that are tracked are drawn this often [s]; their poses come as they come."""


class RoomFeed:
    """The channels of the room.

    Args:
        bus: where everybody speaks.
        server: where the channels are.
        site: room and map.
        board: of the tasks.
        wall: Unix time of the monotonic clock.
    """

    def __init__(
        self, bus: Bus, server: LiveServer, site: LoadedSite, board: HouseBoard, wall: WallClock
    ) -> None:
        self._bus, self._server, self._site = bus, server, site
        self._board, self._wall = board, wall
        people = site.site.people
        named = {*people.bodies, site.site.tracking.visitor} - {""}
        self._people = dict.fromkeys(named, people.body_radius)
        self._furniture = {piece.body: piece for piece in site.site.furniture}
        self._bodies = {body: body_topic(body) for body in tracked_bodies(site.site)}

    @property
    def feeds(self) -> tuple[Feed, ...]:
        """What fills the channels, each part only while it is watched."""
        always = (
            Feed(("/room/furniture",), self._draw_furniture),
            Feed(("/room/obstacles",), self._hear_obstacles),
            Feed(("/room/tracked", *self._bodies.values()), self._hear_frames),
        )
        hub = (Feed(("/room/events", "/room/situations"), self._hear_news),)
        tasks = (Feed(("/tasks",), self._hear_tasks),)
        site = self._site.site
        return (*always, *hub * site.hub.enabled, *tasks * site.tasks.enabled)

    def _draw_furniture(self) -> Sequence[Subscription]:
        at = self._wall.now()
        standing = untracked(self._site.room, self._site.site)
        self._server.send("/room/furniture", at, solid_markers(at, standing))
        return ()

    def _hear_obstacles(self) -> Sequence[Subscription]:
        def heard(obstacle: Obstacle) -> None:
            at = obstacle.seen_at + self._wall.offset()
            self._server.send("/room/obstacles", at, obstacle_markers(at, obstacle))

        return (self._bus.subscribe(OBSTACLE_TOPIC, heard),)

    def _hear_frames(self) -> Sequence[Subscription]:
        drawn = [float("-inf")]

        def heard(frame: TrackedFrame) -> None:
            offset = self._wall.offset()
            for seen in frame.sightings:
                topic = self._bodies.get(seen.body)
                if topic is not None and self._server.is_wanted(topic):
                    at = seen.captured_at + offset
                    self._server.send(topic, at, ros_messages.pose_stamped(at, seen.pose))
            at = self._wall.now()
            if at - drawn[0] >= _MARKER_PERIOD and self._server.is_wanted("/room/tracked"):
                drawn[0] = at
                markers = tracked_markers(at, frame.sightings, self._furniture, self._people)
                self._server.send("/room/tracked", at, markers)

        return (self._bus.subscribe(FRAME_TOPIC, heard),)

    def _hear_news(self) -> Sequence[Subscription]:
        def heard(news: News) -> None:
            for event in news.events:
                told = RoomHappening(
                    event.at,
                    event.kind,
                    event.thing,
                    event.cause,
                    event.source,
                    event.confidence,
                    str(event.words),
                )
                self._server.send_bytes("/room/events", event.at, to_json(told))
            rows = tuple(
                SituationRow(one.kind, one.thing, one.since, one.confidence, str(one.words))
                for one in news.situations
            )
            situations = to_json(RoomSituations(news.at, rows))
            self._server.send_bytes("/room/situations", news.at, situations)

        return (self._bus.subscribe(ROOM_NEWS_TOPIC, heard),)

    def _hear_tasks(self) -> Sequence[Subscription]:
        def heard(board: TaskBoard) -> None:
            self._server.send_bytes("/tasks", board.at, to_json(house_tasks(board)))

        return self._board.follow(heard)
