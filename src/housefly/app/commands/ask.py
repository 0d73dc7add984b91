"""``housefly where``, ``history``, ``watch``, ``sensors``: ask the room, running or not."""

from __future__ import annotations

import time
from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from housefly.app.commands.asked_room import add_asked_site, asked_room, found_room
from housefly.app.commands.subcommand import Subcommand
from housefly.app.parse_time import TIME_FORMS, parse_time
from housefly.app.room_words import (
    clock_time,
    detailed_event_line,
    event_line,
    moved_line,
    said_line,
    sensor_row,
)
from housefly.app.terminal import new_table, plain_console

if TYPE_CHECKING:
    from housefly.app.commands.asked_room import AnsweringRoom
    from housefly.app.event_words import EventWords
    from housefly.hub.api.answers import News


def _add_where_arguments(parser: ArgumentParser) -> None:
    add_asked_site(parser)
    parser.add_argument("thing", help="id, name or alias; the beginning is enough")
    parser.add_argument("--at", metavar="TIME", help=f"where it was then: {TIME_FORMS}")


def _add_history_arguments(parser: ArgumentParser) -> None:
    add_asked_site(parser)
    parser.add_argument(
        "thing", nargs="?", default="", help="id, name or alias (default: everything)"
    )
    parser.add_argument(
        "--since", default="1d", metavar="TIME", help=f"from then on: {TIME_FORMS} (default: 1d)"
    )
    parser.add_argument("--until", metavar="TIME", help="up to then (default: now)")
    parser.add_argument("--kind", default="", help='only this, for example "door opened"')
    parser.add_argument(
        "--limit", type=int, default=200, metavar="N", help="the newest N (default: 200)"
    )
    parser.add_argument(
        "--details", action="store_true", help="every fact as it is kept, with ids and sources"
    )
    parser.add_argument(
        "--way", action="store_true", help="where the thing was, not what happened to it"
    )


def _add_watch_arguments(parser: ArgumentParser) -> None:
    add_asked_site(parser)
    parser.add_argument(
        "--moves", action="store_true", help="also where things are, whenever that changes"
    )


def _where(options: Namespace) -> int:
    """Say where a thing is."""
    from housefly.hub.api.json import checked_question
    from housefly.hub.api.questions import WhereQuestion

    at = parse_time(options.at, time.time(), "--at") if options.at else None
    with asked_room(options) as room:
        answer = room.ask(checked_question(WhereQuestion(options.thing, at)))
    plain_console.print(answer.words, soft_wrap=True)
    for said in answer.said:
        plain_console.print(said_line(said), soft_wrap=True)
    return 0


def _history(options: Namespace) -> int:
    """List what happened, or where a thing was."""
    from housefly.hub.api.json import checked_question
    from housefly.hub.api.questions import EventsQuestion, TrajectoryQuestion
    from housefly.hub.feed.worth_reading import worth_reading

    now = time.time()
    since = parse_time(options.since, now, "--since")
    until = parse_time(options.until, now, "--until") if options.until else None
    with asked_room(options) as room:
        if options.way:
            track = TrajectoryQuestion(options.thing, since, until, every=1.0)
            rows = room.ask(checked_question(track)).rows[-options.limit :]
            for at, x, y, z in rows:
                plain_console.print(f"{clock_time(at, now)}  ({x:.2f}, {y:.2f}, {z:.2f}) m")
            return 0
        question = EventsQuestion(since, until, options.thing, options.kind, limit=options.limit)
        events = room.ask(checked_question(question)).events
        words = _words_of(room)
    for event in events if options.details else worth_reading(events):
        line = detailed_event_line(event, now) if options.details else event_line(event, now, words)
        plain_console.print(line, soft_wrap=True)
    if not events:
        plain_console.print(f"nothing is kept since {clock_time(since, now)}")
    return 0


def _words_of(room: AnsweringRoom) -> EventWords:
    from housefly.app.event_words import EventWords
    from housefly.hub.api.questions import CatalogueQuestion

    things = room.ask(CatalogueQuestion()).things
    return EventWords({one.thing: one.name for one in things})


def _watch(options: Namespace) -> int:
    """Print what happens until Ctrl-C."""
    from housefly.hub.client.room_client import RoomClient

    place = found_room(options)
    plain_console.print(f"watching {place.site}; Ctrl-C ends")
    try:
        with RoomClient(place.address, place.key, socket=place.socket) as room:
            words = _words_of(room)
            for news in room.watch():
                _print_news(news, words, options.moves)
    except KeyboardInterrupt:
        return 0
    return 0


def _print_news(news: News, words: EventWords, moves: bool) -> None:
    from housefly.hub.feed.worth_reading import worth_reading

    for event in worth_reading(news.events):
        plain_console.print(event_line(event, news.at, words), soft_wrap=True)
    for thing in news.things if moves else ():
        plain_console.print(moved_line(thing, news.at), style="dim", soft_wrap=True)


def _sensors(options: Namespace) -> int:
    """List the sensors; 0 only when all of them do well."""
    from housefly.app.machine_load import OVERLOAD_REMEDY, machine_load
    from housefly.hub.api.questions import SensorsQuestion

    with asked_room(options) as room:
        answer = room.ask(SensorsQuestion())
    headings = ("", "sensor", "kind", "rate", "last heard", "what is wrong")
    table = new_table(headings, overflow="fold")
    for sensor in answer.sensors:
        table.add_row(*sensor_row(sensor))
    if answer.sensors:
        plain_console.print(table)
    else:
        plain_console.print("sensors are heard only while a room runs")
    plain_console.print(f"memory: {answer.memory or 'all is kept'}")
    ill = [one for one in answer.sensors if one.problem or not one.connected]
    if ill and (load := machine_load()).is_too_high:
        plain_console.print(f"likely cause: {load.note}: {load.words}; {OVERLOAD_REMEDY}")
    return 0 if answer.sensors and not ill else 1


WHERE_COMMAND = Subcommand(
    name="where",
    help="where is a thing",
    description="Say where a thing is, who saw it and how long ago.",
    add_arguments=_add_where_arguments,
    run=_where,
)

HISTORY_COMMAND = Subcommand(
    name="history",
    help="what happened",
    description="List what happened, to one thing or at all; oldest first.",
    add_arguments=_add_history_arguments,
    run=_history,
)

WATCH_COMMAND = Subcommand(
    name="watch",
    help="what happens now",
    description="Print what happens as it does, until Ctrl-C.",
    add_arguments=_add_watch_arguments,
    run=_watch,
)

SENSORS_COMMAND = Subcommand(
    name="sensors",
    help="how every sensor does",
    description="List sensors with rate, age and what is wrong.",
    add_arguments=add_asked_site,
    run=_sensors,
)
