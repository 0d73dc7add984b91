"""One clip while it is recorded, on the writing thread: whatever the disk does, nothing raises."""

from __future__ import annotations

import logging
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import Protocol

import av

from housefly.errors import HouseflyError
from housefly.evidence.clip_index import ClipIndex
from housefly.evidence.clip_result import ClipOutcome, ClipResult
from housefly.evidence.clip_store import ClipRow
from housefly.evidence.clip_writer import (
    PART_SUFFIX,
    ClipWriter,
    duration_of,
    finish_leftover,
)
from housefly.evidence.privacy_mask import FrameToMask
from housefly.messages import VideoFrame

_LOG = logging.getLogger(__name__)


class FrameFilter(Protocol):
    """Turns pictures into those that may be kept."""

    has_blanked: bool
    """Whether anything was blanked so far."""

    def filtered(self, filmed: FrameToMask) -> VideoFrame | None:
        """Return the picture that may be kept, or None for one that may not."""
        ...


class ClipTake:
    """Writes one clip and its row; after the first fault it only says what the fault was.

    Args:
        index: of the folder.
        path: of the whole clip.
        row: what is known at the beginning.
        frame_filter: what pictures pass before they reach the disk; None keeps them as they are.
        on_result: hears what became of it.
    """

    def __init__(
        self,
        index: ClipIndex,
        path: Path,
        row: ClipRow,
        frame_filter: FrameFilter | None,
        on_result: Callable[[ClipResult], None],
    ) -> None:
        self._index, self._path, self._row = index, path, row
        self._filter, self._on_result = frame_filter, on_result
        self._writer: ClipWriter | None = None
        self._has_failed = False

    @property
    def id(self) -> str:
        """The id of the clip."""
        return self._row.id

    @property
    def has_failed(self) -> bool:
        """Whether it writes nothing any more."""
        return self._has_failed

    def add(self, filmed: FrameToMask) -> None:
        """Write a picture."""
        if self._has_failed:
            return
        try:
            self._write(filmed)
        except (OSError, av.FFmpegError, HouseflyError) as error:
            self._give_up(error)

    def finish(self) -> None:
        """Close the file, write its row and say so."""
        if self._has_failed:
            return
        try:
            clip = self._writer.finish() if self._writer is not None else None
            if clip is None:
                self._index.forget(self.id)
                self._tell(ClipOutcome.EMPTY, "no picture came from the camera: there is no clip")
                return
            self._row = replace(self._row, duration=clip.duration, size=clip.size)
            if self._filter is not None:
                self._row = replace(self._row, blanked=self._filter.has_blanked)
            self._index.finish(self._row)
            self._tell(ClipOutcome.WHOLE, f"a clip of {clip.duration:.0f} s was recorded")
        except (OSError, av.FFmpegError, HouseflyError) as error:
            self._give_up(error)

    def _write(self, filmed: FrameToMask) -> None:
        frame = filmed.frame if self._filter is None else self._filter.filtered(filmed)
        if frame is None:
            return
        if self._writer is None:
            if not frame.keyframe:
                return
            # The row comes first: a file without one would belong to nobody after a crash.
            self._index.begin(self._row)
            self._writer = ClipWriter(self._path)
        self._writer.add(frame)

    def _give_up(self, error: Exception) -> None:
        self._has_failed = True
        if self._writer is not None:
            self._writer.abandon()
        outcome = ClipOutcome.CUT_OFF if self._saved_what_there_is() else ClipOutcome.FAILED
        reason = getattr(error, "strerror", None) or str(error)
        _LOG.error("the clip %s cannot be written: %s", self._path, reason)
        self._tell(outcome, f"the clip is cut off, the flight goes on: {reason}")

    def _saved_what_there_is(self) -> bool:
        """Make a clip of what was written; where that fails too, the next start tries again."""
        if self._writer is None:
            return False
        with suppress(OSError, av.FFmpegError, HouseflyError):
            if finish_leftover(self._path.with_name(self.id + PART_SUFFIX)) is None:
                self._index.forget(self.id)
                return False
            row = replace(self._row, duration=duration_of(self._path), cut_off=True)
            blanked = self._filter is not None and self._filter.has_blanked
            size = self._path.stat().st_size
            self._index.finish(replace(row, size=size, blanked=blanked))
            return True
        return False

    def _tell(self, outcome: ClipOutcome, words: str) -> None:
        self._on_result(ClipResult(self.id, outcome, words))
