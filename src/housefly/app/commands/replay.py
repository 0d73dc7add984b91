"""``housefly replay``: give a recording to a fresh pilot and compare every command."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path

from housefly.app.commands.subcommand import Subcommand
from housefly.app.terminal import console

_CUT_OFF = 3
"""Exit code: what is there is the same, but not all of it is there."""


def _add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("recording", metavar="DIR|flight.mcap", help="a recorded flight")
    parser.add_argument(
        "--site", metavar="SITE", help="site to fly it with (default: the one recorded beside it)"
    )


def _run(options: Namespace) -> int:
    from housefly.app.compiling import CompiledPart, compile_once
    from housefly.app.replaying import recorded_site, verify_recording
    from housefly.sites.loaded_site import open_site, read_site

    recording = Path(options.recording)
    recording = recording / "flight.mcap" if recording.is_dir() else recording
    site = read_site(options.site) if options.site else recorded_site(recording)
    compile_once(CompiledPart.CHAIN, console.print)
    verdict = verify_recording(recording, open_site(site))
    if verdict.missing:
        console.print(
            f"{verdict.missing} steps are missing in the recording (it began late, or the disk was"
            " too slow): from there on another pilot may rightly decide otherwise"
        )
    if verdict.difference is not None:
        console.print(f"differs: {verdict.difference}", markup=False)
        return _CUT_OFF if verdict.missing else 1
    if not verdict.is_whole or (verdict.share or 1.0) < 1.0:
        recorded, share = verdict.recorded, 100.0 * (verdict.share or 0.0)
        there = f"{verdict.steps} steps"
        if recorded is not None:
            there = f"{verdict.steps} of {recorded} steps ({share:.3g} %)"
        console.print(
            f"the recording is cut off: {there} are there; every command in them is the same, bit"
            " for bit, and of the rest nothing is known (a cut copy, a full disk, a power cut?)"
        )
        return _CUT_OFF
    console.print(f"{verdict.steps} steps replayed; every command is the same, bit for bit")
    return 0


REPLAY_COMMAND = Subcommand(
    name="replay",
    help="give a recording to a fresh pilot and compare every command",
    description=(
        "Feed the inputs of a recorded flight to a fresh pilot. Exit code 0 when every command"
        " is the same, bit for bit; 1 when one differs; 3 when the recording is cut off, or"
        " when steps are missing before one that differs."
    ),
    add_arguments=_add_arguments,
    run=_run,
)
