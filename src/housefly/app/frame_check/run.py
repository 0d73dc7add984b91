"""Starts what a frame check needs, runs it, says what it found, and keeps that with the site."""

from __future__ import annotations

import asyncio
from datetime import UTC, datetime
from math import degrees
from pathlib import Path

from housefly.app.end_signals import EndSignals
from housefly.app.frame_check.carrying_hands import CarryingHands
from housefly.app.frame_check.person import PersonAtTerminal
from housefly.app.frame_check.session import FrameCheckSession
from housefly.app.launcher import Launcher, ProcessSpec, driver_process
from housefly.app.new_runtime import new_runtime
from housefly.app.ports import refuse_taken_ports
from housefly.app.run_folder import temporary_run_folder
from housefly.app.terminal import console
from housefly.clock import RealClock
from housefly.config.frame_check import FrameCheckRecord, tracking_digest, write_frame_check
from housefly.config.site import Site, changed
from housefly.drones.remote_drone import RemoteDrone
from housefly.errors import LinkError
from housefly.hub.client.discovery import running
from housefly.lab.frames.findings import FrameVerdict
from housefly.lab.frames.guide import CarryGuide
from housefly.lab.frames.plan import CarryPlan, carry_plan
from housefly.sites.loaded_site import LoadedSite
from housefly.tracking.trackers import tracker_of

_GREETING = """\
You carry the drone through five places and back; tracking is compared with what you did. Nothing \
can take off meanwhile: no pilot runs. Have a tape measure of 1 m ready, take the drone by its \
hull, and keep the markers free. Press Enter when a step is done; Ctrl-C gives up, and keeps \
nothing."""
_SIMULATED = "The room is simulated: press Enter at each step, and simulated hands do it."


def run_frame_check(loaded: LoadedSite) -> FrameVerdict:
    """Lead whoever is at the terminal through a frame check, and keep what it finds.

    Raises:
        LinkError: a run of this site is under way; tracking does not answer; the input ended.
    """
    site = loaded.site
    _refuse_running(site)
    refuse_taken_ports(site, web=False)
    plan = carry_plan(loaded.room)
    quiet = changed(site, twin__video=False, drone__has_video=False)
    with temporary_run_folder("frames") as folder, EndSignals():
        runtime = new_runtime(quiet, folder)
        hands = runtime.sockets / "hands" if site.twin.enabled else None
        twin = ("--site", str(runtime.site_file), "--hands", str(hands))
        processes = (
            driver_process(site, site.drone.name),
            *([ProcessSpec("twin", "housefly.twin.process", twin)] if hands else []),
        )
        console.print(_GREETING, soft_wrap=True)
        if hands:
            console.print(_SIMULATED, soft_wrap=True)
        with Launcher(runtime, folder, processes) as launcher:
            try:
                verdict = asyncio.run(
                    _carried(quiet, plan, runtime.driver_socket(site.drone.name), hands)
                )
            except LinkError as error:
                if launcher.given_up:
                    raise LinkError(str(launcher.given_up[0])) from error
                raise
    _tell(verdict)
    path = write_frame_check(site, _record(site, verdict))
    console.print(f"kept: {path}", soft_wrap=True, markup=False)
    return verdict


async def _carried(
    site: Site, plan: CarryPlan, driver_socket: Path, hands: Path | None
) -> FrameVerdict:
    clock = RealClock()
    with PersonAtTerminal() as person:
        session = FrameCheckSession(
            CarryGuide(plan, site.tracking),
            tracker_of(site.tracking, clock),
            RemoteDrone(driver_socket, clock),
            person,
            clock,
            CarryingHands(plan, hands) if hands else None,
        )
        return await session.run()


def _refuse_running(site: Site) -> None:
    if any(house.site == site.name for house in running()):
        raise LinkError(
            f"{site.name} is running: end it first; nobody must be able to order a take-off while"
            " you hold the drone"
        )


def _tell(verdict: FrameVerdict) -> None:
    console.print()
    for note in verdict.notes:
        console.print(f"[yellow]note[/yellow]  {note}", soft_wrap=True)
    for finding in verdict.findings:
        console.print(f"[red]wrong[/red] {finding.fault.value}:", end=" ")
        console.print(f"{finding.words}\n      -> {finding.mend}", soft_wrap=True, markup=False)
    if verdict.mended:
        lines = "\n".join(
            f'  {key} = "{value}"' if isinstance(value, str) else f"  {key} = {value}"
            for key, value in verdict.mended.items()
        )
        console.print(
            f"All that a site file can mend of it:\n\n  [tracking]\n{lines}\n", markup=False
        )
    if verdict.passed:
        console.print("[bold]FRAMES RIGHT[/bold]: tracking, drone and map agree")
    else:
        console.print("[bold]FRAMES WRONG[/bold]: mend it, and check again")
    console.print(_numbers(verdict), soft_wrap=True, markup=False)


def _numbers(verdict: FrameVerdict) -> str:
    named = {
        "frame against map": ("rotation_deg", "{:+.0f} deg"),
        "body against nose": ("body_yaw_deg", "{:+.0f} deg"),
        "pad": ("origin_x_m", "{:+.2f} m in x"),
        "and": ("origin_y_m", "{:+.2f} m in y"),
        "height": ("height_m", "{:+.2f} m"),
        "1 m is seen as": ("scale", "{:.2f} m"),
        "delay": ("lag_s", "{:+.2f} s"),
    }
    values = dict(_values(verdict))
    told = [
        f"{name} {form.format(values[key])}" for name, (key, form) in named.items() if key in values
    ]
    return f"measured: {', '.join(told) or 'nothing'}"


def _values(verdict: FrameVerdict) -> tuple[tuple[str, float], ...]:
    found = verdict.measures
    x, y = found.origin or (None, None)
    values = {
        "rotation_deg": None if found.rotation is None else degrees(found.rotation),
        "body_yaw_deg": None if found.body_yaw is None else degrees(found.body_yaw),
        "origin_x_m": x,
        "origin_y_m": y,
        "height_m": found.height,
        "scale": found.scale,
        "lag_s": found.lag,
    }
    return tuple((name, round(value, 3)) for name, value in values.items() if value is not None)


def _record(site: Site, verdict: FrameVerdict) -> FrameCheckRecord:
    return FrameCheckRecord(
        datetime.now(UTC).isoformat(timespec="seconds"),
        tracking_digest(site.tracking),
        tuple(f"{found.fault.value}: {found.words}" for found in verdict.findings),
        verdict.notes,
        _values(verdict),
    )
