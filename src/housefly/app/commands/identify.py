"""``housefly identify``: learn a drone's constants from its own flight."""

from __future__ import annotations

import time
from argparse import ArgumentParser, Namespace
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from housefly.app.commands.shared import add_drone_argument, chosen_drone, given
from housefly.app.commands.subcommand import Subcommand
from housefly.app.terminal import console
from housefly.errors import ConfigError

if TYPE_CHECKING:
    from housefly.config.drone import DroneConfig
    from housefly.lab.identification.samples import Flown
    from housefly.messages import PilotStep
    from housefly.sites.loaded_site import LoadedSite

_DESCRIPTION = """\
Fly small steps in tilt, climb and turn inside a box of free air, and fit what the drone makes \
of them:
gain c/lambda, lambda, command delay, drag, and the time constants of climb and turn, each with \
its 95 % interval.
The result is a drone profile that sites (drone.profile), the simulated drone and housefly gains \
read.
A real drone flies by itself for one to two minutes: keep people out of the box, one hand near \
Ctrl-C (it lands)."""
_EPILOG = """examples:
  housefly identify --lockstep                     # the simulated drone, on a stepped clock
  housefly identify --site mylab.toml --out mine   # whatever drone the site names, over its wire
  housefly identify --from mine                    # fit a recorded flight again
"""

_MAX_REACH = 10.0
"""Half of the widest box that is looked for [m]."""


def _add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument(
        "--site",
        default="bsen",
        metavar="SITE",
        help="site file, folder, or shipped site (default: bsen)",
    )
    add_drone_argument(parser)
    parser.add_argument(
        "--out", metavar="DIR", help="where to write (default: identification/<time>)"
    )
    parser.add_argument(
        "--from", dest="recorded", metavar="DIR", help="fit what was recorded there, fly nothing"
    )
    parser.add_argument(
        "--lockstep", action="store_true", help="simulated drone on a stepped clock, no wires"
    )
    parser.add_argument(
        "--repeats",
        type=int,
        default=6,
        metavar="N",
        help="blocks of each kind, 4 to 40 (default: 6)",
    )
    parser.add_argument(
        "--box", type=float, metavar="M", help="side of the box (default: what the blocks need)"
    )
    parser.add_argument(
        "--at", metavar="PLACE", help="fly near this place (default: the nearest room to the pad)"
    )
    parser.add_argument("--seed", type=int, help="seed of all simulated noise")
    parser.add_argument(
        "--mocap-rate", type=float, metavar="HZ", help="frames per second of the simulated tracking"
    )


def _run(options: Namespace) -> int:
    """Fly and fit, or fit only; 0 when a profile was written."""
    console.print("loading the site, its map and the pilot")
    from housefly.app.identification_blocks import read_blocks
    from housefly.record.replay import read_steps
    from housefly.sites.loaded_site import open_site, read_site, with_newest_edits

    if options.recorded is not None:
        folder = Path(options.recorded)
        loaded = open_site(read_site(str(folder / "site.json")))
        flown = read_blocks(folder)
        return _conclude(loaded, list(read_steps(folder)), flown, folder)
    if not 4 <= options.repeats <= 40:
        raise ConfigError("--repeats", f"is {options.repeats}; allowed: a number from 4 to 40")
    changes = {
        "twin__seed": options.seed,
        "twin__mocap_rate_hz": options.mocap_rate,
        "mode": "default",
    }
    site = read_site(options.site, **given(changes))
    if not options.lockstep:
        site, _ = with_newest_edits(site)  # a no-fly zone holds for this flight too
    loaded = open_site(site.for_drone(chosen_drone(site, options)))
    out = Path(options.out or time.strftime("identification/%Y-%m-%d_%H-%M-%S"))
    steps, flown, outcome = _fly(loaded, options, out)
    if outcome != "completed":
        console.print(
            f"[bold]given up[/bold]: {outcome}; nothing was fitted (the recording is in {out})"
        )
        return 1
    return _conclude(loaded, steps, flown, out)


def refuse_without_tilt(drone: DroneConfig) -> None:
    """Raise ConfigError for a drone that is not steered by tilt: its own loops hide its constants.

    A flight would take its two minutes and show steps in nothing.
    """
    from housefly.messages.steering import SetpointForm

    form = drone.airframe.capabilities.form
    if form is not SetpointForm.TILT_AND_CLIMB:
        raise ConfigError(
            "drone.kind",
            f"is {drone.kind}, which is steered by {form.value}: steps in tilt, climb and turn are"
            " flown and fitted; allowed: a drone that is steered by tilt and climb",
        )


