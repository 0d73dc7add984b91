"""Whether tracking and map were found to agree in this run, for a pilot that is started again.

The drone may have landed anywhere by then. It holds for this run and this ``[tracking]`` only.
"""

from __future__ import annotations

from pathlib import Path

from housefly.config.frame_check import frames_known, tracking_digest
from housefly.config.site import Site
from housefly.messages.preflight import FrameCheckState

ORIGIN_FILE = "origin-confirmed"
_REVOKED = "tracking was found lying"


class OriginMemory:
    """What a run knows of the origin of its tracking.

    Args:
        site: whose tracking.
        folder: of the run's sockets, gone with it; None remembers nothing.

    Attributes:
        known: somebody has compared the frames, or a pilot of this run has seen the drone on its
            pad; and tracking was not found lying since.
    """

    def __init__(self, site: Site, folder: Path | None = None) -> None:
        self._digest = tracking_digest(site.tracking)
        self._file = folder / f"{ORIGIN_FILE}-{site.drone.name}" if folder else None
        noted = self._noted()
        is_right = frames_known(site).state is FrameCheckState.RIGHT and noted != _REVOKED
        self.known = is_right or noted == self._digest

    def note(self) -> None:
        """Remember that they agree; a file that cannot be written is noted the next time."""
        if not self.known and self._written(self._digest):
            self.known = True

    def revoke(self) -> None:
        """Forget it: tracking was found lying in flight."""
        if self.known:
            self.known = False
            self._written(_REVOKED)

    def _written(self, text: str) -> bool:
        if self._file is None:
            return False
        try:
            self._file.write_text(text, encoding="utf-8")
        except OSError:
            return False
        return True

    def _noted(self) -> str:
        try:
            return "" if self._file is None else self._file.read_text("utf-8")
        except (OSError, ValueError):
            return ""
