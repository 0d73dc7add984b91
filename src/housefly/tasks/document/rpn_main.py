"""Prints a task string of ROS-TMS as a task document."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence

from housefly.errors import HouseflyError
from housefly.tasks.document.rpn_import import import_rpn


def main(arguments: Sequence[str] | None = None) -> int:
    """Print the document; return 0, or 2 when the string cannot be imported."""
    parser = argparse.ArgumentParser(
        prog="rpn_main", description="Turn a task string of ROS-TMS into a task document."
    )
    parser.add_argument("text", help="the task string, such as '9001$pid +'")
    parser.add_argument("--name", required=True, help="of the new task: small letters and _")
    parser.add_argument("--title", default="", help="for people")
    parser.add_argument("--tell", action="store_true", help="ask people for what a drone cannot do")
    parser.add_argument(
        "--call",
        action="append",
        default=[],
        metavar="ID=NAME",
        help="what the room calls an id of their database, such as 6011=refrigerator",
    )
    given = parser.parse_args(arguments)
    try:
        names = dict(_named(pair) for pair in given.call)
        print(import_rpn(given.text, given.name, given.title, names, given.tell), end="")
    except (HouseflyError, ValueError) as error:
        print(error, file=sys.stderr)
        return 2
    return 0


def _named(pair: str) -> tuple[int, str]:
    number, _, name = pair.partition("=")
    if not number.isdecimal() or not name:
        raise ValueError(f"{pair[:40]!r}: expected ID=NAME, such as 6011=refrigerator")
    return int(number), name


if __name__ == "__main__":
    sys.exit(main())
