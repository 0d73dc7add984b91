"""Waits until a run is ready to fly, and says what is missing."""

from __future__ import annotations

import socket
import threading
import time
from collections.abc import Callable

from housefly.bus.bus import Bus
from housefly.bus.topics import LINK_TOPIC, STEP_TOPIC, VIDEO_TOPIC
from housefly.config.site import Site
from housefly.messages import LinkStatus, PilotStep, VideoFrame


class Readiness:
    """Follows a starting run on the bus."""

    def __init__(self, site: Site, bus: Bus, *, web: bool, video: bool) -> None:
        self._site = site
        self._lock = threading.Lock()
        self._seen: set[str] = set()
        self._wanted = [
            "pilot",
            "tracking",
            "drone",
            *(["picture"] if video else []),
            *(["console"] if web else []),
        ]
        self._notes: tuple[str, ...] = ()
        self._open = [
            bus.subscribe(STEP_TOPIC, self._on_step),
            bus.subscribe(LINK_TOPIC, self._on_link),
            bus.subscribe(VIDEO_TOPIC, self._on_video),
        ]

    def wait(
        self,
        timeout: float,
        on_missing: Callable[[str], None] = lambda text: None,
        is_hopeless: Callable[[], bool] = lambda: False,
    ) -> str:
        """Wait until everything answers; return "", or what is missing in the end.

        Args:
            timeout: longest wait [s].
            on_missing: is told what is missing.
            is_hopeless: whether to wait no longer.
        """
        deadline = time.monotonic() + timeout
        while True:
            missing = self._missing()
            if not missing or time.monotonic() > deadline or is_hopeless():
                for subscription in self._open:
                    subscription.close()
                return self._words(missing)
            on_missing(self._words(missing))
            time.sleep(0.05)

    def _missing(self) -> list[str]:
        if (
            "console" in self._wanted
            and "console" not in self._seen
            and _listens(self._site.web.host, self._site.web.port)
        ):
            self._see("console")
        with self._lock:
            return [name for name in self._wanted if name not in self._seen]

    def _words(self, missing: list[str]) -> str:
        if not missing:
            return ""
        notes = f" ({'; '.join(self._notes)})" if self._notes else ""
        return f"waiting for {', '.join(missing)}{notes}"

    def _see(self, name: str) -> None:
        with self._lock:
            self._seen.add(name)

    def _on_step(self, step: PilotStep) -> None:
        self._see("pilot")
        if step.outputs.estimate is not None:
            self._see("tracking")
        if step.inputs.telemetry is not None:
            self._see("drone")

    def _on_link(self, link: LinkStatus) -> None:
        self._notes = link.notes

    def _on_video(self, frame: VideoFrame) -> None:
        self._see("picture")


def _listens(host: str, port: int) -> bool:
    try:
        with socket.create_connection((host, port), timeout=0.2):
            return True
    except OSError:
        return False
