"""The service of Fig. 17 over real wires: flown, flown again where it starved, and kept."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from PIL import Image

from housefly.app.console_camera import ConsoleCamera, has_browser
from housefly.app.headless import fly_over_wires
from housefly.app.new_runtime import new_runtime
from housefly.app.reproduction_flights import GOAL, LOOK_TIME, RecordedService, read_service
from housefly.app.reproduction_moments import MomentShot, MomentShots
from housefly.app.reproduction_store import ReproductionStore
from housefly.config.site import Site, changed
from housefly.errors import LinkError, RecordingError
from housefly.lab.reproduction.fig17_service import RgbImage
from housefly.messages import Order, OrderKind, OrderSource, PilotStep
from housefly.record.recorder import FlightRecorder
from housefly.sites.loaded_site import open_site
from housefly.web.access.exposure import console_address

NAME = "wires"
_SHOTS = "shots.json"


@dataclass(frozen=True, slots=True)
class WireService:
    """A service over real wires.

    Attributes:
        service: the flight with its record.
        shots: one for each moment.
        folder: of the record.
    """

    service: RecordedService
    shots: tuple[MomentShot, ...]
    folder: Path


def read_wire_service(site: Site, store: ReproductionStore) -> WireService | None:
    """Return the service that an earlier run has flown over real wires; None without one."""
    folder = store.flight_folder(NAME)
    if not store.is_kept(NAME):
        return None
    try:
        service = read_service(open_site(_over_wires(site)), folder)
        return WireService(service, _read_shots(folder, service), folder)
    except (RecordingError, OSError, ValueError, KeyError):
        return None


def fly_wire_service(
    site: Site, store: ReproductionStore, on_word: Callable[[str], None]
) -> WireService:
    """Fly one service over real wires, with video, and pictures of the console if possible.

    Raises:
        LinkError: it was not completed; the message says why.
        KeyboardInterrupt: Ctrl-C; the drone has landed.
    """
    folder = store.begin(NAME)
    loaded = open_site(_over_wires(site))
    logs = folder / "logs"
    logs.mkdir(parents=True, exist_ok=True)
    runtime = new_runtime(loaded.site, logs, web=has_browser())
    recorder = FlightRecorder(folder, loaded.site, loaded.room, loaded.grid)
    order = Order(
        OrderKind.SERVICE,
        place=GOAL,
        look_s=LOOK_TIME,
        sender="reproduction",
        source=OrderSource.PROGRAM,
    )
    outcome = "failed"
    with ConsoleCamera(f"{console_address(runtime.site())}/?token={runtime.token}") as camera:
        moments = MomentShots(camera)
        try:
            outcome = fly_over_wires(
                runtime,
                logs,
                loaded.room.home,
                order,
                recorder,
                moments.update,
                on_word,
            )
        finally:
            summary = recorder.finish(outcome)
        shots = moments.shots()
    if outcome == "interrupted":
        raise KeyboardInterrupt
    if summary.outcome != "completed":
        raise LinkError(f"{summary.outcome} (recorded in {_moved_aside(folder)})")
    _write_shots(folder, shots)
    store.keep(NAME)
    return WireService(read_service(loaded, folder), shots, folder)


def _over_wires(site: Site) -> Site:
    return changed(site, mode="default", web__port=0)


def _moved_aside(folder: Path) -> Path:
    """Keep the record of a flight that failed, since the next one takes the name."""
    aside = folder.with_name(f"{folder.name}-failed-{time.strftime('%Y%m%d-%H%M%S')}")
    try:
        return folder.rename(aside)
    except OSError:  # it is in use, or one failed in the same second
        return folder


def _write_shots(folder: Path, shots: Iterable[MomentShot]) -> None:
    rows = []
    for number, shot in enumerate(shots):
        rows.append({"title": shot.title, "sequence": shot.step.sequence})
        if shot.console is not None:
            Image.fromarray(shot.console).save(folder / f"console-{number}.png")
    (folder / _SHOTS).write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")


def _read_shots(folder: Path, service: RecordedService) -> tuple[MomentShot, ...]:
    steps: dict[int, PilotStep] = {step.sequence: step for step in service.flight.steps}
    rows = json.loads((folder / _SHOTS).read_text(encoding="utf-8"))
    return tuple(
        MomentShot(row["title"], steps[row["sequence"]], _picture(folder / f"console-{number}.png"))
        for number, row in enumerate(rows)
    )


def _picture(path: Path) -> RgbImage | None:
    if not path.is_file():
        return None
    with Image.open(path) as image:
        return np.asarray(image.convert("RGB"), dtype=np.uint8)
