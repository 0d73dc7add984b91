"""The live picture with the privacy zones blank: what every screen is to be fed with."""

from __future__ import annotations

import threading

from housefly.config.capabilities import OnboardCamera
from housefly.config.house_mode import HouseMode
from housefly.config.tasks import TasksConfig
from housefly.evidence.camera_pose import CameraTrack, camera_pose_of
from housefly.evidence.frame_blanker import FrameBlanker
from housefly.evidence.picture_lateness import PictureLateness
from housefly.evidence.privacy_mask import FrameToMask, PrivacyMask
from housefly.evidence.zone_projection import zone_projectors
from housefly.messages import PilotStep, VideoFrame
from housefly.room.level_camera import LevelCamera


class LiveBlanker:
    """Blanks the privacy zones in the live stream; thread-safe.

    A picture costs some milliseconds of processor time, so ``blanked_frame`` belongs on a thread of
    its own. Where a site has no zone, every frame passes as it is.

    Args:
        config: the zones of the site, with the modes of the house in which each counts.
        camera: of the drone.
        mode: of the house; until ``set_mode`` says otherwise.
    """

    def __init__(
        self,
        config: TasksConfig,
        camera: OnboardCamera | None,
        mode: HouseMode | None = None,
    ) -> None:
        self._zones = zone_projectors(config, LevelCamera.of(camera))
        self._mode = mode
        self._track, self._blanker = CameraTrack(), FrameBlanker()
        self._lateness = PictureLateness()
        self._lock = threading.Lock()

    @property
    def is_needed(self) -> bool:
        """Whether the site has zones at all."""
        return any(zones.has_zones for zones in self._zones.values())

    def set_mode(self, mode: HouseMode | None) -> None:
        """Tell the mode of the house; None, not known, makes every zone count."""
        with self._lock:
            self._mode = mode

    def add_step(self, step: PilotStep) -> None:
        """Tell where the drone is: each step of the pilot."""
        pose = camera_pose_of(step)
        with self._lock:
            self._track.add(pose)

    def blanked_frame(self, frame: VideoFrame) -> VideoFrame | None:
        """Return the frame that may be shown; None for one that cannot be decoded.

        Frames must come in order, each of them; after a gap None comes until the next key frame.
        """
        if not self.is_needed:
            return frame
        return self._blanker.filtered(FrameToMask(frame, self.mask(frame)))

    def mask(self, frame: VideoFrame) -> PrivacyMask:
        """Return what must be blank in a frame, for whoever decodes it by themselves.

        Every frame of a stream is to be asked for: how late one comes is seen from the others.
        """
        with self._lock:
            late, zones = self._lateness.of(frame), self._zones[self._mode]
            poses = self._track.poses(frame.received_at, late)
        return zones.mask(poses, frame.width, frame.height)
