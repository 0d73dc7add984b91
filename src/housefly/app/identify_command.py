"""``housefly identify``: learn a drone's constants from its own flight."""

from __future__ import annotations

import argparse
import json
import time
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rich.console import Console

from housefly.errors import ConfigError, RecordingError

if TYPE_CHECKING:
    from housefly.app.premises import Premises
    from housefly.lab.identification.result import Identified
    from housefly.lab.identification.samples import Flown
    from housefly.messages import PilotStep

console = Console(highlight=False)

DESCRIPTION = """Fly small steps in tilt, climb and turn inside a box of free air, and fit what the drone makes of them:
gain c/lambda, lambda, command delay, drag, and the time constants of climb and turn, each with its 95 % interval.
The result is a drone profile that sites (drone.profile), the simulated drone and housefly gains read.
A real drone flies by itself for one to two minutes: keep people out of the box, one hand near Ctrl-C (it lands)."""
EPILOG = """examples:
  housefly identify --lockstep                     # the simulated drone, on a stepped clock
  housefly identify --site mylab.toml --out mine   # whatever drone the site names, over its wire
  housefly identify --from mine                    # fit a recorded flight again
"""
MARGIN = 0.3
"""Room in the box beyond the predicted excursion [m]."""
BLOCKS = "blocks.json"


