"""Starts the processes of one site, restarts those that die, and lands the drone before it ends.

pilot       the only one that must be on time; the others run at lower priority
twin        the simulated drone and cameras, nearly as urgent; absent with real hardware
hub         the room's memory
broker      an MQTT broker; absent where the devices have their own
perception  finds obstacles in scans and depth images; absent without such sensors
web         the console
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
"""Longest time for the pilot to land and end [s]."""
_RESTART_PAUSE = 0.5
"""Pause before a dead process is started again [s]."""
_POLL_PERIOD = 0.1


@dataclass(frozen=True, slots=True)
class ProcessSpec:
    """One process: its name, the module that it runs, its arguments and its nice value.

    A nice value below 0 counts as 0 where the system does not allow it.
    """

    name: str
    module: str
    arguments: tuple[str, ...] = ()
    niceness: int = 0


def processes_of(runtime: Runtime, *, web: bool = True) -> tuple[ProcessSpec, ...]:
    """Return the processes that a site needs."""
    site = runtime.site()
    site_argument = ("--site", str(runtime.site_file))
    processes = [ProcessSpec("pilot", "housefly.app.pilot_main")]
    if site.mqtt.broker and site.mqtt.start:
        processes.append(ProcessSpec("broker", "housefly.app.broker_main", niceness=5))
    if site.twin.enabled:
        twin_arguments = (
            (*site_argument, "--bus", runtime.bus) if site.depth_cameras else site_argument
        )
        processes.append(ProcessSpec("twin", "housefly.twin.process", twin_arguments, niceness=-5))
    if site.hub.enabled:
        asked_at = ("--bus", runtime.bus, "--port", str(runtime.room_port))
        processes.append(
            ProcessSpec("hub", "housefly.hub.process", (*site_argument, *asked_at), niceness=5)
        )
    if site.lasers or site.depth_cameras:
        processes.append(ProcessSpec("perception", "housefly.app.perception_main", niceness=2))
    if web:
        processes.append(
            ProcessSpec(
                "web", "housefly.web.process", (*site_argument, "--bus", runtime.bus), niceness=5
            )
        )
    return tuple(processes)


@dataclass(slots=True)
class _Running:
    spec: ProcessSpec
    process: subprocess.Popen[bytes]
    log: IO[bytes]
    restarts: int = 0


@dataclass(slots=True)
class Launcher:
    """Runs the processes of one site; use it as a context manager.

    Attributes:
        runtime: endpoints and secrets of this run.
        folder: where the output of each process goes, as NAME.log.
        processes: what to run.
    """

    runtime: Runtime
    folder: Path
    processes: tuple[ProcessSpec, ...]
    _running: dict[str, _Running] = field(default_factory=dict)
    _leaving: threading.Event = field(default_factory=threading.Event)
    _lock: threading.Lock = field(default_factory=threading.Lock)
    _supervisor: threading.Thread | None = None

    def __enter__(self) -> Self:
        for spec in self.processes:
            self._running[spec.name] = self._start(spec)
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
        """Return the process id by a process's name."""
        with self._lock:
            return self._running[name].process.pid

    def restarts(self, name: str) -> int:
        """Return how often a process was restarted."""
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

    def _start(self, spec: ProcessSpec) -> _Running:
        log = (self.folder / f"{spec.name}.log").open("ab")
        command = [
            sys.executable,
            "-m",
            "housefly.app.child",
            str(os.getpid()),
            str(spec.niceness),
            spec.module,
            *spec.arguments,
        ]
        process = subprocess.Popen(
            command,
            env=self.runtime.environment(),
            stdin=subprocess.DEVNULL,
            stdout=log,
            stderr=subprocess.STDOUT,
            # Ctrl-C is for the launcher alone. No new sessions: kernels that group processes by
            # session ignore their nice values.
            process_group=0,
        )
        return _Running(spec, process, log)

    def _supervise(self) -> None:
        while not self._leaving.wait(_POLL_PERIOD):
            for name, running in list(self._running.items()):
                if running.process.poll() is None:
                    continue
                if self._leaving.wait(_RESTART_PAUSE):
                    return
                running.log.close()
                fresh = self._start(running.spec)
                fresh.restarts = running.restarts + 1
                with self._lock:
                    self._running[name] = fresh


def _end(process: subprocess.Popen[bytes], timeout: float) -> None:
    if process.poll() is not None:
        return
    process.terminate()
    deadline = time.monotonic() + timeout
    while process.poll() is None and time.monotonic() < deadline:
        time.sleep(0.02)
    if process.poll() is None:
        process.kill()
    process.wait()
