"""``housefly is``, ``who``, ``nights``: whether something is so, who is there, who was up."""

from __future__ import annotations

import time
from argparse import ArgumentParser, Namespace

from housefly.app.commands.asked_room import add_asked_site, asked_room
from housefly.app.commands.subcommand import Subcommand
from housefly.app.parse_time import TIME_FORMS, parse_time
from housefly.app.terminal import plain_console
from housefly.errors import ConfigError

_EXIT_CODES = {"yes": 0, "no": 1, "unknown": 3}
"""For scripts; 2 is a question that could not be asked."""
_LEADING = ("is", "are", "the", "a", "an")
_MARKS = "?!."
_DAY = 86_400.0


def _add_is_arguments(parser: ArgumentParser) -> None:
    add_asked_site(parser)
    parser.add_argument(
        "words", nargs="+", metavar="THING STATE", help="stove on, window open, resident in bed ..."
    )
    parser.add_argument("--at", metavar="TIME", help=f"whether it was so then: {TIME_FORMS}")


def _add_who_arguments(parser: ArgumentParser) -> None:
    add_asked_site(parser)
    parser.add_argument(
        "person", nargs="?", default="", help="id, name or alias (default: everybody)"
    )
    parser.add_argument("--at", metavar="TIME", help=f"how it was then: {TIME_FORMS}")


def _add_nights_arguments(parser: ArgumentParser) -> None:
    add_asked_site(parser)
    parser.add_argument(
        "thing", nargs="?", default="", help="a person or a bed (default: every bed)"
    )
    parser.add_argument(
        "--window",
        default="22-6",
        metavar="HOURS",
        help="from which hour to which, local time (default: 22-6)",
    )
    parser.add_argument(
        "--nights", type=int, default=7, metavar="N", help="the last N nights (default: 7)"
    )


def _is(options: Namespace) -> int:
    """Say yes or no; 0 for yes, 1 for no, 3 when nobody knows."""
    from housefly.hub.api.json import checked_question
    from housefly.hub.api.questions import StateQuestion

    thing, state = split_state(options.words)
    at = parse_time(options.at, time.time(), "--at") if options.at else None
    with asked_room(options) as room:
        answer = room.ask(checked_question(StateQuestion(thing, state, at)))
    plain_console.print(answer.words, soft_wrap=True)
    return _EXIT_CODES[answer.answer]


def _who(options: Namespace) -> int:
    """Say who is there, in which posture, doing what; 3 when nobody knows of anybody."""
    from housefly.hub.api.json import checked_question
    from housefly.hub.api.questions import PeopleQuestion

    at = parse_time(options.at, time.time(), "--at") if options.at else None
    with asked_room(options) as room:
        answer = room.ask(checked_question(PeopleQuestion(options.person, at)))
    for person in answer.people:
        plain_console.print(person.words, soft_wrap=True)
    if not answer.people:
        plain_console.print(
            "nobody is known; people are things of kind person, or who a sensor sees"
        )
    is_known = any(person.present != "unknown" for person in answer.people)
    return _EXIT_CODES["yes" if is_known else "unknown"]


def _nights(options: Namespace) -> int:
    """Say how often somebody was up at night."""
    from housefly.hub.api.json import checked_question
    from housefly.hub.api.questions import NightsQuestion

    begin, end = parse_window(options.window)
    if not 1 <= options.nights <= 366:
        raise ConfigError("--nights", f"is {options.nights}; allowed: 1 to 366")
    since = max(0.0, time.time() - options.nights * _DAY)
    question = NightsQuestion(since, options.thing, None, begin, end)
    with asked_room(options) as room:
        answer = room.ask(checked_question(question))
    several = len({night.thing for night in answer.nights}) > 1
    kept = [night for night in answer.nights if night.unknown < night.end - night.begin]
    for night in kept:
        name = f"{night.thing}, " if several else ""
        plain_console.print(f"{name}{night.words}", soft_wrap=True)
    if missing := len(answer.nights) - len(kept):
        plain_console.print(f"nothing was kept of {missing} night{'' if missing == 1 else 's'}")
    if not answer.nights:
        plain_console.print("no bed was occupied, as far as the memory knows; docs/situations.md")
    return 0


def split_state(words: list[str]) -> tuple[str, str]:
    """Return thing and state of words such as "the stove on"; raises ConfigError.

    The longest known state at the end counts: "resident on the floor".
    """
    from housefly.hub.state_queries import STATE_WORDS

    said = " ".join(words).lower().rstrip(f"{_MARKS} ").split()
    while said and said[0] in _LEADING:
        said = said[1:]
    text = " ".join(said)
    for state in STATE_WORDS:
        if text.endswith(f" {state}"):
            return text.removesuffix(f" {state}").removesuffix(" still"), state
    known = ", ".join(sorted(STATE_WORDS))
    raise ConfigError("is", f"{text!r} does not end in a state; allowed: a thing, then {known}")


def parse_window(words: str) -> tuple[float, float]:
    """Return the hours of "22-6" or "22:30-6"; raises ConfigError."""
    parts = [part.partition(":") for part in words.split("-")]
    try:
        begin, end = (float(hour) + float(minutes or 0) / 60.0 for hour, _, minutes in parts)
    except ValueError:
        begin = end = -1.0
    if not (0.0 <= begin <= 24.0 and 0.0 <= end <= 24.0):
        raise ConfigError("--window", f"is {words!r}; allowed: two hours of the day, such as 22-6")
    return begin, end


IS_COMMAND = Subcommand(
    name="is",
    help="yes or no: is the stove on, is the resident up",
    description=(
        "Answer yes or no, with the evidence and its age.\nExit code: 0 yes, 1 no, 3 nobody knows."
    ),
    add_arguments=_add_is_arguments,
    run=_is,
    epilog=(
        "examples:\n"
        "  housefly is stove on\n"
        "  housefly is entrance-door open --at 10:02\n"
        "  housefly is resident in bed\n"
    ),
)

WHO_COMMAND = Subcommand(
    name="who",
    help="who is there, in which posture, doing what",
    description=(
        "Say who is there, sits, lies or may have fallen, since when, how surely.\n"
        "Exit code: 3 when nothing is known of anybody."
    ),
    add_arguments=_add_who_arguments,
    run=_who,
)

NIGHTS_COMMAND = Subcommand(
    name="nights",
    help="how often somebody was up at night",
    description="Say how often somebody left the bed at night and came back, and when.",
    add_arguments=_add_nights_arguments,
    run=_nights,
)
