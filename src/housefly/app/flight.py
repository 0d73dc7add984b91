"""One recorded service, over real wires or in lock step."""

from __future__ import annotations

import tempfile
from pathlib import Path

from rich.console import Console

from housefly.app.headless import fly_headless
from housefly.app.lockstep import fly_lockstep
from housefly.app.premises import Premises
from housefly.app.progress import FlightProgress
from housefly.app.runtime import new_runtime
from housefly.messages import Order, OrderKind, PilotStep
from housefly.record.recorder import FlightRecorder
from housefly.record.summary import Summary


def fly_service(premises: Premises, place: str, look_s: float, out: Path, console: Console, *, lockstep: bool, web: bool) -> str:
    """Fly to a place, look, come home, land; write the record into ``out``; return the outcome."""
    out.mkdir(parents=True, exist_ok=True)
    recorder = FlightRecorder(out, premises.site, premises.room, premises.grid)
    order = Order(OrderKind.SERVICE, place=place, look_s=look_s, sender="command line")
    outcome = "failed"
    try:
        with FlightProgress(console) as progress, tempfile.TemporaryDirectory(prefix="housefly-") as folder:

            def on_step(step: PilotStep) -> None:
                recorder.step(step)
                progress.step(step)

            if lockstep:
                outcome = fly_lockstep(premises, order, on_step)
            else:
                runtime = new_runtime(premises.site, Path(folder))
                outcome = fly_headless(runtime, Path(folder), order, recorder, progress.step, progress.say)
    finally:
        summary = recorder.finish(outcome)
    _tell(summary, out, console)
    return outcome


def _tell(summary: Summary, out: Path, console: Console) -> None:
    console.print(f"[bold]{summary.outcome}[/bold]", highlight=False)
