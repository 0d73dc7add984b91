"""Starts the processes of one site, restarts those that die, and lands the drone before it ends.

room        the bus, and the tracking system; as urgent as the pilot
pilot       the only one that must be on time; the others run at lower priority
driver      the drone's wires and the watchdog over the pilot; the last to leave
            (with several drones, each has a pilot-NAME and a driver-NAME)
twin        the simulated drone and cameras, nearly as urgent; absent with real hardware
hub         the room's memory
broker      an MQTT broker; absent where the devices have their own
perception  finds obstacles in scans and depth images; absent without such sensors
tasks       services: queue, rules, clips; gives the pilot orders as people do
homeassistant  shows the room in Home Assistant; absent unless the site wants it
web         the console
ros2        the room as a ROS 2 node
foxglove    the live view in Foxglove; absent where the site does not ask for it
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from enum import Enum
from pathlib import Path
from types import TracebackType
from typing import IO, Self

from housefly.app.child import RENEW_SIGNAL
from housefly.app.liveness import RunLiveness
from housefly.app.restart_policy import Death, last_words, restart_after
from housefly.app.runtime import Runtime
from housefly.config.site import Site
from housefly.web.console_port import ConsolePort

_LANDING_TIMEOUT = 30.0
"""Longest wait for a process that lands the drone [s]."""
_EXIT_TIMEOUT = 3.0
"""Longest wait for the others, once the drone is down [s]."""
_RENEWAL_TIMEOUT = 5.0
"""Longest wait for a process that is to be started anew [s]; one that lands is never killed."""
_POLL_PERIOD = 0.1


class Landing(Enum):
    """When a process that brings a drone down is told to: LAST is where FIRST could not."""

    FIRST = "first"
    LAST = "last"


@dataclass(frozen=True, slots=True)
class ProcessSpec:
    """One process of a run.

    Attributes:
        name, module, arguments: what it is called, and what it runs.
        niceness: below 0 it counts as 0 where the system does not allow it.
        lands: whether it brings a drone down before it ends, and when it is told to end: FIRST,
            then LAST, then all others. What is LAST is never killed.
        port: where it listens; it alone inherits the socket, which the launcher keeps to the end.
    """

    name: str
    module: str
    arguments: tuple[str, ...] = ()
    niceness: int = 0
    lands: Landing | None = None
    port: ConsolePort | None = None

    @property
    def inherited(self) -> tuple[int, ...]:
        """The file descriptors that are passed to it alone."""
        return () if self.port is None else (self.port.descriptor,)


def driver_process(site: Site, drone: str) -> ProcessSpec:
    """Return the process of a drone's driver; whoever pilots, it is one of its own."""
    return ProcessSpec(
        _named(site, "driver", drone),
        "housefly.app.driver_main",
        ("--drone", drone),
        niceness=-5,
        lands=Landing.LAST,
    )


def pilot_process(site: Site, drone: str) -> ProcessSpec:
    """Return the process of a drone's pilot."""
    return ProcessSpec(
        _named(site, "pilot", drone),
        "housefly.app.pilot_main",
        ("--drone", drone),
        lands=Landing.FIRST,
    )


def _named(site: Site, role: str, drone: str) -> str:
    return f"{role}-{drone}" if len(site.drone_names) > 1 else role


def processes_of(runtime: Runtime, *, truth_file: Path | None = None) -> tuple[ProcessSpec, ...]:
    """Return the processes that a site needs.

    Args:
        runtime: of the site; the console is among them where its port is held.
        truth_file: where a simulated room writes the true course of what flies; None writes none.
    """
    site = runtime.site()
    site_argument = ("--site", str(runtime.site_file))
    processes = [ProcessSpec("room", "housefly.app.room_main")]
    processes += [pilot_process(site, name) for name in site.drone_names]
    processes += [driver_process(site, name) for name in site.drone_names]
    if site.mqtt.broker and site.mqtt.start:
        processes.append(ProcessSpec("broker", "housefly.app.broker_main", niceness=5))
    if site.twin.enabled:
        has_bus = runtime.has_console or site.depth_cameras
        twin_arguments = (*site_argument, "--bus", runtime.bus) if has_bus else site_argument
        if truth_file is not None:
            twin_arguments = (*twin_arguments, "--truth", str(truth_file.resolve()))
        processes.append(ProcessSpec("twin", "housefly.twin.process", twin_arguments, niceness=-5))
    if site.hub.enabled:
        asked_at = ("--bus", runtime.bus, "--socket", str(runtime.room_socket))
        processes.append(
            ProcessSpec("hub", "housefly.hub.process", (*site_argument, *asked_at), niceness=5)
        )
    if site.lasers or site.depth_cameras:
        processes.append(ProcessSpec("perception", "housefly.app.perception_main"))
    if site.tasks.enabled:
        processes.append(ProcessSpec("tasks", "housefly.app.tasks_main", niceness=3))
    if site.ros2.enabled:
        joins = (*site_argument, "--bus", runtime.bus)
        processes.append(ProcessSpec("ros2", "housefly.ros2.process", joins, niceness=5))
    if site.homeassistant.enabled:
        shown_by = (*site_argument, "--bus", runtime.bus)
        processes.append(
            ProcessSpec("homeassistant", "housefly.homeassistant.process", shown_by, niceness=5)
        )
    if (port := runtime.console_port) is not None:
        listens_at = ("--bus", runtime.bus, "--listener", str(port.descriptor))
        processes.append(
            ProcessSpec(
                "web", "housefly.web.process", (*site_argument, *listens_at), niceness=5, port=port
            )
        )
    if site.foxglove.enabled:
        listens = (*site_argument, "--bus", runtime.bus)
        processes.append(ProcessSpec("foxglove", "housefly.foxglove.process", listens, niceness=10))
    return tuple(processes)