def add(actions: Any) -> None:
    """Add the command to the parser."""
    parser = actions.add_parser(
        "identify",
        help="learn a drone's constants (c, lambda, delay, drag, ...) from a safe test flight",
        description=DESCRIPTION,
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument(
        "--site",
        default="bsen",
        metavar="SITE",
        help="site file, folder, or shipped site (default: bsen)",
    )
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
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Fly and fit, or fit only; 0 when a profile was written."""
    from housefly.app.premises import open_premises, read_site, with_newest_edits

    if options.recorded:
        folder = Path(options.recorded)
        premises = open_premises(read_site(str(folder / "site.json")))
        return _conclude(premises, *_read(folder), folder)
    if not 4 <= options.repeats <= 40:
        raise ConfigError("--repeats", f"is {options.repeats}; allowed: a number from 4 to 40")
    changes = {
        "twin__seed": options.seed,
        "twin__mocap_rate_hz": options.mocap_rate,
        "mode": "default",
    }
    site = read_site(
        options.site, **{key: value for key, value in changes.items() if value is not None}
    )
    if not options.lockstep:
        site, _ = with_newest_edits(site)  # a no-fly zone holds for this flight too
    premises = open_premises(site)
    out = Path(options.out or time.strftime("identification/%Y-%m-%d_%H-%M-%S"))
    steps, flown, outcome = _fly(premises, options, out)
    if outcome != "completed":
        console.print(
            f"[bold]given up[/bold]: {outcome}; nothing was fitted (the recording is in {out})"
        )
        return 1
    return _conclude(premises, steps, flown, out)


def _fly(
    premises: Premises, options: argparse.Namespace, out: Path
) -> tuple[list[PilotStep], tuple[Flown, ...], str]:
    from housefly.app.compiling import Part, compile_once
    from housefly.app.identify_flight import (
        BLOCK_PATIENCE,
        Errand,
        fly_in_lock_step,
        fly_over_wires,
    )
    from housefly.app.ports import refuse_taken_ports
    from housefly.lab.identification.box import find_box
    from housefly.lab.identification.maneuver import Maneuver
    from housefly.lab.identification.pattern import blocks, largest_excursion
    from housefly.record.recorder import FlightRecorder

    site, drone = premises.site, premises.site.drone
    plan = blocks(options.repeats, site.limits.tilt_max)
    needed = MARGIN + largest_excursion(
        plan, drone.attitude_lag, drone.attitude_gain, drone.drag, drone.command_delay
    )
    reach = needed if options.box is None else 0.5 * options.box
    if reach < needed:
        raise ConfigError(
            "--box",
            f"is {2 * reach:g} m; the blocks may take the drone further: at least"
            f" {2 * needed:.2f} m",
        )
    start = premises.room.home if options.at is None else _place(premises, options.at)
    box = find_box(premises.grid, start, reach, site.map.flight_height)
    x, y = box.centre
    length = sum(block.duration + 2.5 for block in plan)
    where = f"a box of {2 * box.reach:.2f} m around ({x:.2f}, {y:.2f}), {box.height:.1f} m high"
    console.print(f"{len(plan)} blocks in {where}; about {length:.0f} s")
    if not options.lockstep:
        refuse_taken_ports(site, web=False)
    compile_once(Part.CHAIN, console.print)
    recorder = FlightRecorder(out, site, premises.room, premises.grid)
    errand = Errand(box, Maneuver(plan, box), 120.0 + BLOCK_PATIENCE * len(plan))
    steps: list[PilotStep] = []
    outcome = "failed"
    try:
        with _progress(len(plan)) as advance:

            def on_step(step: PilotStep) -> None:
                steps.append(step)
                recorder.step(step)
                advance(errand.maneuver.done, step.outputs.phase.value)

            if options.lockstep:
                from housefly.twin.world import SimulatedWorld

                outcome = fly_in_lock_step(
                    premises, SimulatedWorld(premises.site, premises.room), errand, on_step
                )
            else:
                logs = out / "logs"
                logs.mkdir(exist_ok=True)
                outcome = fly_over_wires(premises, errand, logs, on_step)
    finally:
        recorder.finish(outcome)
        _keep(out, tuple(errand.maneuver.flown))
    return steps, tuple(errand.maneuver.flown), outcome


def _conclude(
    premises: Premises, steps: Iterable[PilotStep], flown: tuple[Flown, ...], out: Path
) -> int:
    from housefly.config.profile import write_profile
    from housefly.lab.identification.picture import draw_fit
    from housefly.lab.identification.result import Limits, identify
    from housefly.lab.identification.samples import samples_of

    site = premises.site
    limits = Limits(site.limits.tilt_max, site.limits.vertical_speed_max, site.limits.yaw_rate_max)
    with console.status("fitting"):
        found = identify(samples_of(steps, flown, site.tracking.body), limits)
    if found.constants:
        _tell(found, premises)
        png, _ = draw_fit(found, out / "fit")
        console.print(f"drawn: {png}", soft_wrap=True)
    if found.problems:
        console.print("[bold]no profile[/bold]: the data cannot tell")
        for problem in found.problems:
            console.print(f"  {problem}")
        return 1
    profile = out / "drone.toml"
    write_profile(profile, found.constants, _measured(found, premises))
    console.print(
        f'written: {profile}\nuse it:  [drone] profile = "{profile}" in a site file, or housefly'
        f" gains --profile {profile}",
        soft_wrap=True,
        markup=False,
    )
    return 0


def _tell(found: Identified, premises: Premises) -> None:
    from rich.table import Table

    from housefly.config.profile import CONSTANTS

    table = Table(box=None, pad_edge=False)
    for heading in ("constant", "value", "95 % interval", "unit", "the site has"):
        table.add_column(heading)
    for key, interval in found.constants.items():
        known = CONSTANTS[key]
        present = getattr(premises.site.drone, key)
        inside = "" if interval.low <= present <= interval.high else " (outside)"
        span = f"{interval.low:.3g} to {interval.high:.3g}"
        table.add_row(key, f"{interval.value:.3g}", span, known.unit, f"{present:.3g}{inside}")
    console.print(table)
    assert found.tilt is not None
    console.print(
        f"left over: {1000 * found.tilt.angle_noise:.1f} mrad in angle,"
        f" {1000 * found.tilt.place_noise:.1f} mm in position; the delay holds half of the drone's"
        " 30 ms command period on average"
    )


def _measured(found: Identified, premises: Premises) -> dict[str, str]:
    assert found.tilt is not None
    kinds = ", ".join(
        f"{sum(b.block.axis is axis for b in found.blocks)} {axis.value}"
        for axis in dict.fromkeys(b.block.axis for b in found.blocks)
    )
    rate = sum(block.at.size for block in found.blocks) / sum(
        block.block.duration for block in found.blocks
    )
    return {
        "when": time.strftime("%Y-%m-%d %H:%M"),
        "site": premises.site.name,
        "drone": "simulated" if premises.site.twin.enabled else premises.site.drone.kind,
        "blocks": kinds,
        "tracking": f"{rate:.0f} frames per second",
        "left_over": (
            f"{1000 * found.tilt.angle_noise:.2f} mrad, {1000 * found.tilt.place_noise:.2f} mm"
        ),
    }


def _keep(out: Path, flown: tuple[Flown, ...]) -> None:
    rows = [
        {"axis": own.block.axis.value, "amplitude": own.block.amplitude, "part": own.block.part, "signs": own.block.signs,
         "tail": own.block.tail, "began": own.began}
        for own in flown
    ]  # fmt: skip
    (out / BLOCKS).write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")


def _read(folder: Path) -> tuple[list[PilotStep], tuple[Flown, ...]]:
    from housefly.lab.identification.pattern import Axis, Block
    from housefly.lab.identification.samples import Flown
    from housefly.record.replay import replay

    try:
        rows = json.loads((folder / BLOCKS).read_text(encoding="utf-8"))
        flown = tuple(
            Flown(
                Block(
                    Axis(row["axis"]),
                    float(row["amplitude"]),
                    float(row["part"]),
                    tuple(map(float, row["signs"])),
                    float(row["tail"]),
                ),
                float(row["began"]),
            )
            for row in rows
        )
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise RecordingError(f"{folder / BLOCKS} is no list of blocks: {error}") from error
    return list(replay(folder)), flown


def _place(premises: Premises, name: str) -> tuple[float, float]:
    try:
        return premises.room.place(name).viewpoint
    except KeyError as error:
        raise ConfigError("--at", str(error.args[0])) from error


def _progress(blocks: int) -> Any:
    from contextlib import contextmanager

    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

    @contextmanager
    def shown() -> Any:
        columns = (
            TextColumn("{task.description:<16}"),
            BarColumn(24),
            MofNCompleteColumn(),
            TextColumn("blocks"),
            TimeElapsedColumn(),
        )
        with Progress(*columns, console=console, transient=not console.is_terminal) as progress:
            task = progress.add_task("starting", total=blocks)
            last: list[Any] = [None]

            def advance(done: int, phase: str) -> None:
                if last[0] != (done, phase):
                    last[0] = (done, phase)
                    progress.update(task, completed=done, description=phase)

            yield advance

    return shown()
