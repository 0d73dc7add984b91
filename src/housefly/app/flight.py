"""One recorded service, over real wires or in lock step."""

from __future__ import annotations

from pathlib import Path

from rich.console import Console

from housefly.app.headless import fly_over_wires
from housefly.app.lockstep import fly_lockstep
from housefly.app.ports import refuse_taken_ports
from housefly.app.premises import Premises
from housefly.app.progress import FlightProgress
from housefly.app.runtime import Runtime, new_runtime
from housefly.messages import Order, OrderKind, PilotStep
from housefly.record.recorder import FlightRecorder
from housefly.record.summary import Summary

FIGURES = (
    ("duration_s", "duration", "s", 1),
    ("path_length_m", "path", "m", 2),
    ("rms_error_m", "rms error", "m", 3),
    ("max_error_m", "largest error", "m", 3),
    ("arrival_error_m", "arrival error", "m", 3),
    ("min_clearance_m", "smallest clearance", "m", 2),
    ("landed_error_m", "landed off the pad by", "m", 3),
)
"""What is told at the end: key of the summary, words, unit, decimals."""


def fly_service(
    premises: Premises,
    place: str,
    look_s: float,
    out: Path,
    console: Console,
    *,
    lockstep: bool,
    web: bool,
) -> str:
    """Fly to a place, look, come home, land; write the record into ``out``; return the outcome."""
    if not lockstep:
        refuse_taken_ports(premises.site, web=web)
    recorder = FlightRecorder(out, premises.site, premises.room, premises.grid)
    order = Order(OrderKind.SERVICE, place=place, look_s=look_s, sender="command line")
    outcome = "failed"
    try:
        with FlightProgress(console) as progress:

            def on_step(step: PilotStep) -> None:
                recorder.step(step)
                progress.step(step)

            if lockstep:
                outcome = fly_lockstep(premises, order, on_step)
            else:
                logs = out / "logs"
                logs.mkdir(exist_ok=True)
                runtime = new_runtime(premises.site, logs)
                if web:
                    console.print(f"console: {_address(runtime)}", soft_wrap=True)
                outcome = fly_over_wires(
                    runtime,
                    logs,
                    premises.room.home,
                    order,
                    recorder,
                    progress.step,
                    progress.say,
                    web=web,
                )
    finally:
        summary = recorder.finish(outcome)
    _tell(summary, out, console)
    return outcome


def _address(runtime: Runtime) -> str:
    web = runtime.site().web
    return f"http://{web.host}:{web.port}/?token={runtime.token}"


def _tell(summary: Summary, out: Path, console: Console) -> None:
    console.print(f"[bold]{summary.outcome}[/bold]")
    for key, words, unit, decimals in FIGURES:
        value = getattr(summary, key)
        console.print(
            f"  {words:<22}"
            + ("not measured" if value is None else f"{value:8.{decimals}f} {unit}")
        )
    for problem in summary.problems:
        console.print(f"  {problem}")
    console.print(f"record: {out} (report.html, flight.mcap, summary.json)", soft_wrap=True)
