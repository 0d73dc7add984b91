"""One recorded service, over real wires or in lock step."""

from __future__ import annotations

from pathlib import Path

from housefly.app.console_addresses import ConsoleAddresses
from housefly.app.flight_progress import FlightProgress
from housefly.app.headless import fly_over_wires
from housefly.app.new_runtime import new_runtime
from housefly.app.people_note import people_note
from housefly.app.ports import refuse_taken_ports
from housefly.app.terminal import console
from housefly.config.site import changed
from housefly.lab.lockstep.service import fly_lockstep
from housefly.messages import Order, OrderKind, PilotStep
from housefly.record.recorder import FlightRecorder
from housefly.record.summary import Summary
from housefly.record.truth import ContactRecord
from housefly.sites.loaded_site import LoadedSite
from housefly.twin.faults.injector import FaultInjector
from housefly.twin.faults.vocabulary import Injection
from housefly.web.access.exposure import checked_exposure

_SUMMARY_FIGURES = (
    ("duration_s", "duration", "s", 1),
    ("path_length_m", "path", "m", 2),
    ("rms_error_m", "true rms error", "m", 3),
    ("tracked_rms_error_m", "... by tracking", "m", 3),
    ("max_error_m", "largest true error", "m", 3),
    ("arrival_error_m", "true arrival error", "m", 3),
    ("min_clearance_m", "clearance of the hull", "m", 2),
    ("min_clearance_people_m", "... from people", "m", 2),
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
    """Fly to a place, look, come home, land; write the record into ``out``; return the outcome.

    Raises:
        ConfigError: a fault of the site that cannot be made in lock step, or on wires.
    """
    FaultInjector(loaded.site, Injection.LOCKSTEP if lockstep else Injection.WIRES)
    if not lockstep:
        if web:
            checked_exposure(loaded.site)
        refuse_taken_ports(loaded.site, web=web)
    if note := people_note(loaded.site):
        console.print(f"people: {note}", markup=False)
    recorder = FlightRecorder(out, loaded.site, loaded.room, loaded.grid)
    order = Order(OrderKind.SERVICE, place=place, look_s=look_s, sender="command line")
    outcome = "failed"
    try:
        with FlightProgress() as progress:

            def on_step(step: PilotStep) -> None:
                recorder.add_step(step)
                progress.show(step)

            if lockstep:
                outcome = fly_lockstep(loaded, order, on_step, truth_file=recorder.truth_file)
            else:
                logs = out / "logs"
                logs.mkdir(exist_ok=True)
                # One service is flown by one order: nobody else may want something meanwhile.
                runtime = new_runtime(changed(loaded.site, tasks__enabled=False), logs, web=web)
                outcome = fly_over_wires(
                    runtime,
                    logs,
                    loaded.room.home,
                    order,
                    recorder,
                    progress.show,
                    progress.say,
                    on_console=ConsoleAddresses(runtime).print_address,
                    drone=loaded.site.drone.name,
                )
    finally:
        summary = recorder.finish(outcome)
    _print_summary(summary, out)
    return summary.outcome


def _print_summary(summary: Summary, out: Path) -> None:
    console.print(f"[bold]{summary.outcome}[/bold]")
    for key, words, unit, decimals in _SUMMARY_FIGURES:
        value = getattr(summary, key)
        console.print(
            f"  {words:<22}"
            + ("not measured" if value is None else f"{value:8.{decimals}f} {unit}")
        )
    console.print(f"  {'contacts':<22}{_contacts(summary)}", markup=False)
    for fault in summary.faults:
        console.print(f"  {'made to fail':<22}{fault}", markup=False)
    for problem in summary.problems:
        console.print(f"  {problem}", markup=False)
    words = f"record: {out} (report.html, flight.mcap, summary.json)"
    console.print(words, markup=False, soft_wrap=True)


def _contacts(summary: Summary) -> str:
    if summary.contacts is None:
        return "not measured"
    return "none" if not summary.contacts else "; ".join(map(_in_words, summary.contacts))


def _in_words(contact: ContactRecord) -> str:
    return f"{contact.name} at {contact.speed:.2f} m/s, {contact.at_s:.1f} s"
