"""The drone's camera for ROS: what the console may show, as it came and as JPEG."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from io import BytesIO

from PIL import Image

from housefly.config.capabilities import OnboardCamera
from housefly.config.house_mode import HouseMode
from housefly.evidence.live_blanker import LiveBlanker
from housefly.evidence.picture_codec import PictureDecoder
from housefly.evidence.picture_filter import PictureFilter
from housefly.messages import PilotStep, VideoFrame
from housefly.ros2.carrier import RosCarrier
from housefly.ros2.drone_messages import RosFrames, camera_info, compressed_image
from housefly.ros2.topic_table import CAMERA_INFO, H264, PICTURES, RosTopic

_JPEG_QUALITY = 80


class RosCamera:
    """Publishes pictures while somebody subscribes; in mode privacy none.

    Args:
        carrier: of the room.
        camera: of the drone.
        frames: of the drone.
        blanker: blanks the privacy zones, as it does for the console.
        names: full names of each topic.
    """

    def __init__(
        self,
        carrier: RosCarrier,
        camera: OnboardCamera,
        frames: RosFrames,
        blanker: LiveBlanker,
        names: Mapping[RosTopic, tuple[str, ...]],
    ) -> None:
        self._carrier, self._camera, self._frames = carrier, camera, frames
        self._names, self._decoder = names, PictureDecoder()
        self._mode: HouseMode | None = None
        self._filter = PictureFilter(blanker, self._may_be_seen)

    def set_mode(self, mode: HouseMode | None) -> None:
        """Tell the mode of the house; None, not known, shows nothing."""
        self._mode = mode

    def add_step(self, step: PilotStep) -> None:
        """Tell where the drone is."""
        if self._filter.blanker.is_needed:
            self._filter.blanker.add_step(step)

    def show(self, frame: VideoFrame, offset: float) -> None:
        """Publish a picture.

        Args:
            frame: as the drone sent it.
            offset: Unix time at which its clock was zero [s].
        """
        if not self._is_watched():
            self._filter.miss()
            return
        shown = self._filter.shown(frame)
        if shown is None:
            return
        at, frames = frame.received_at + offset, self._frames
        self._publish(CAMERA_INFO, partial(camera_info, at, frames, self._camera, shown))
        self._publish(H264, partial(compressed_image, at, frames, "h264", shown.data))
        if self._is_heard(PICTURES) and (data := self._jpeg(shown)):
            self._publish(PICTURES, partial(compressed_image, at, frames, "jpeg", data))

    def _may_be_seen(self) -> tuple[bool, HouseMode | None]:
        return self._mode not in (None, HouseMode.PRIVACY), self._mode

    def _is_watched(self) -> bool:
        return any(self._is_heard(topic) for topic in self._names)

    def _is_heard(self, topic: RosTopic) -> bool:
        return any(self._carrier.is_heard(name) for name in self._names[topic])

    def _publish(self, topic: RosTopic, make: partial[object]) -> None:
        for name in self._names[topic]:
            self._carrier.publish(topic, name, make)

    def _jpeg(self, frame: VideoFrame) -> bytes:
        picture = self._decoder.decode(frame)
        if picture is None:
            return b""
        buffer = BytesIO()
        Image.fromarray(picture).save(buffer, "JPEG", quality=_JPEG_QUALITY)
        return buffer.getvalue()
