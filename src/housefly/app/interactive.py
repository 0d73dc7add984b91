"""Runs everything for people at the console, until Ctrl-C."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from contextlib import ExitStack, suppress
from dataclasses import replace
from pathlib import Path

from housefly.app.console_addresses import ConsoleAddresses
from housefly.app.console_answer import console_answers
from housefly.app.end_signals import EndSignals
from housefly.app.launcher import Launcher, processes_of
from housefly.app.new_runtime import discovery_entry, new_runtime
from housefly.app.people_note import people_note
from housefly.app.ports import refuse_taken_ports
from housefly.app.readiness import Readiness
from housefly.app.room_renewal import RoomRenewal
from housefly.app.runtime import Runtime
from housefly.app.terminal import console
from housefly.app.truth_files import take_truth
from housefly.bus.bus import Bus
from housefly.bus.topics import USE_EDITS_QUERY, DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.config.site import Site
from housefly.hub.client.discovery import announced
from housefly.hub.store.lock import reserved_store
from housefly.record.recorder import FlightRecorder
from housefly.sites.loaded_site import LoadedSite
from housefly.web.access.exposure import checked_exposure

_READY_TIMEOUT = 60.0
"""After this time the start says what is missing [s]; the run goes on without it."""


_WISHES = 2
"""So many wishes to use edits are answered at once: a second one hears that there is a first."""


_ASK = "Open the address and ask for something, or ring the doorbell there."
_FLY = "Open the address, choose a place, hold the button."
_NO_FLIGHT = "Open the address: who and what is where, and what happened. Ctrl-C ends."


class _Teller:
    """Prints each death of a process once, and where the console is when it answers."""

    def __init__(self, launcher: Launcher, door: ConsoleAddresses) -> None:
        self.launcher = launcher
        self._door = door
        self._told = 0
        self._is_open = False
        self.late: Callable[[], bool] = lambda: True
        """Says, once, that a slow start has come to its end; returns whether that was said."""

    def tell(self) -> None:
        for death in self.launcher.deaths[self._told :]:
            _say(str(death))
            self._told += 1

    def tell_address(self) -> None:
        """Print where the console is, once; it answers there."""
        if not self._is_open:
            self._is_open = True
            self._door.print_address()

    def tell_for_ever(self) -> None:
        is_ready = False
        while True:
            self.tell()
            is_ready = is_ready or self.late()
            if not self._is_open and console_answers(self.launcher.runtime.site()):
                self.tell_address()
            if self._is_open:
                self._door.print_asked_invitation()
            time.sleep(0.5)


def run_interactively(loaded: LoadedSite, folder: Path, record: Path | None) -> int:
    """Start everything, print the console's address when it answers, and stay until Ctrl-C.

    Args:
        loaded: what to start.
        folder: for the output of the processes.
        record: folder for a recording; None records nothing.
    """
    started = time.monotonic()
    checked_exposure(loaded.site)
    refuse_taken_ports(loaded.site, web=True)
    with ExitStack() as stack:
        stack.enter_context(reserved_store(loaded.site))
        runtime = replace(new_runtime(loaded.site, folder, web=True), recording=record)
        recorders = _recorders(loaded, record)
        truth_file = _truth_file(recorders)
        for name, recorder in recorders.items():
            stack.callback(recorder.finish, "ended by the user")
            if truth_file is not None:
                stack.callback(take_truth, truth_file, name, recorder.truth_file)
        signals = stack.enter_context(EndSignals())
        stack.enter_context(announced(discovery_entry(runtime)))
        launcher = stack.enter_context(
            Launcher(
                runtime,
                folder,
                processes_of(runtime, truth_file=truth_file),
                lambda: signals.is_impatient,
            )
        )
        bus = stack.enter_context(ZenohBus(connect=runtime.bus))
        renewal = RoomRenewal(launcher, bus, is_recorded=record is not None)
        stack.callback(bus.answer(USE_EDITS_QUERY, renewal.answer, _WISHES).close)
        teller = _Teller(launcher, ConsoleAddresses(runtime))
        try:
            _introduce(runtime, bus, teller, started)
            for name, recorder in recorders.items():
                stack.callback(_record(recorder, bus, DroneTopics(name)))
            if record is not None:
                console.print(f"recording to {record}", markup=False)
            teller.tell_for_ever()
        except KeyboardInterrupt:
            lands = any(spec.lands for spec in launcher.processes)
            drones = "drones" if len(loaded.site.drone_names) > 1 else "drone"
            leaving = f"landing the {drones}, then leaving (Ctrl-C again does not wait for it)"
            _say(f"\n{leaving if lands else 'leaving'}")
            _land_and_leave(launcher)
    return 0


def _introduce(runtime: Runtime, bus: Bus, teller: _Teller, started: float) -> None:
    site = runtime.site()
    console.print(f"[bold]Housefly[/bold] in {site.name}, mode {site.mode}: {_kind_of(site)}")
    if site.tasks.enabled:
        asked = "who is at the door" if site.drone_names else "where is the cup"
        console.print(f'ask:      {_command()} ask "{asked}"', markup=False)
    console.print(
        f"bus:      {runtime.bus}  (who may run programs here may listen and order)",
        soft_wrap=True,
    )
    if site.drone_names and (note := people_note(site)):
        console.print(f"people:   {note}", markup=False)
    video = site.has_picture
    with console.status("starting") as status:

        def on_missing(words: str) -> None:
            status.update(words)
            teller.tell()

        readiness = Readiness(site, bus, web=True, video=video, on_console=teller.tell_address)
        missing = readiness.wait(_READY_TIMEOUT, on_missing, lambda: teller.launcher.given_up != ())

    def said_ready() -> bool:
        if readiness.wait(0.0):
            return False
        is_demo = site.tasks.enabled and site.twin.enabled
        first = _ASK if is_demo else _FLY
        then = f"{first} Ctrl-C lands and ends." if site.drone_names else _NO_FLIGHT
        console.print(f"ready after {time.monotonic() - started:.1f} s. {then}", soft_wrap=True)
        return True

    teller.tell()
    if not missing:
        said_ready()
        return
    console.print(
        f"[bold]not ready after {_READY_TIMEOUT:.0f} s:[/bold] {missing}; it goes on starting,"
        " and `housefly doctor` may know why it takes so long",
        soft_wrap=True,
    )
    if not teller.launcher.given_up:
        teller.late = said_ready


def _kind_of(site: Site) -> str:
    if site.drone_names:
        return "simulated room" if site.twin.enabled else "real hardware"
    return f"{'simulated' if site.twin.enabled else 'real'} room, no drone"


def _command() -> str:
    """Return what to type for this command, as somebody has typed it here."""
    return sys.argv[0] if sys.argv[0].endswith("/housefly") else "housefly"


def _land_and_leave(launcher: Launcher) -> None:
    pids = {spec.name: launcher.pid(spec.name) for spec in launcher.processes if spec.lands}
    left = launcher.stop()
    if left:
        names = ", ".join(f"{name} (process {pids[name]})" for name in left)
        _say(f"left without waiting: {names} still lands the drone and ends when it is down")


def _say(words: str) -> None:
    """Print where there still is a terminal; a closed one must not disturb the landing."""
    with suppress(OSError):
        console.print(words, markup=False)


def _recorders(loaded: LoadedSite, folder: Path | None) -> dict[str, FlightRecorder]:
    """Return a recorder for each drone; several have a folder each in the one that is named."""
    if folder is None:
        return {}
    names = loaded.site.drone_names or (loaded.site.drone.name,)
    recorders = {}
    for name in names:
        one = loaded.for_drone(name)
        into = folder / name if len(names) > 1 else folder
        recorders[name] = FlightRecorder(into, one.site, one.room, one.grid)
    return recorders


def _truth_file(recorders: dict[str, FlightRecorder]) -> Path | None:
    """Return the file that the simulated room is given; several drones have one each beside it."""
    files = [recorder.truth_file for recorder in recorders.values()]
    if len(files) > 1:
        return files[0].parent.with_name(files[0].name)
    return files[0] if files else None


def _record(recorder: FlightRecorder, bus: Bus, topics: DroneTopics) -> Callable[[], None]:
    open_ = [
        bus.subscribe(topics.step, recorder.add_step),
        bus.subscribe(topics.video, recorder.add_video),
        bus.subscribe(topics.trajectory, recorder.add_trajectory),
        bus.subscribe(topics.link, recorder.add_link),
    ]

    def close() -> None:
        for subscription in open_:
            subscription.close()

    return close
