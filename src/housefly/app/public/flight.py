"""Flies one service and returns it with its record; opens the record of an earlier one."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

from pydantic import TypeAdapter, ValidationError

from housefly.app.compiling import CompiledPart, compile_once
from housefly.app.headless import fly_over_wires
from housefly.app.new_runtime import new_runtime
from housefly.app.ports import refuse_taken_ports
from housefly.app.public.temporary_folder import TemporaryFolder
from housefly.app.replaying import recorded_site, verify_recording
from housefly.errors import ConfigError, RecordingError
from housefly.geometry import Vec2
from housefly.lab.lockstep.service import fly_lockstep
from housefly.messages import Order, OrderKind, OrderSource, PilotStep
from housefly.record.recorder import FlightRecorder
from housefly.record.replay import ReplayResult, read_steps
from housefly.record.summary import Summary
from housefly.sites.loaded_site import LoadedSite, open_site, with_newest_edits
from housefly.twin.installed import require_simulator

_MAX_LOOK = 120.0
"""Longest time to look [s]."""
_SENDER = "python"
_SUMMARY: TypeAdapter[Summary] = TypeAdapter(Summary)


@dataclass(frozen=True, slots=True, eq=False)
class Flight:
    """One flight that is over.

    Attributes:
        outcome: "completed", or why not.
        summary: the flight in numbers.
        folder: of the record: ``flight.mcap``, ``summary.json``, ``report.html`` and more.
        loaded: the site as it was flown.
    """

    outcome: str
    summary: Summary = field(repr=False)
    folder: Path
    loaded: LoadedSite = field(repr=False)
    _temporary: TemporaryFolder | None = field(default=None, repr=False)

    def steps(self) -> Iterator[PilotStep]:
        """Yield every step of the pilot; raises RecordingError if the recording is damaged."""
        yield from read_steps(self.folder)

    def replay(self) -> ReplayResult:
        """Give the recording to a fresh pilot and compare every command, bit for bit."""
        return verify_recording(self.folder, self.loaded)

    def close(self) -> None:
        """Remove the folder if it is a temporary one."""
        if self._temporary is not None:
            self._temporary.remove()


def fly(
    goal: str | Vec2,
    loaded: LoadedSite,
    *,
    lockstep: bool = True,
    look_s: float = 5.0,
    out: str | Path | None = None,
    on_step: Callable[[PilotStep], None] = lambda step: None,
) -> Flight:
    """Fly one whole service: take off, fly to a goal, look, come home, land.

    Args:
        goal: name of a place, or world xy [m].
        loaded: where to fly.
        lockstep: fly the simulated room on a stepped clock, faster than real time. False starts
            the site's processes and flies over real wires, the drone that the site names, around
            the no-fly zones of the ROOM screen; Ctrl-C lands it.
        look_s: how long to look [s].
        out: folder of the record. None takes a temporary one, which is removed with the returned
            ``Flight``.
        on_step: called with every step of the pilot; over wires from another thread.

    Raises:
        ConfigError: there is no such place, or a value is out of range.
        MissingPartError: the room is simulated, and MuJoCo is not installed.
        LinkError: the drone or the tracking system did not answer in time.
        RecordingError: ``out`` cannot be written to.
    """
    order = _order(goal, loaded, look_s)
    if lockstep or loaded.site.twin.enabled:
        require_simulator()
    temporary = TemporaryFolder() if out is None else None
    folder = temporary.path if temporary else Path(out or "")
    if not lockstep:
        loaded = open_site(with_newest_edits(loaded.site)[0])
        refuse_taken_ports(loaded.site, web=False)
        compile_once(CompiledPart.CHAIN, lambda words: None)
    recorder = FlightRecorder(folder, loaded.site, loaded.room, loaded.grid)

    def record_step(step: PilotStep) -> None:
        recorder.add_step(step)
        on_step(step)

    outcome = "failed"
    try:
        if lockstep:
            outcome = fly_lockstep(loaded, order, record_step, truth_file=recorder.truth_file)
        else:
            outcome = _fly_over_wires(loaded, order, folder, recorder, on_step)
    finally:
        summary = recorder.finish(outcome)
    return Flight(summary.outcome, summary, folder, loaded, temporary)


def open_flight(folder: str | Path) -> Flight:
    """Open the record of an earlier flight, of ``fly``, of the console or of the command line.

    Raises:
        RecordingError: it is not there, or not whole.
    """
    path = Path(folder)
    try:
        summary = _SUMMARY.validate_json((path / "summary.json").read_bytes())
    except OSError as error:
        raise RecordingError(f"{path / 'summary.json'} cannot be read: {error.strerror}") from error
    except ValidationError as error:
        raise RecordingError(f"{path / 'summary.json'} is no summary of a flight") from error
    return Flight(summary.outcome, summary, path, open_site(recorded_site(path / "flight.mcap")))


def _order(goal: str | Vec2, loaded: LoadedSite, look_s: float) -> Order:
    if not 0.0 <= look_s <= _MAX_LOOK:
        raise ConfigError("look_s", f"is {look_s:g}; allowed: a number from 0 to {_MAX_LOOK:g} s")
    point = loaded.point_of(goal)
    if isinstance(goal, str):
        return Order(
            OrderKind.SERVICE, place=goal, look_s=look_s, sender=_SENDER, source=OrderSource.PROGRAM
        )
    return Order(
        OrderKind.SERVICE, goal=point, look_s=look_s, sender=_SENDER, source=OrderSource.PROGRAM
    )


def _fly_over_wires(
    loaded: LoadedSite,
    order: Order,
    folder: Path,
    recorder: FlightRecorder,
    on_step: Callable[[PilotStep], None],
) -> str:
    logs = folder / "logs"
    logs.mkdir(exist_ok=True)
    runtime = new_runtime(loaded.site, logs)
    return fly_over_wires(
        runtime,
        logs,
        loaded.room.home,
        order,
        recorder,
        on_step,
        lambda words: None,
        drone=loaded.site.drone.name,
    )
