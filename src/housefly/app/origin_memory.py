"""Whether tracking and map were found to agree in this run, for a pilot that is started again.

The drone may have landed anywhere by then. It holds for this run and this ``[tracking]`` only.
"""

from __future__ import annotations

from pathlib import Path

from housefly.config.frame_check import frames_known, tracking_digest
from housefly.config.site import Site
from housefly.messages.preflight import FrameCheckState

ORIGIN_FILE = "origin-confirmed"


class OriginMemory:
    """What a run knows of the origin of its tracking.

    Args:
        site: whose tracking.
        folder: of the run's sockets, gone with it; None remembers nothing.

    Attributes:
        known: somebody has compared the frames, or a pilot of this run has seen the drone on its
            pad.
    """

    def __init__(self, site: Site, folder: Path | None = None) -> None:
        self._digest = tracking_digest(site.tracking)
        self._file = folder / ORIGIN_FILE if folder else None
        self.known = frames_known(site).state is FrameCheckState.RIGHT or self._was_noted()

    def note(self) -> None:
        """Remember that they agree; a file that cannot be written is noted the next time."""
        if self.known or self._file is None:
            return
        try:
            self._file.write_text(self._digest, encoding="utf-8")
        except OSError:
            return
        self.known = True

    def _was_noted(self) -> bool:
        try:
            return self._file is not None and self._file.read_text("utf-8") == self._digest
        except (OSError, ValueError):
            return False
