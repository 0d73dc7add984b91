"""The command line: what to type, and what each thing does."""

from __future__ import annotations

import argparse
import signal
import sys

from housefly.app.commands.ask import HISTORY_COMMAND, SENSORS_COMMAND, WATCH_COMMAND, WHERE_COMMAND
from housefly.app.commands.campaign import CAMPAIGN_COMMAND
from housefly.app.commands.doctor import DOCTOR_COMMAND
from housefly.app.commands.fly import FLY_COMMAND
from housefly.app.commands.gains import GAINS_COMMAND
from housefly.app.commands.identify import IDENTIFY_COMMAND
from housefly.app.commands.memory import MEMORY_COMMANDS
from housefly.app.commands.plan import PLAN_COMMAND
from housefly.app.commands.replay import REPLAY_COMMAND
from housefly.app.commands.reproduce import REPRODUCE_COMMAND
from housefly.app.commands.room import ROOM_COMMANDS
from housefly.app.commands.run import DEMO_COMMAND, RUN_COMMAND
from housefly.errors import HouseflyError

_COMMANDS = (
    DEMO_COMMAND,
    RUN_COMMAND,
    FLY_COMMAND,
    PLAN_COMMAND,
    ROOM_COMMANDS,
    REPLAY_COMMAND,
    IDENTIFY_COMMAND,
    GAINS_COMMAND,
    WHERE_COMMAND,
    HISTORY_COMMAND,
    WATCH_COMMAND,
    SENSORS_COMMAND,
    MEMORY_COMMANDS,
    CAMPAIGN_COMMAND,
    REPRODUCE_COMMAND,
    DOCTOR_COMMAND,
)

EPILOG = """examples:
  housefly demo                            fly the simulated room, with a console in the browser
  housefly fly entrance --headless         fly the whole service over real wires, \
record it, write a report
  housefly fly sofa --headless --lockstep  the same on a stepped clock, as fast as the machine can
  housefly plan --from 11.5,1.2 --to entrance --png path.png
  housefly room show --png room.png
  housefly run --site mylab.toml           real hardware: the site file names the addresses
"""


def build_parser() -> argparse.ArgumentParser:
    """Return the parser of all commands."""
    parser = argparse.ArgumentParser(
        prog="housefly",
        description="A room that knows where everything is flies a small drone on errands.",
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)
    for command in _COMMANDS:
        command.add_to(commands)
    return parser


def main(arguments: list[str] | None = None) -> int:
    """Run the command line and return the exit code."""
    options = build_parser().parse_args(arguments)
    for number in (signal.SIGINT, signal.SIGTERM):
        # Explicit: a shell that starts a background process makes it ignore SIGINT.
        signal.signal(number, signal.default_int_handler)
    try:
        return int(options.run(options))
    except HouseflyError as error:
        print(f"housefly: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    sys.exit(main())
