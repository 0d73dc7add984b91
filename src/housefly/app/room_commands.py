"""``housefly where``, ``history``, ``watch``, ``sensors``: ask the room, running or not."""

from __future__ import annotations

import argparse
import time
from collections.abc import Iterator
from contextlib import contextmanager
from datetime import datetime
from typing import TYPE_CHECKING, Any, Protocol

from rich.console import Console
from rich.table import Table

from housefly.app.moments import ALLOWED, moment
from housefly.errors import LinkError

if TYPE_CHECKING:
    from housefly.hub.api.answers import News, Occurrence, SensorAnswer
    from housefly.hub.api.questions import Question

console = Console(highlight=False)
INNER = ("noticed_at", "sigma", "lasted")
"""Facts that are for programs."""


class Room(Protocol):
    """Whoever can be asked."""

    def ask(self, question: Question) -> Any:
        """Return the answer."""
        ...


def add(actions: Any) -> None:
    """Add the commands to the parser."""
    where = _command(
        actions,
        "where",
        run_where,
        "where is a thing",
        "Say where a thing is, who saw it and how long ago.",
    )
    where.add_argument("thing", help="id, name or alias; the beginning is enough")
    where.add_argument("--at", metavar="TIME", help=f"where it was then: {ALLOWED}")
    history = _command(
        actions,
        "history",
        run_history,
        "what happened",
        "List what happened, to one thing or at all; oldest first.",
    )
    history.add_argument(
        "thing", nargs="?", default="", help="id, name or alias (default: everything)"
    )
    history.add_argument(
        "--since", default="1d", metavar="TIME", help=f"from then on: {ALLOWED} (default: 1d)"
    )
    history.add_argument("--until", metavar="TIME", help="up to then (default: now)")
    history.add_argument("--kind", default="", help='only this, for example "door opened"')
    history.add_argument(
        "--limit", type=int, default=200, metavar="N", help="the newest N (default: 200)"
    )
    history.add_argument(
        "--way", action="store_true", help="where the thing was, not what happened to it"
    )
    watch = _command(
        actions,
        "watch",
        run_watch,
        "what happens now",
        "Print what happens as it does, until Ctrl-C.",
    )
    watch.add_argument(
        "--moves", action="store_true", help="also where things are, whenever that changes"
    )
    _command(
        actions,
        "sensors",
        run_sensors,
        "how every sensor does",
        "List sensors with rate, age and what is wrong.",
    )


def _command(
    actions: Any, name: str, run: Any, words: str, description: str
) -> argparse.ArgumentParser:
    parser: argparse.ArgumentParser = actions.add_parser(name, help=words, description=description)
    parser.add_argument(
        "--site",
        default="bsen",
        metavar="SITE",
        help="asked when no room is running (default: bsen)",
    )
    parser.set_defaults(run=run)
    return parser


def run_where(options: argparse.Namespace) -> int:
    """Say where a thing is."""
    from housefly.hub.api.questions import Where
    from housefly.hub.api.room_json import checked

    at = moment(options.at, time.time(), "--at") if options.at else None
    with _room(options.site) as room:
        answer = room.ask(checked(Where(options.thing, at)))
    console.print(answer.words, soft_wrap=True)
    for said in answer.said:
        place = "({:.2f}, {:.2f}, {:.2f}) m".format(*said.position) if said.position else ""
        inside = f"in {said.inside}" if said.inside else ""
        facts = ", ".join(f"{key} {_plain(value)}" for key, value in said.facts.items())
        words = "  ".join(
            part for part in (place, inside, facts, "" if said.valid else "not valid") if part
        )
        console.print(f"  {said.source:<14} {_ago(said.age):<12} {words}", soft_wrap=True)
    return 0


