"""The command line: what to type, and what each thing does."""

from __future__ import annotations

import argparse
import atexit
import errno
import gc
import os
import signal
import sys
from contextlib import suppress
from functools import cache
from itertools import pairwise

from housefly.app.commands.ask import HISTORY_COMMAND, SENSORS_COMMAND, WATCH_COMMAND, WHERE_COMMAND
from housefly.app.commands.ask_state import IS_COMMAND, NIGHTS_COMMAND, WHO_COMMAND
from housefly.app.commands.campaign import CAMPAIGN_COMMAND
from housefly.app.commands.cert import CERT_COMMAND
from housefly.app.commands.clips import CLIPS_COMMANDS
from housefly.app.commands.doctor import DOCTOR_COMMAND
from housefly.app.commands.export import EXPORT_COMMAND
from housefly.app.commands.fly import FLY_COMMAND
from housefly.app.commands.gains import GAINS_COMMAND
from housefly.app.commands.identify import IDENTIFY_COMMAND
from housefly.app.commands.mcp import MCP_COMMAND
from housefly.app.commands.memory import MEMORY_COMMANDS
from housefly.app.commands.new import NEW_COMMAND
from housefly.app.commands.plan import PLAN_COMMAND
from housefly.app.commands.preflight import PREFLIGHT_COMMAND
from housefly.app.commands.replay import REPLAY_COMMAND
from housefly.app.commands.report import REPORT_COMMAND
from housefly.app.commands.reproduce import REPRODUCE_COMMAND
from housefly.app.commands.room import ROOM_COMMANDS
from housefly.app.commands.ros2 import ROS2_COMMAND
from housefly.app.commands.rules import RULES_COMMANDS
from housefly.app.commands.run import DEMO_COMMAND, RUN_COMMAND
from housefly.app.commands.safety import SAFETY_COMMAND
from housefly.app.commands.subcommand import SuggestingParser
from housefly.app.commands.task_documents import TASK_COMMANDS
from housefly.app.commands.tasks import ASK_COMMAND, CANCEL_COMMAND, TASKS_COMMAND
from housefly.app.commands.user import USER_COMMANDS
from housefly.config.text import refuse_odd_values, shortened
from housefly.errors import ConfigError, HouseflyError

_COMMANDS = (
    DEMO_COMMAND,
    NEW_COMMAND,
    RUN_COMMAND,
    FLY_COMMAND,
    PREFLIGHT_COMMAND,
    PLAN_COMMAND,
    ROOM_COMMANDS,
    REPLAY_COMMAND,
    REPORT_COMMAND,
    IDENTIFY_COMMAND,
    GAINS_COMMAND,
    ASK_COMMAND,
    TASKS_COMMAND,
    CANCEL_COMMAND,
    TASK_COMMANDS,
    RULES_COMMANDS,
    CLIPS_COMMANDS,
    MCP_COMMAND,
    ROS2_COMMAND,
    WHERE_COMMAND,
    IS_COMMAND,
    WHO_COMMAND,
    NIGHTS_COMMAND,
    HISTORY_COMMAND,
    WATCH_COMMAND,
    SENSORS_COMMAND,
    EXPORT_COMMAND,
    MEMORY_COMMANDS,
    CAMPAIGN_COMMAND,
    REPRODUCE_COMMAND,
    SAFETY_COMMAND,
    CERT_COMMAND,
    USER_COMMANDS,
    DOCTOR_COMMAND,
)

EPILOG = """examples:
  housefly demo                            somebody lives there: ask, ring and fly in the browser
  housefly new mylab                       describe a room of your own; writes its site file
  housefly fly entrance --headless         fly the whole service over real wires, \
record it, write a report
  housefly fly sofa --headless --lockstep  the same on a stepped clock, as fast as the machine can
  housefly plan --from 11.5,1.2 --to entrance --png path.png
  housefly room show --png room.png
  housefly run --site mylab.toml           real hardware: the site file names the addresses
"""


_REMEDIES = {
    errno.ENOSPC: "; free some space, or set TMPDIR to a folder on another disk",
    errno.EROFS: "; name a folder that can be written to",
    errno.EACCES: "; name a folder that this user may write to",
}


@cache
def build_parser() -> argparse.ArgumentParser:
    """Return the parser of all commands; it is built once."""
    parser = SuggestingParser(
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
    arguments = sys.argv[1:] if arguments is None else arguments
    atexit.register(gc.freeze)  # or Python's own end searches all modules for garbage: 0.6 s
    try:
        refuse_odd_values(arguments, key="argument")
        _refuse_empty_words(arguments)
    except ConfigError as error:
        return _refused(str(error))
    parser = build_parser()
    if not arguments:
        parser.print_help()
        return 0
    options = parser.parse_args(arguments)
    # Flights and memories tell who was where: what is written belongs to this user alone.
    before = os.umask(0o077)
    try:
        return _run(options)
    finally:
        os.umask(before)


def _refuse_empty_words(arguments: list[str]) -> None:
    """Raise ConfigError for a word without a letter: of a shell variable that is not set.

    Never does one mean that an option is not given: ``--from=$FLOWN`` must not fly.
    """
    for number, (before, word) in enumerate(pairwise(("", *arguments)), 1):
        if before == "--" or word == "--":
            return
        if not word.strip():
            named = before if before.startswith("-") else f"argument {number}"
        elif word.startswith("--") and "=" in word and not word.partition("=")[2].strip():
            named = word.partition("=")[0]
        else:
            continue
        words = "is empty (a variable that is not set?); allowed: a value, or leave it out"
        raise ConfigError(named, words)


def _run(options: argparse.Namespace) -> int:
    """Run a command; what fails on purpose, or for want of a file or a disk, is told in words."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        # Explicit: a shell that starts a background process makes it ignore SIGINT. Under nohup a
        # closed terminal ends nothing.
        if number != signal.SIGHUP or signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, signal.default_int_handler)
    try:
        return int(options.run(options))
    except HouseflyError as error:
        return _refused(str(error))
    except BrokenPipeError:  # who read our output has left
        return 1
    except OSError as error:
        if error.strerror is None:
            raise
        where = f"{shortened(str(error.filename))}: " if error.filename else ""
        return _refused(f"{where}{error.strerror}{_REMEDIES.get(error.errno or 0, '')}")
    except KeyboardInterrupt:
        return 130


def _refused(words: str) -> int:
    with suppress(OSError):  # its terminal may be gone
        print(f"housefly: {words}", file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main())
