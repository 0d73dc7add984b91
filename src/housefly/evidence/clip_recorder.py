"""The camera's recorder: in flight only, and on the disk only while a task asks.

The last seconds are kept in memory, in flight, so that a clip begins before its beginning. On the
ground, and when the mode of the house forbids it, they are dropped at once and a clip ends.
"""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from housefly.config.drone import DroneConfig
from housefly.config.house_mode import HouseMode, may_record
from housefly.config.tasks import TasksConfig
from housefly.errors import HouseflyError, TaskError
from housefly.evidence.camera_pose import CameraPose, CameraTrack
from housefly.evidence.clip_clock import ClockWatch
from housefly.evidence.clip_index import ClipIndex
from housefly.evidence.clip_result import ClipOrigin, ClipOutcome, ClipResult
from housefly.evidence.clip_store import ClipRow, new_clip_row
from housefly.evidence.clip_take import ClipTake
from housefly.evidence.clip_values import ClipRefusal, StartClip, TakeSnapshot
from housefly.evidence.clip_writer import CLIP_SUFFIX
from housefly.evidence.face_blur import FaceBlur, face_blur_of
from housefly.evidence.frame_blanker import FrameBlanker
from housefly.evidence.picture_lateness import PictureLateness
from housefly.evidence.privacy_mask import FrameToMask
from housefly.evidence.ring_buffer import RingBuffer
from housefly.evidence.snapshots import SNAPSHOT_SUFFIX, newest_picture, write_snapshot
from housefly.evidence.writer_thread import WriterThread
from housefly.evidence.zone_projection import zone_projectors
from housefly.messages import DroneStatus, VideoFrame
from housefly.messages.sensing import AIRBORNE_STATUSES
from housefly.room.level_camera import LevelCamera

_LOG = logging.getLogger(__name__)
_WAITING_MAX = 900
"""Pictures that may wait for the disk; then some are lost."""
_NEWS_AGE_MAX = 1.0
"""Without news of drone and mode for this long nothing is taken [s]."""
_TIDY_PERIOD = 600.0
"""How often old clips are looked for, by the monotonic clock [s]; the first time at the start."""
_FLUSH_TIMEOUT = 10.0
_BROWSER_ROUNDING = 1e-6
"""What a browser makes of a time [s]."""
_SNAPSHOT_LIGHT_TIME = 2.0
"""So long after a snapshot the light shows it [s]."""


