"""``housefly replay``: give a recording to a fresh pilot and compare every command."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path

from housefly.app.commands.subcommand import Subcommand
from housefly.app.terminal import console


def _add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("recording", metavar="DIR|flight.mcap", help="a recorded flight")
    parser.add_argument(
        "--site", metavar="SITE", help="site to fly it with (default: the one recorded beside it)"
    )


def _run(options: Namespace) -> int:
    from housefly.app.compiling import CompiledPart, compile_once
    from housefly.app.loaded_site import open_site, read_site
    from housefly.app.replaying import recorded_site, verify_recording

    recording = Path(options.recording)
    recording = recording / "flight.mcap" if recording.is_dir() else recording
    site = read_site(options.site) if options.site else recorded_site(recording)
    compile_once(CompiledPart.CHAIN, console.print)
    verdict = verify_recording(recording, open_site(site))
    if verdict.missing:
        console.print(
            f"{verdict.missing} steps are missing in the recording: it cannot replay bit for bit"
            " from there on"
        )
    if verdict.difference is not None:
        console.print(f"differs: {verdict.difference}", markup=False)
        return 1
    console.print(f"{verdict.steps} steps replayed; every command is the same, bit for bit")
    return 0


REPLAY_COMMAND = Subcommand(
    name="replay",
    help="give a recording to a fresh pilot and compare every command",
    description=(
        "Feed the inputs of a recorded flight to a fresh pilot. Exit code 0 when every command"
        " is the same, bit for bit."
    ),
    add_arguments=_add_arguments,
    run=_run,
)
