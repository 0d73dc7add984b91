"""One recorded service, over real wires or in lock step."""

from __future__ import annotations

from pathlib import Path

from housefly.app.flight_progress import FlightProgress
from housefly.app.headless import fly_over_wires
from housefly.app.loaded_site import LoadedSite
from housefly.app.lockstep import fly_lockstep
from housefly.app.ports import refuse_taken_ports
from housefly.app.runtime import Runtime, new_runtime
from housefly.app.terminal import console
from housefly.messages import Order, OrderKind, PilotStep
from housefly.record.recorder import FlightRecorder
from housefly.record.summary import Summary

_SUMMARY_FIGURES = (
    ("duration_s", "duration", "s", 1),
    ("path_length_m", "path", "m", 2),
    ("rms_error_m", "rms error", "m", 3),
    ("max_error_m", "largest error", "m", 3),
    ("arrival_error_m", "arrival error", "m", 3),
    ("min_clearance_m", "smallest clearance", "m", 2),
    ("landed_error_m", "landed off the pad by", "m", 3),
)
"""What is printed at the end: key of the summary, words, unit, decimals."""


def fly_service(
    loaded: LoadedSite,
    place: str,
    look_s: float,
    out: Path,
    *,
    lockstep: bool,
    web: bool,
) -> str:
    """Fly to a place, look, come home, land; write the record into ``out``; return the outcome."""
    if not lockstep:
        refuse_taken_ports(loaded.site, web=web)
    recorder = FlightRecorder(out, loaded.site, loaded.room, loaded.grid)
    order = Order(OrderKind.SERVICE, place=place, look_s=look_s, sender="command line")
    outcome = "failed"
    try:
        with FlightProgress() as progress:

            def on_step(step: PilotStep) -> None:
                recorder.add_step(step)
                progress.show(step)

            if lockstep:
                outcome = fly_lockstep(loaded, order, on_step)
            else:
                logs = out / "logs"
                logs.mkdir(exist_ok=True)
                runtime = new_runtime(loaded.site, logs)
                if web:
                    console.print(f"console: {_address(runtime)}", soft_wrap=True)
                outcome = fly_over_wires(
                    runtime,
                    logs,
                    loaded.room.home,
                    order,
                    recorder,
                    progress.show,
                    progress.say,
                    web=web,
                )
    finally:
        summary = recorder.finish(outcome)
    _print_summary(summary, out)
    return outcome


def _address(runtime: Runtime) -> str:
    web = runtime.site().web
    return f"http://{web.host}:{web.port}/?token={runtime.token}"


def _print_summary(summary: Summary, out: Path) -> None:
    console.print(f"[bold]{summary.outcome}[/bold]")
    for key, words, unit, decimals in _SUMMARY_FIGURES:
        value = getattr(summary, key)
        console.print(
            f"  {words:<22}"
            + ("not measured" if value is None else f"{value:8.{decimals}f} {unit}")
        )
    for problem in summary.problems:
        console.print(f"  {problem}")
    console.print(f"record: {out} (report.html, flight.mcap, summary.json)", soft_wrap=True)
