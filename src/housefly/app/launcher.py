"""Starts the processes of one site, restarts those that die, and ends them in the right order: the
drone lands first.

pilot   the only one that must be on time; the others run at lower priority
twin    the simulated drone and cameras, urgent too: real ones have processors of their own; absent
    with real hardware
hub     the room's memory
broker  an MQTT broker of the run's own; absent where devices have theirs
perception  reads scanners and depth cameras and tells the pilot what is in the way; absent without them
web     the console
"""

from __future__ import annotations

import os
import subprocess
import sys
import threading
import time
from dataclasses import dataclass, field
from pathlib import Path
from types import TracebackType
from typing import IO, Self

from housefly.app.runtime import Runtime

_PILOT_EXIT_TIMEOUT = 30.0
"""How long the pilot may take to land and leave [s]."""
_RESTART_PAUSE = 0.5
"""Pause before a dead process is started again [s]."""
_POLL_PERIOD = 0.1


@dataclass(frozen=True, slots=True)
class ProcessSpec:
    """One process: its name, the module it runs with its arguments, and how much it yields to
    others.

    Less than 0 means that others yield to it; where the system does not allow that, it is as urgent
    as they are.
    """

    name: str
    module: str
    arguments: tuple[str, ...] = ()
    niceness: int = 0


def processes_of(runtime: Runtime, *, web: bool = True) -> tuple[ProcessSpec, ...]:
    """Return the processes that a site needs."""
    site = runtime.site()
    site_argument = ("--site", str(runtime.site_file))
    parts = [ProcessSpec("pilot", "housefly.app.pilot_main")]
    if site.mqtt.broker and site.mqtt.start:
        parts.append(ProcessSpec("broker", "housefly.app.broker_main", niceness=5))
    if site.twin.enabled:
        twin_arguments = (
            (*site_argument, "--bus", runtime.bus) if site.depth_cameras else site_argument
        )
        parts.append(ProcessSpec("twin", "housefly.twin.process", twin_arguments, niceness=-5))
    if site.hub.enabled:
        asked_at = ("--bus", runtime.bus, "--port", str(runtime.room_port))
        parts.append(
            ProcessSpec("hub", "housefly.hub.process", (*site_argument, *asked_at), niceness=5)
        )
    if site.lasers or site.depth_cameras:
        parts.append(ProcessSpec("perception", "housefly.app.perception_main", niceness=2))
    if web:
        parts.append(
            ProcessSpec(
                "web", "housefly.web.process", (*site_argument, "--bus", runtime.bus), niceness=5
            )
        )
    return tuple(parts)


@dataclass(slots=True)
class _Running:
    part: ProcessSpec
    process: subprocess.Popen[bytes]
    log: IO[bytes]
    restarts: int = 0


@dataclass(slots=True)
class Launcher:
    """Runs the parts of one site; use it as a context manager.

    Attributes:
        runtime: meeting points of this run.
        folder: where each part's output goes, as NAME.log.
        parts: what to run.
    """

    runtime: Runtime
    folder: Path
    parts: tuple[ProcessSpec, ...]
    _running: dict[str, _Running] = field(default_factory=dict)
    _leaving: threading.Event = field(default_factory=threading.Event)
    _lock: threading.Lock = field(default_factory=threading.Lock)
    _supervisor: threading.Thread | None = None

    def __enter__(self) -> Self:
        for part in self.parts:
            self._running[part.name] = self._start(part)
        self._supervisor = threading.Thread(target=self._supervise, name="supervisor", daemon=True)
        self._supervisor.start()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.stop()

    def pid(self, name: str) -> int:
        """Return the process id of a part."""
        with self._lock:
            return self._running[name].process.pid

    def restarts(self, name: str) -> int:
        """Return how often a part was started again."""
        with self._lock:
            return self._running[name].restarts

    def stop(self) -> None:
        """Let the pilot land and leave, then end the others."""
        self._leaving.set()
        if self._supervisor is not None:
            self._supervisor.join()
        for name in sorted(self._running, key=lambda name: name != "pilot"):
            _end(self._running[name].process, _PILOT_EXIT_TIMEOUT if name == "pilot" else 3.0)
        for running in self._running.values():
            running.log.close()
        self._running.clear()

    def abandon(self) -> None:
        """End everything at once; a flying drone is left to its own watchdog."""
        self._leaving.set()
        for running in self._running.values():
            running.process.kill()
            running.process.wait()

    def _start(self, part: ProcessSpec) -> _Running:
        log = (self.folder / f"{part.name}.log").open("ab")
        command = [
            sys.executable,
            "-m",
            "housefly.app.child",
            str(os.getpid()),
            str(part.niceness),
            part.module,
            *part.arguments,
        ]
        process = subprocess.Popen(
            command,
            env=self.runtime.environment(),
            stdin=subprocess.DEVNULL,
            stdout=log,
            stderr=subprocess.STDOUT,
            # Ctrl-C is for the launcher alone. Not a session each: kernels that group by session
            # ignore niceness between them.
            process_group=0,
        )
        return _Running(part, process, log)

    def _supervise(self) -> None:
        while not self._leaving.wait(_POLL_PERIOD):
            for name, running in list(self._running.items()):
                if running.process.poll() is None:
                    continue
                if self._leaving.wait(_RESTART_PAUSE):
                    return
                running.log.close()
                fresh = self._start(running.part)
                fresh.restarts = running.restarts + 1
                with self._lock:
                    self._running[name] = fresh


def _end(process: subprocess.Popen[bytes], patience: float) -> None:
    if process.poll() is not None:
        return
    process.terminate()
    deadline = time.monotonic() + patience
    while process.poll() is None and time.monotonic() < deadline:
        time.sleep(0.02)
    if process.poll() is None:
        process.kill()
    process.wait()
