"""Waits until a run is ready to fly, and says what is missing."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from math import isfinite

from housefly.app.console_answer import console_answers
from housefly.app.machine_load import machine_load
from housefly.bus.bus import Bus, Subscription
from housefly.bus.topics import FRAME_TOPIC, LINK_TOPIC, SIGHT_TOPIC, STEP_TOPIC, VIDEO_TOPIC
from housefly.config.site import Site
from housefly.messages import LinkStatus, PilotStep, SightNews, VideoFrame


class Readiness:
    """Follows a starting run on the bus.

    Args:
        site: what is started.
        bus: its bus.
        web: whether it has a console.
        video: whether it has a picture.
        on_console: is called once the console answers.
    """

    def __init__(
        self,
        site: Site,
        bus: Bus,
        *,
        web: bool,
        video: bool,
        on_console: Callable[[], None] = lambda: None,
    ) -> None:
        self._site, self._on_console = site, on_console
        self._lock = threading.Lock()
        self._seen: set[str] = set()
        self._wanted = [
            *(["pilot"] if site.drone.enabled else []),
            *(["tracking"] if site.tracking.enabled else []),
            *(["drone"] if site.drone.enabled else []),
            *(["sensors for people"] if site.sees_people else []),
            *(["picture"] if video else []),
            *(["console"] if web else []),
        ]
        self._notes: tuple[str, ...] = ()
        self._open = [
            bus.subscribe(STEP_TOPIC, self._on_step),
            bus.subscribe(LINK_TOPIC, self._on_link),
            bus.subscribe(VIDEO_TOPIC, self._on_video),
            *([] if site.drone.enabled else self._without_pilot(bus)),
        ]

    def _without_pilot(self, bus: Bus) -> list[Subscription]:
        def on_sight(news: SightNews) -> None:
            if isfinite(news.seen_at):
                self._see("sensors for people")

        return [
            bus.subscribe(FRAME_TOPIC, lambda frame: self._see("tracking")),
            bus.subscribe(SIGHT_TOPIC, on_sight),
        ]

    def wait(
        self,
        timeout: float,
        on_missing: Callable[[str], None] = lambda text: None,
        is_hopeless: Callable[[], bool] = lambda: False,
    ) -> str:
        """Wait until everything answers; return "", or what is missing in the end.

        After a timeout it can be waited for again.

        Args:
            timeout: longest wait [s].
            on_missing: is told what is missing.
            is_hopeless: whether to wait no longer.
        """
        deadline = time.monotonic() + timeout
        while True:
            missing = self._missing()
            if not missing or (is_given_up := is_hopeless()) or time.monotonic() > deadline:
                if not missing or is_given_up:
                    for subscription in self._open:
                        subscription.close()
                return self._words(missing)
            on_missing(self._words(missing))
            time.sleep(0.05)

    def _missing(self) -> list[str]:
        if (
            "console" in self._wanted
            and "console" not in self._seen
            and console_answers(self._site)
        ):
            self._see("console")
            self._on_console()
        with self._lock:
            return [name for name in self._wanted if name not in self._seen]

    def _words(self, missing: list[str]) -> str:
        if not missing:
            return ""
        found = dict.fromkeys(filter(None, (*self._notes, machine_load().note)))
        notes = f" ({'; '.join(found)})" if found else ""
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
        if isfinite(step.inputs.people_seen_at):
            self._see("sensors for people")

    def _on_link(self, link: LinkStatus) -> None:
        self._notes = link.notes

    def _on_video(self, frame: VideoFrame) -> None:
        self._see("picture")