@dataclass(slots=True)
class _Running:
    spec: ProcessSpec
    process: subprocess.Popen[bytes]
    log: IO[bytes]
    log_start: int
    started_at: float = field(default_factory=time.monotonic)
    restarts: int = 0
    failures: int = 0
    due_at: float | None = None
    is_given_up: bool = False


@dataclass(frozen=True, slots=True)
class _Renewal:
    names: tuple[str, ...]
    due_at: float
    begin: Callable[[], bool]


@dataclass(slots=True)
class Launcher:
    """Runs the processes of one site; use it as a context manager.

    Attributes:
        runtime: endpoints and secrets of this run.
        folder: where the output of each process goes, as NAME.log.
        processes: what to run.
        is_impatient: whether nobody wants to wait for the landing any longer; asked at the end.
    """

    runtime: Runtime
    folder: Path
    processes: tuple[ProcessSpec, ...]
    is_impatient: Callable[[], bool] = lambda: False
    _running: dict[str, _Running] = field(default_factory=dict)
    _deaths: list[Death] = field(default_factory=list)
    _liveness: RunLiveness = field(default_factory=RunLiveness)
    _renewal: _Renewal | None = None
    _leaving: threading.Event = field(default_factory=threading.Event)
    _lock: threading.Lock = field(default_factory=threading.Lock)
    _supervisor: threading.Thread | None = None

    def __enter__(self) -> Self:
        try:
            for spec in self.processes:
                self._running[spec.name] = self._start(spec)
        except BaseException:
            self.stop()
            raise
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

    @property
    def is_renewing(self) -> bool:
        """Whether processes are about to be started anew."""
        with self._lock:
            return self._renewal is not None

    def renew(self, names: tuple[str, ...], pause: float, begin: Callable[[], bool]) -> None:
        """End processes in order soon, each in its own way, and start them anew at once.

        Args:
            names: those that there are; one that lands the drone ends only when it is down.
            pause: before it begins [s].
            begin: called just before; False leaves everything as it is.
        """
        with self._lock:
            self._renewal = _Renewal(names, time.monotonic() + pause, begin)

    @property
    def deaths(self) -> tuple[Death, ...]:
        """All deaths so far, the oldest first."""
        with self._lock:
            return tuple(self._deaths)

    @property
    def given_up(self) -> tuple[Death, ...]:
        """Those processes that cannot start and are not tried again."""
        return tuple(death for death in self.deaths if death.given_up)

    def stop(self) -> tuple[str, ...]:
        """Let the drone land, then end everything; a second call does nothing.

        Returns:
            The processes that still land the drone, because nobody wanted to wait or because it
            takes too long. They, and all that they need, end by themselves when it is down.
        """
        self._leaving.set()
        if self._supervisor is not None:
            self._supervisor.join()
        try:
            left = [*self._land(Landing.FIRST), *self._land(Landing.LAST)]
        finally:
            self._liveness.close()
        if not left:
            others = [running.process for running in self._running.values()]
            for process in others:
                process.terminate()
            _end_all(others)
        for running in self._running.values():
            running.log.close()
        for spec in self.processes:
            if spec.port is not None:
                spec.port.close()
        self._running.clear()
        return tuple(left)

    def _land(self, turn: Landing) -> list[str]:
        """Tell all whose turn it is to land and end; return who is left to itself."""
        landing = {
            running.spec.name: running.process
            for running in self._running.values()
            if running.spec.lands is turn
        }
        for process in landing.values():
            if process.poll() is None:
                process.terminate()
        deadline = time.monotonic() + _LANDING_TIMEOUT
        while left := [name for name, process in landing.items() if process.poll() is None]:
            if self.is_impatient():
                return left
            if time.monotonic() > deadline:
                if turn is Landing.LAST:
                    return left
                for name in left:
                    landing[name].kill()
                    landing[name].wait()
            time.sleep(0.02)
        return []

    def _start(self, spec: ProcessSpec) -> _Running:
        path = self.folder / f"{spec.name}.log"
        # Whoever reads a log knows what people do here.
        log = os.fdopen(os.open(path, os.O_WRONLY | os.O_APPEND | os.O_CREAT, 0o600), "ab")
        descriptors = self._liveness.descriptors(lands=spec.lands is not None)
        numbers = (os.getpid(), spec.niceness, descriptors.watched, descriptors.held)
        command = [
            *(sys.executable, "-m", "housefly.app.child"),
            *map(str, numbers),
            spec.module,
            *spec.arguments,
        ]
        process = subprocess.Popen(
            command,
            env=self.runtime.environment(),
            stdin=subprocess.DEVNULL,
            stdout=log,
            stderr=subprocess.STDOUT,
            pass_fds=(*descriptors.inherited, *spec.inherited),
            # Ctrl-C and a closed terminal are for the launcher alone. No new sessions: kernels that
            # group processes by session ignore their nice values.
            process_group=0,
        )
        return _Running(spec, process, log, log_start=log.tell())

    def _supervise(self) -> None:
        while not self._leaving.wait(_POLL_PERIOD):
            if (renewal := self._renewal) is not None and time.monotonic() >= renewal.due_at:
                self._renew(renewal)
            for running in list(self._running.values()):
                if running.process.poll() is None or running.is_given_up:
                    continue
                if running.due_at is None:
                    self._note_death(running)
                elif time.monotonic() >= running.due_at:
                    self._restart(running)

    def _renew(self, renewal: _Renewal) -> None:
        try:
            if renewal.begin():
                for running in [self._running.get(name) for name in renewal.names]:
                    if running is not None and _has_ended(running):
                        self._start_anew(running)
        finally:
            with self._lock:
                self._renewal = None

    def _start_anew(self, running: _Running) -> None:
        """Start a process that was told to end; where that fails, it counts as one that died."""
        try:
            fresh = self._start(running.spec)
        except OSError:
            return
        running.log.close()
        fresh.restarts = running.restarts
        with self._lock:
            self._running[running.spec.name] = fresh

    def _note_death(self, running: _Running) -> None:
        now, log = time.monotonic(), self.folder / f"{running.spec.name}.log"
        restart = restart_after(
            running.process.returncode, now - running.started_at, running.failures
        )
        running.failures = restart.failures
        running.is_given_up = restart.pause is None
        running.due_at = now + (restart.pause or 0.0)
        if running.is_given_up:
            self._tell(Death(running.spec.name, True, last_words(log, running.log_start), log))

    def _restart(self, running: _Running) -> None:
        running.log.close()
        log = self.folder / f"{running.spec.name}.log"
        words = last_words(log, running.log_start)
        try:
            fresh = self._start(running.spec)
        except OSError:  # no memory, no disk: later
            running.due_at = time.monotonic() + 1.0
            return
        fresh.restarts, fresh.failures = running.restarts + 1, running.failures
        with self._lock:
            self._running[running.spec.name] = fresh
        self._tell(Death(running.spec.name, False, words, log))

    def _tell(self, death: Death) -> None:
        with self._lock:
            self._deaths.append(death)


def _has_ended(running: _Running) -> bool:
    """End a process to start it anew; return whether it has."""
    process, lands = running.process, running.spec.lands
    if process.poll() is None:
        process.send_signal(signal.SIGTERM if lands else RENEW_SIGNAL)
    deadline = time.monotonic() + _RENEWAL_TIMEOUT
    while process.poll() is None and time.monotonic() < deadline:
        time.sleep(0.02)
    if process.poll() is None and not lands:
        process.kill()
        process.wait()
    return process.poll() is not None


def _end_all(processes: list[subprocess.Popen[bytes]]) -> None:
    """Wait until processes that were told to end are gone; kill those that do not."""
    deadline = time.monotonic() + _EXIT_TIMEOUT
    while time.monotonic() < deadline and any(process.poll() is None for process in processes):
        time.sleep(0.02)
    for process in processes:
        process.kill()
        process.wait()