def run_history(options: argparse.Namespace) -> int:
    """List what happened, or where a thing was."""
    from housefly.hub.api.questions import Events, Trajectory
    from housefly.hub.api.room_json import checked

    now = time.time()
    since = moment(options.since, now, "--since")
    until = moment(options.until, now, "--until") if options.until else None
    with _room(options.site) as room:
        if options.way:
            rows = room.ask(checked(Trajectory(options.thing, since, until, every=1.0))).rows[
                -options.limit :
            ]
            for at, x, y, z in rows:
                console.print(f"{_clock(at, now)}  ({x:.2f}, {y:.2f}, {z:.2f}) m")
            return 0
        question = Events(since, until, options.thing, options.kind, limit=options.limit)
        events = room.ask(checked(question)).events
    for event in events:
        console.print(_line(event, now), soft_wrap=True)
    if not events:
        console.print(f"nothing happened since {_clock(since, now)}")
    return 0


def run_watch(options: argparse.Namespace) -> int:
    """Print what happens until Ctrl-C."""
    from housefly.hub.asking.client import RoomClient
    from housefly.hub.asking.discovery import find

    place = find()
    console.print(f"watching {place.site}; Ctrl-C ends")
    try:
        with RoomClient(place.address, place.key, port=place.port) as room:
            for news in room.watch():
                _tell(news, options.moves)
    except KeyboardInterrupt:
        return 0
    return 0


def run_sensors(options: argparse.Namespace) -> int:
    """List the sensors; 0 only when all of them do well."""
    from housefly.hub.api.questions import Sensors

    with _room(options.site) as room:
        answer = room.ask(Sensors())
    table = Table(box=None, pad_edge=False)
    for heading in ("", "sensor", "kind", "rate", "last heard", "what is wrong"):
        table.add_column(heading, overflow="fold")
    for sensor in answer.sensors:
        table.add_row(*_row(sensor))
    if answer.sensors:
        console.print(table)
    else:
        console.print("no sensor is running")
    console.print(f"memory: {answer.memory}")
    return 0 if answer.sensors and all(sensor.connected for sensor in answer.sensors) else 1


@contextmanager
def _room(site: str) -> Iterator[Room]:
    """Yield the room that runs, or its memory when none does."""
    from housefly.hub.asking.client import RoomClient
    from housefly.hub.asking.discovery import find

    try:
        place = find()
    except LinkError:
        from housefly.app.premises import read_site, site_file
        from housefly.hub.offline import OfflineRoom

        console.print("no room is running: this is what its memory holds", style="dim")
        with OfflineRoom(read_site(site), site_file(site).parent) as memory:
            yield memory
    else:
        with RoomClient(place.address, place.key, port=place.port) as client:
            yield client


def _tell(news: News, moves: bool) -> None:
    for event in news.events:
        console.print(_line(event, news.at), soft_wrap=True)
    for thing in news.things if moves else ():
        place = (
            "({:.2f}, {:.2f}, {:.2f}) m".format(*thing.position)
            if thing.position
            else f"in {thing.inside}"
        )
        console.print(
            f"{_clock(news.at, news.at)}  {thing.name}: {place}", style="dim", soft_wrap=True
        )


def _line(event: Occurrence, now: float) -> str:
    cause = f" by {event.cause}" if event.cause else ""
    facts = ", ".join(
        f"{key} {_plain(value)}" for key, value in event.facts.items() if key not in INNER
    )
    sure = "" if event.confidence >= 0.995 else f" ({100 * event.confidence:.0f} % sure)"
    return (
        f"{_clock(event.at, now)}  {event.thing}:"
        f" {event.kind}{cause}{sure}{'; ' + facts if facts else ''}  [{event.source}]"
    )


def _plain(value: str | float | bool) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.3g}" if isinstance(value, float) else str(value)


def _row(sensor: SensorAnswer) -> tuple[str, ...]:
    mark = "ok" if sensor.connected else "LOST"
    rate = f"{sensor.rate_hz:.1f} Hz" if sensor.rate_hz else ""
    return mark, sensor.title or sensor.sensor, sensor.kind, rate, _ago(sensor.age), sensor.problem


def _ago(age: float | None) -> str:
    from housefly.hub.things.words import age_words

    return "never" if age is None else age_words(age)


def _clock(at: float, now: float) -> str:
    when, today = datetime.fromtimestamp(at), datetime.fromtimestamp(now).date()
    return when.strftime("%H:%M:%S" if when.date() == today else "%Y-%m-%d %H:%M:%S")
