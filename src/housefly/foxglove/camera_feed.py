"""The drone's camera as foxglove_msgs/CompressedVideo: never more than the console would show."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from housefly.bus.bus import Bus, Subscription
from housefly.bus.topics import DroneTopics
from housefly.config.house_mode import HouseMode
from housefly.config.site import Site
from housefly.evidence.live_blanker import LiveBlanker
from housefly.evidence.picture_filter import PictureFilter
from housefly.foxglove.channels import drone_topic
from housefly.foxglove.demand import Feed
from housefly.foxglove.house_board import HouseBoard
from housefly.foxglove.live_server import LiveServer
from housefly.hub.wall_clock import WallClock
from housefly.messages import VideoFrame
from housefly.record import ros_messages


class CameraFeed:
    """The picture of one drone, with the privacy zones blank, while somebody watches.

    In mode privacy nothing is sent, nor while nobody tells the mode although the site has tasks:
    what Foxglove shows it can keep. A late viewer begins at the next key frame.

    Args:
        bus: where the frames come from.
        server: where the channel is.
        site: as this drone has it.
        board: tells the mode of the house.
        wall: Unix time of the monotonic clock.
    """

    def __init__(
        self, bus: Bus, server: LiveServer, site: Site, board: HouseBoard, wall: WallClock
    ) -> None:
        self._bus, self._server, self._site = bus, server, site
        self._board, self._wall = board, wall
        self._topics = DroneTopics(site.drone.name)
        self._channel = drone_topic(site.drone.name, "camera")

    @property
    def feeds(self) -> tuple[Feed, ...]:
        """What fills the channel."""
        return (Feed((self._channel,), self._hear),)

    def _hear(self) -> Sequence[Subscription]:
        camera = self._site.drone.airframe.capabilities.camera
        picture = PictureFilter(LiveBlanker(self._site.tasks, camera), self._may_be_seen)

        def heard(frame: VideoFrame) -> None:
            shown = picture.shown(frame)
            if shown is not None:
                at = shown.received_at + self._wall.offset()
                message = ros_messages.compressed_video(replace(shown, received_at=at))
                self._server.send(self._channel, at, message)

        board = self._board.follow() if self._site.tasks.enabled else ()
        blanker = (
            (self._bus.subscribe(self._topics.step, picture.blanker.add_step),)
            if picture.blanker.is_needed
            else ()
        )
        return *board, *blanker, self._bus.subscribe(self._topics.video, heard)

    def _may_be_seen(self) -> tuple[bool, HouseMode | None]:
        """Return whether pictures go out, and the mode of the house for the zones."""
        if not self._site.tasks.enabled:
            return True, None
        mode = self._board.mode()
        return mode not in (None, HouseMode.PRIVACY), mode
