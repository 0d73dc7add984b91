"""Deletes everything that a memory holds of one person, or of one thing."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass

from housefly.hub.store.database import Database

SOMEBODY = "somebody"
"""What stands in the facts of other events instead of who is forgotten."""
_OF_THING = (
    "DELETE FROM latest WHERE thing = ? OR inside = ?",
    "DELETE FROM tidied WHERE thing = ? OR thing = ?",
    "DELETE FROM alias WHERE thing = ? OR thing = ?",
    "DELETE FROM viewpoint WHERE thing = ? OR thing = ?",
    "DELETE FROM thing WHERE id = ? OR id = ?",
)
_SAMPLES = "FROM sighting WHERE thing = ? OR inside = ?"
_EVENTS = "FROM event WHERE thing = ? OR cause = ?"
_KEY = "at = ? AND kind = ? AND thing = ? AND source = ? AND cause = ?"


@dataclass(frozen=True, slots=True)
class Forgotten:
    """What was deleted: samples, events; and other events in which the name was struck out."""

    samples: int
    events: int
    struck: int


def forget_thing(database: Database, thing: str, names: Iterable[str]) -> Forgotten:
    """Delete where it was, what happened to it and by it, and strike its names out of the rest.

    Args:
        database: of the memory.
        thing: its id.
        names: further names of it, as they may stand in what was said.
    """
    both = (thing, thing)
    with database.transaction():
        samples, events = _count(database, _SAMPLES, both), _count(database, _EVENTS, both)
        database.query(f"DELETE {_SAMPLES}", both)
        database.query(f"DELETE {_EVENTS}", both)
        for statement in _OF_THING:
            database.query(statement, both)
        struck = _strike_out(database, mention_of((thing, *names)))
    return Forgotten(samples, events, struck)


def mention_of(names: Iterable[str]) -> re.Pattern[str]:
    """Return what finds any of some names as whole words, in whatever case."""
    longest_first = sorted({name for name in names if name}, key=len, reverse=True)
    return re.compile(rf"(?<![\w-])({'|'.join(map(re.escape, longest_first))})(?![\w-])", re.I)


def _count(database: Database, rows: str, values: tuple[str, str]) -> int:
    return int(next(iter(database.query(f"SELECT count(*) {rows}", values)))[0])


def _strike_out(database: Database, mention: re.Pattern[str]) -> int:
    found = database.query("SELECT at, kind, thing, source, cause, facts FROM event")
    changed = [
        (mention.sub(SOMEBODY, facts), *key) for *key, facts in found if mention.search(facts)
    ]
    database.many(f"UPDATE event SET facts = ? WHERE {_KEY}", changed)
    return len(changed)