def _fly(
    loaded: LoadedSite, options: Namespace, out: Path
) -> tuple[list[PilotStep], tuple[Flown, ...], str]:
    from housefly.app.compiling import CompiledPart, compile_once
    from housefly.app.identification_blocks import write_blocks
    from housefly.app.identification_flight import (
        BLOCK_TIMEOUT,
        IdentificationFlight,
        box_reach,
        fly_identification_lockstep,
        fly_identification_over_wires,
    )
    from housefly.app.identification_progress import IdentificationProgress
    from housefly.app.ports import refuse_taken_ports
    from housefly.lab.identification.box import find_box
    from housefly.lab.identification.maneuver import IdentificationManeuver
    from housefly.lab.identification.pattern import blocks
    from housefly.record.recorder import FlightRecorder
    from housefly.twin.installed import require_simulator

    site = loaded.site
    refuse_without_tilt(site.drone)
    plan = blocks(options.repeats, site.limits.tilt_max)
    needed = box_reach(plan, site.drone)
    reach = needed if options.box is None else 0.5 * options.box
    if not needed <= reach <= _MAX_REACH:
        raise ConfigError(
            "--box",
            f"is {2 * reach:g} m; allowed: from {2 * needed:.2f} m, which the blocks may take the"
            f" drone, to {2 * _MAX_REACH:g} m",
        )
    start = loaded.room.home if options.at is None else _place(loaded, options.at)
    box = find_box(loaded.grid, start, reach, site.map.flight_height)
    x, y = box.centre
    length = sum(block.duration + 2.5 for block in plan)
    where = f"a box of {2 * box.reach:.2f} m around ({x:.2f}, {y:.2f}), {box.height:.1f} m high"
    console.print(f"{len(plan)} blocks in {where}; about {length:.0f} s")
    if not options.lockstep:
        refuse_taken_ports(site, web=False)
    if options.lockstep or site.twin.enabled:
        require_simulator()
    compile_once(CompiledPart.CHAIN, console.print)
    recorder = FlightRecorder(out, site, loaded.room, loaded.grid)
    flight = IdentificationFlight(
        box, IdentificationManeuver(plan, box), 120.0 + BLOCK_TIMEOUT * len(plan)
    )
    steps: list[PilotStep] = []
    outcome = "failed"
    try:
        with IdentificationProgress(len(plan)) as progress:

            def on_step(step: PilotStep) -> None:
                steps.append(step)
                recorder.add_step(step)
                progress.show(flight.maneuver.done, step.outputs.phase.value)

            if options.lockstep:
                from housefly.twin.world import SimulatedWorld

                outcome = fly_identification_lockstep(
                    loaded, SimulatedWorld(loaded.site, loaded.room), flight, on_step
                )
            else:
                logs = out / "logs"
                logs.mkdir(exist_ok=True)
                outcome = fly_identification_over_wires(loaded, flight, logs, on_step)
    finally:
        with console.status("writing the recording's summary and report"):
            recorder.finish(outcome, steps)
        write_blocks(out, tuple(flight.maneuver.flown))
    return steps, tuple(flight.maneuver.flown), outcome


def _conclude(
    loaded: LoadedSite, steps: Iterable[PilotStep], flown: tuple[Flown, ...], out: Path
) -> int:
    from housefly.app.identification_report import measurement_notes, print_constants
    from housefly.config.profile import write_profile
    from housefly.lab.identification.plots import draw_fit
    from housefly.lab.identification.result import Limits, fit_constants
    from housefly.lab.identification.samples import samples_of
    from housefly.lab.identification.truth import simulated_truth

    site = loaded.site
    truth = simulated_truth(site) if site.twin.enabled else None
    limits = Limits(site.limits.tilt_max, site.limits.vertical_speed_max, site.limits.yaw_rate_max)
    with console.status(f"fitting {len(flown)} blocks"):
        samples = samples_of(steps, flown, site.tracking.body)
        found = fit_constants(samples, limits, truth=truth)
    if found.constants:
        print_constants(found, loaded)
        with console.status("drawing the fit"):
            png, _ = draw_fit(found, out / "fit")
        console.print(f"drawn: {png}", markup=False, soft_wrap=True)
    if found.problems:
        console.print("[bold]no profile[/bold]: the data cannot tell")
        for problem in found.problems:
            console.print(f"  {problem}", markup=False)
        return 1
    if found.truth:
        console.print(found.advice, markup=False)
    profile = out / "drone.toml"
    write_profile(profile, found.constants, measurement_notes(found, loaded))
    console.print(
        f'written: {profile}\nuse it:  [drone] profile = "{profile}" in a site file, or housefly'
        f" gains --profile {profile}",
        soft_wrap=True,
        markup=False,
    )
    return 0


def _place(loaded: LoadedSite, name: str) -> tuple[float, float]:
    try:
        return loaded.room.place(name).viewpoint
    except KeyError as error:
        raise ConfigError("--at", str(error.args[0])) from error


IDENTIFY_COMMAND = Subcommand(
    name="identify",
    help="learn a drone's constants (c, lambda, delay, drag, ...) from a safe test flight",
    description=_DESCRIPTION,
    epilog=_EPILOG,
    add_arguments=_add_arguments,
    run=_run,
)
