"""The picture of a flight for Home Assistant: rare, and never more than the console shows."""

from __future__ import annotations

import threading
from collections.abc import Callable

from housefly.clock import Clock
from housefly.config.capabilities import OnboardCamera
from housefly.config.house_mode import HouseMode, may_record
from housefly.config.tasks import TasksConfig
from housefly.evidence.frame_blanker import FrameBlanker
from housefly.evidence.live_blanker import LiveBlanker
from housefly.evidence.privacy_mask import FrameToMask
from housefly.homeassistant.drone_state import is_flying
from housefly.homeassistant.jpeg import blank_jpeg, jpeg_of
from housefly.messages import PilotStep, VideoFrame

PICTURE_PERIOD = 0.5
"""Shortest time between two pictures [s]; only key frames are shown, so it is often longer."""
_STEP_AGE_MAX = 1.0
"""Who was not heard for longer is not known to fly [s]."""


class LiveCamera:
    """Makes pictures of a drone's key frames; thread-safe.

    It shows nothing on the ground, in a mode that records nothing, and while nobody knows the mode:
    Home Assistant keeps the last picture, so it is then given a blank one.

    Args:
        config: the privacy zones, with the modes in which each counts.
        camera: of the drone.
        mode: tells the mode of the house, None while nobody knows.
        show: sends a JPEG; must return at once, for no other is sent meanwhile.
        clock: for the rate.
    """

    def __init__(
        self,
        config: TasksConfig,
        camera: OnboardCamera | None,
        mode: Callable[[], HouseMode | None],
        show: Callable[[bytes], None],
        clock: Clock,
    ) -> None:
        self._blanker, self._pictures = LiveBlanker(config, camera), FrameBlanker()
        self._mode, self._show, self._clock = mode, show, clock
        self._lock = threading.Lock()
        self._flew_at = self._shown_at = float("-inf")
        self._shows = False

    def add_step(self, step: PilotStep) -> None:
        """Tell where the drone is: each step of its pilot."""
        self._blanker.add_step(step)
        self._flew_at = self._clock.now() if is_flying(step) else float("-inf")

    def add_frame(self, frame: VideoFrame) -> None:
        """Show a frame where that is allowed; frames come in order, each of them."""
        mode, now = self._mode(), self._clock.now()
        with self._lock:
            self._blanker.set_mode(mode)
            mask = self._blanker.mask(frame)
            is_due = frame.keyframe and now - self._shown_at >= PICTURE_PERIOD
            if not is_due or not self._may_show(mode):
                return
            picture = self._pictures.picture(FrameToMask(frame, mask))
            if picture is not None and (jpeg := jpeg_of(picture)):
                self._shown_at, self._shows = now, True
                self._show(jpeg)

    def look_at_end(self) -> None:
        """Show a blank picture once, when what was shown last must not be seen any more."""
        with self._lock:
            if self._shows and not self._may_show(self._mode()):
                self._shows = False
                self._show(blank_jpeg())

    def _may_show(self, mode: HouseMode | None) -> bool:
        flies = self._clock.now() - self._flew_at <= _STEP_AGE_MAX
        return flies and mode is not None and may_record(mode)
