"""The room behind rosbridge: on a thread of its own, opened again when its map changes."""

from __future__ import annotations

import threading
from collections.abc import Callable
from contextlib import ExitStack

from housefly.bus.bus import Bus
from housefly.config.process_log import log_line, log_traceback
from housefly.config.ros2 import RosRequests
from housefly.errors import HouseflyError
from housefly.ros2.ros_room import RosRoom
from housefly.sites.loaded_site import LoadedSite
from housefly.web.rosbridge.topics import BridgeTopics

_RETRY_PERIOD = 2.0
"""A room that cannot be opened is tried again after this [s]."""
_LEAVING_MAX = 0.5
"""So long the end of the console waits for it [s]."""


class BridgeRoom:
    """Tells the room to clients of rosbridge.

    Args:
        bus: of the run.
        opened: opens the site as it is flown now.
        edition: changes when that does.
        requests: what the site lets clients ask for.
        origins: pages of other servers that may use it.

    Attributes:
        topics: what is told.
        room: None until it is open.
    """

    def __init__(
        self,
        bus: Bus,
        opened: Callable[[], LoadedSite],
        edition: Callable[[], object] = lambda: None,
        requests: RosRequests = "ask",
        origins: tuple[str, ...] = (),
    ) -> None:
        self._bus, self._opened, self._edition = bus, opened, edition
        self.requests, self.origins = requests, frozenset(origins)
        self.topics = BridgeTopics()
        self.room: RosRoom | None = None
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._run, name="rosbridge room", daemon=True)

    def begin(self) -> None:
        """Open the room."""
        self._thread.start()

    def close(self) -> None:
        """Tell nothing more."""
        self._ended.set()
        if self._thread.is_alive():
            self._thread.join(timeout=_LEAVING_MAX)

    def _run(self) -> None:
        while not self._ended.is_set():
            try:
                self._tell()
            except HouseflyError as error:
                log_line(f"rosbridge: {error}")
                self._ended.wait(_RETRY_PERIOD)
            except Exception:  # the console stays
                log_traceback()
                self._ended.wait(_RETRY_PERIOD)

    def _tell(self) -> None:
        """Tell until the end, or until the room has changed."""
        edition = self._edition()

        def ended(seconds: float) -> bool:
            return self._ended.wait(seconds) or self._edition() != edition

        with ExitStack() as stack:
            room = RosRoom(self._opened(), self._bus, self.topics)
            room.begin(stack)
            self.room = room
            room.look(ended)