class ClipRecorder:
    """Records clips and snapshots of one drone; thread-safe, and nobody waits for the disk.

    Args:
        folder: of the clips (``config.state.clips_folder``); made if missing, mode 0700.
        config: seconds before, how long and how much is kept, privacy zones.
        drone: whose camera it is.
        face_blur: makes what blurs faces, where ``config.blur_faces`` asks for it; None makes what
            the site names.

    Raises:
        StoreError: the index of the folder cannot be opened.

    Attributes:
        index: of the folder.
    """

    def __init__(
        self,
        folder: Path,
        config: TasksConfig,
        drone: DroneConfig,
        face_blur: Callable[[], FaceBlur] | None = None,
    ) -> None:
        self.index = ClipIndex(folder, config)
        self._folder, self._config, self._drone = folder, config, drone.name
        self._zones = zone_projectors(config, LevelCamera.of(drone.airframe.capabilities.camera))
        self._new_face_blur = face_blur or (lambda: face_blur_of(config))
        self._face_blur: FaceBlur | None = None
        self._lock = threading.RLock()
        self._ring, self._track = RingBuffer(config.clip_before), CameraTrack()
        self._lateness = PictureLateness()
        self._take: ClipTake | None = None
        self._take_ends = float("inf")
        self._is_skipping = False
        self._now, self._unix = float("-inf"), 0.0
        self._snapped_at = float("-inf")
        self._status: DroneStatus | None = None
        self._mode = HouseMode.PRIVACY
        self._tidied_at, self._clocks = float("-inf"), ClockWatch()
        self._news: list[ClipResult] = []
        self._problem = self._face_blur_problem()
        self._writer = WriterThread(_WAITING_MAX)
        self._writer.put(self._recover)

    @property
    def problem(self) -> str:
        """Why nothing would be recorded, in words, or ""; known before anybody flies."""
        return self._problem

    @property
    def is_recording(self) -> bool:
        """Whether a clip is being recorded."""
        take = self._take  # another thread may end it at any time
        return take is not None and not take.has_failed

    @property
    def shows_light(self) -> bool:
        """Whether the drone's light should show: a clip is recorded, or a snapshot just was."""
        return self.is_recording or self._now - self._snapped_at < _SNAPSHOT_LIGHT_TIME

    def tick(
        self, now: float, unix: float, status: DroneStatus | None, mode: HouseMode
    ) -> tuple[ClipResult, ...]:
        """Tell what drone and house do, and hear what became of clips; at 2 Hz or more.

        Args:
            now: the clock that stamps frames [s].
            unix: the same moment as Unix time [s].
            status: what the drone says it does; None is not known, which counts as the ground.
            mode: of the house.
        """
        with self._lock:
            self._now, self._unix, self._status, self._mode = now, unix, status, mode
            if not self._may_film(now):
                self._ring.clear()
                self._end()
            elif now > self._take_ends:
                self._end()
            if now - self._tidied_at > _TIDY_PERIOD:
                self._tidied_at = now
                self._writer.put(self._tidy)
            news, self._news = tuple(self._news), []
            return news

    def add(self, frame: VideoFrame, pose: CameraPose | None) -> None:
        """Offer a picture: to memory in flight, to the disk while a clip records.

        Args:
            frame: as it came.
            pose: the newest one of the drone when it came (``camera_pose_of``), or None.
        """
        with self._lock:
            self._track.add(pose)
            late = self._lateness.of(frame)
            if not self._may_film(frame.received_at):
                self._ring.clear()
                return
            poses = self._track.poses(frame.received_at, late)
            mask = self._zones[self._mode].mask(poses, frame.width, frame.height)
            filmed = FrameToMask(frame, mask)
            self._ring.add(filmed)
            if self._take is not None:
                self._write(self._take, filmed)

    def start(self, action: StartClip, origin: ClipOrigin) -> str:
        """Begin a clip, with the seconds before it, and return its id; one that runs ends.

        Raises:
            TaskError: NOT_READY on the ground, MODE when the mode of the house forbids it.
            MissingPartError: faces are to be blurred and what finds them is missing.
        """
        with self._lock:
            self._refuse_unless_filming()
            blanker = self._new_blanker() if self._needs_blanker() else None
            self._end()
            before = self._ring.newest_frames(min(action.before, self._config.clip_before))
            began = before[0].frame.received_at if before else self._now
            row = replace(
                new_clip_row("clip", self._unix_of(began), origin, self._drone),
                place=action.place,
                thing=action.thing,
                people=action.people,
            )
            path = self._folder / (row.id + CLIP_SUFFIX)
            self._take = ClipTake(self.index, path, row, blanker, self._tell)
            self._take_ends = self._now + self._config.clip_longest
            self._is_skipping = False
            for filmed in before:
                self._write(self._take, filmed)
            return row.id

    def stop(self) -> None:
        """End the clip, if one records."""
        with self._lock:
            self._end()

    def snapshot(self, action: TakeSnapshot, origin: ClipOrigin, at: float | None = None) -> str:
        """Keep one picture and return its id.

        Args:
            action: what is on it.
            origin: who wants it.
            at: when it came [s]; None is the newest.

        Raises:
            TaskError: NOT_READY on the ground, while no picture comes, or for one that is too old;
                MODE when the mode of the house forbids it.
            MissingPartError: faces are to be blurred and what finds them is missing.
        """
        with self._lock:
            self._refuse_unless_filming()
            frames = self._ring.newest_frames(0.0)
            if at is not None:
                frames = self._frames_shown_at(at)
            elif not frames or self._now - frames[-1].frame.received_at > _NEWS_AGE_MAX:
                raise TaskError("no picture comes from the camera", ClipRefusal.NOT_NOW.value)
            shown_at = frames[-1].frame.received_at
            row = replace(
                new_clip_row("snapshot", self._unix_of(shown_at), origin, self._drone),
                place=action.place,
                thing=action.thing,
                people=action.people,
            )
            blanker = self._new_blanker()
            self._snapped_at = self._now
            self._writer.put(lambda: self._write_snapshot(row, frames, blanker))
            return row.id

    def _frames_shown_at(self, at: float) -> tuple[FrameToMask, ...]:
        frames = self._ring.frames_until(at + _BROWSER_ROUNDING)
        if not frames or at - frames[-1].frame.received_at > _NEWS_AGE_MAX:
            raise TaskError("that picture is not in memory any more", ClipRefusal.NOT_NOW.value)
        return frames

    def flush(self, timeout: float = _FLUSH_TIMEOUT) -> bool:
        """Wait until everything is on the disk; False when it takes longer [s]."""
        return self._writer.flush(timeout)

    def close(self) -> None:
        """End the clip, write what waits and close the index."""
        self.stop()
        self._writer.close(_FLUSH_TIMEOUT)
        if self._face_blur is not None:
            self._face_blur.close()
        self.index.close()

    def _may_film(self, at: float) -> bool:
        """Return whether a picture that arrives at a time [s] may be kept in memory."""
        return (
            self._status in AIRBORNE_STATUSES
            and may_record(self._mode)
            and at - self._now <= _NEWS_AGE_MAX
        )

    def _refuse_unless_filming(self) -> None:
        if not may_record(self._mode):
            words = f"nothing is recorded in the mode {self._mode.value}"
            raise TaskError(words, ClipRefusal.MODE.value)
        if not self._may_film(self._now):
            raise TaskError("the camera records only in flight", ClipRefusal.NOT_NOW.value)

    def _needs_blanker(self) -> bool:
        return bool(self._config.privacy_zones) or self._config.blur_faces

    def _new_blanker(self) -> FrameBlanker:
        if self._config.blur_faces and self._face_blur is None:
            self._face_blur = self._new_face_blur()
        return FrameBlanker(self._face_blur)

    def _face_blur_problem(self) -> str:
        try:
            self._new_blanker()
        except HouseflyError as error:
            return f"nothing is recorded: faces are to be blurred, and {error}"
        return ""

    def _unix_of(self, at: float) -> float:
        return self._unix + at - self._now

    def _write(self, take: ClipTake, filmed: FrameToMask) -> None:
        """Hand a picture to the writing thread; after one that it cannot take, wait for a key."""
        if self._is_skipping and not filmed.frame.keyframe:
            return
        self._is_skipping = not self._writer.put(lambda: take.add(filmed), droppable=True)

    def _end(self) -> None:
        take, self._take, self._take_ends = self._take, None, float("inf")
        if take is not None:
            self._writer.put(take.finish)
            self._writer.put(self._tidy)

    def _tell(self, news: ClipResult) -> None:
        with self._lock:
            self._news.append(news)

    def _write_snapshot(
        self, row: ClipRow, frames: tuple[FrameToMask, ...], blanker: FrameBlanker
    ) -> None:
        try:
            picture = newest_picture(frames, blanker)
            if picture is None:
                words = "the picture cannot be decoded: there is no snapshot"
                self._tell(ClipResult(row.id, ClipOutcome.EMPTY, words))
                return
            size = write_snapshot(self._folder / (row.id + SNAPSHOT_SUFFIX), picture)
            self.index.finish(replace(row, size=size, blanked=blanker.has_blanked))
            self._tell(ClipResult(row.id, ClipOutcome.WHOLE, "a snapshot was taken"))
        except (OSError, HouseflyError) as error:
            reason = getattr(error, "strerror", None) or str(error)
            words = f"the snapshot cannot be kept: {reason}"
            _LOG.error("%s", words)
            self._tell(ClipResult(row.id, ClipOutcome.FAILED, words))

    def _recover(self) -> None:
        for name in self.index.recover():
            words = "what a crash left of a clip was kept"
            self._tell(ClipResult(name, ClipOutcome.CUT_OFF, words))

    def _tidy(self) -> None:
        try:
            # The recorder's own time does not follow a clock that is set back.
            now = min(self._unix, time.time())
            self.index.tidy(self._clocks.read(now, time.monotonic()))
        except (OSError, HouseflyError) as error:
            _LOG.error("old clips cannot be deleted: %s", error)
