"""Waits until a run is ready to fly, and says what is missing."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from contextlib import suppress
from math import isfinite

from housefly.app.console_answer import console_answers
from housefly.app.machine_load import machine_load
from housefly.bus.bus import Bus, Subscription
from housefly.bus.topics import FRAME_TOPIC, HUB_QUERY, SIGHT_TOPIC, TASKS_QUERY, DroneTopics
from housefly.config.site import Site
from housefly.errors import LinkError
from housefly.hub.api.json import question_to_json
from housefly.hub.api.questions import PeopleQuestion
from housefly.messages import LinkStatus, PilotStep, SightNews
from housefly.tasks.api.json import task_question_to_json
from housefly.tasks.api.questions import BoardQuestion

_MEMORY, _TASKS = "memory", "tasks"
_ASKED = {
    _MEMORY: (HUB_QUERY, question_to_json(PeopleQuestion())),
    _TASKS: (TASKS_QUERY, task_question_to_json(BoardQuestion())),
}
"""What is asked of those who are ready when they answer."""
_ASKING_PATIENCE = 1.0
"""Longest wait for one answer [s]."""


class Readiness:
    """Follows a starting run on the bus.

    Args:
        site: what is started.
        bus: its bus.
        web: whether it has a console; then the memory and the tasks, which people ask there, are
            waited for, too.
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
        self._site, self._bus, self._on_console = site, bus, on_console
        self._lock = threading.Lock()
        self._seen: set[str] = set()
        names = site.drone_names
        several = len(names) > 1
        self._of = {name: f" of {name}" if several else "" for name in names or (site.drone.name,)}
        each = [self._of[name] for name in names]
        self._wanted = [
            *(f"pilot{of}" for of in each),
            *(["tracking"] if site.tracking.enabled else []),
            *(f"drone{of}" for of in each),
            *(["sensors for people"] if site.sees_people else []),
            *(f"picture{self._of[name]}" for name in self._with_picture(video)),
            *([_MEMORY] if web and site.hub.enabled else []),
            *([_TASKS] if web and site.tasks.enabled else []),
            *(["console"] if web else []),
        ]
        self._notes: dict[str, tuple[str, ...]] = {}
        self._open = [
            *(one for name, of in self._of.items() for one in self._of_drone(bus, name, of)),
            *([] if names else self._without_pilot(bus)),
        ]

    def _with_picture(self, video: bool) -> list[str]:
        names = self._site.drone_names if video else ()
        return [name for name in names if self._site.for_drone(name).has_picture]

    def _of_drone(self, bus: Bus, name: str, of: str) -> list[Subscription]:
        def on_link(link: LinkStatus) -> None:
            self._notes = self._notes | {name: link.notes}

        topics = DroneTopics(name)
        return [
            bus.subscribe(topics.step, lambda step: self._on_step(step, of)),
            bus.subscribe(topics.link, on_link),
            bus.subscribe(topics.video, lambda _: self._see(f"picture{of}")),
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
        missing = self._unseen()
        # Asked last: they answer slowly while everything else still starts.
        if missing and all(name in _ASKED for name in missing):
            for name in missing:
                self._ask(name)
            return self._unseen()
        return missing

    def _ask(self, name: str) -> None:
        query, question = _ASKED[name]
        with suppress(LinkError):
            self._bus.ask(query, question, _ASKING_PATIENCE)
            self._see(name)

    def _unseen(self) -> list[str]:
        with self._lock:
            return [name for name in self._wanted if name not in self._seen]

    def _words(self, missing: list[str]) -> str:
        if not missing:
            return ""
        notes = (note for each in self._notes.values() for note in each)
        found = dict.fromkeys(filter(None, (*notes, machine_load().note)))
        more = f" ({'; '.join(found)})" if found else ""
        return f"waiting for {', '.join(missing)}{more}"

    def _see(self, name: str) -> None:
        with self._lock:
            self._seen.add(name)

    def _on_step(self, step: PilotStep, of: str) -> None:
        self._see(f"pilot{of}")
        if step.outputs.estimate is not None:
            self._see("tracking")
        if step.inputs.telemetry is not None:
            self._see(f"drone{of}")
        if isfinite(step.inputs.people_seen_at):
            self._see("sensors for people")
