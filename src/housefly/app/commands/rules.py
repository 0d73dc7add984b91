"""``housefly rules``: list the rules, check a file of them, see what they would have done."""

from __future__ import annotations

import time
from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from housefly.app.commands.asked_room import (
    DEFAULT_SITE,
    add_asked_site,
    asked_room,
    asked_site,
)
from housefly.app.commands.subcommand import CommandGroup, Subcommand
from housefly.app.parse_time import TIME_FORMS, parse_time
from housefly.app.room_words import clock_time
from housefly.app.terminal import plain_console

if TYPE_CHECKING:
    from housefly.config.site import Site
    from housefly.tasks.api.answers import RuleFiring, RulesAnswer, RuleStatus
    from housefly.tasks.api.values import ServiceInfo
    from housefly.tasks.rules.rule import Rule


def _add_check_arguments(parser: ArgumentParser) -> None:
    add_asked_site(parser)
    parser.add_argument("file", type=Path, help="YAML file of rules")


def _add_dry_run_arguments(parser: ArgumentParser) -> None:
    add_asked_site(parser)
    parser.add_argument("--file", type=Path, help="these rules (default: those of the site)")
    parser.add_argument(
        "--since", default="7d", metavar="TIME", help=f"from then on: {TIME_FORMS} (default: 7d)"
    )
    parser.add_argument("--until", metavar="TIME", help="up to then (default: now)")
    parser.add_argument(
        "--all", action="store_true", help="also what the rules did not do, and why"
    )


def _list(options: Namespace) -> int:
    """Print each rule of a site in words; while it runs, also what each did last."""
    running = _running_rules(options)
    known = {one.name: one for one in running or ()}
    rules = _rules_of_site(options.site or DEFAULT_SITE)
    for rule in rules if running is None else (one for one in rules if one.name in known):
        plain_console.print(_rule_line(rule), soft_wrap=True)
        status = known.get(rule.name)
        if status is not None and status.last_at is not None:
            at = clock_time(status.last_at, time.time())
            plain_console.print(f"    {at}: {status.last_words}", soft_wrap=True)
    if running is not None and len(known) < len(rules):
        which = "the others fly" if known else "every rule flies"
        plain_console.print(f"{which}, and this room has no drone")
    return 0


def _check(options: Namespace) -> int:
    """Print the rules of a file in words, and what is wrong with them."""
    from housefly.tasks.rules.rule_file import read_rules, rule_problems

    rules = read_rules(options.file)
    for rule in rules:
        plain_console.print(_rule_line(rule), soft_wrap=True)
    problems = rule_problems(rules, _services_of(asked_site(options)))
    for problem in problems:
        plain_console.print(problem, soft_wrap=True)
    return 1 if problems else 0


def _dry_run(options: Namespace) -> int:
    """Print what the rules would have done with what the room remembers."""
    from housefly.config.house_mode import HouseMode
    from housefly.config.state import tasks_folder
    from housefly.tasks.api.values import ReasonCode
    from housefly.tasks.rules.dry_run import dry_run, stored_events
    from housefly.tasks.rules.room_facts import AskedRoomFacts
    from housefly.tasks.rules.rule_engine import RuleEngine
    from housefly.tasks.rules.rule_file import read_rules
    from housefly.tasks.rules.rule_store import RuleStore

    now = time.time()
    since = parse_time(options.since, now, "--since")
    until = parse_time(options.until, now, "--until") if options.until else now
    site_name = options.site or DEFAULT_SITE
    rules = read_rules(options.file) if options.file else _rules_of_site(site_name)
    site = asked_site(options)
    mode = RuleStore(tasks_folder(site), HouseMode(site.tasks.mode)).load().mode
    with asked_room(options) as room:
        events = stored_events(room.ask, since, until)
        facts = AskedRoomFacts(room.ask, live=False)
        answer = dry_run(RuleEngine(rules), events, since, until, mode, facts)
    shown = [one for one in answer.firings if options.all or one.code is ReasonCode.OK]
    for firing in shown:
        plain_console.print(_firing_line(firing, now), soft_wrap=True)
    fired = sum(firing.code is ReasonCode.OK for firing in answer.firings)
    plain_console.print(
        f"{len(events)} events; the rules would have asked for {fired} flights; nothing flew"
    )
    return 0


def _running_rules(options: Namespace) -> tuple[RuleStatus, ...] | None:
    """Return the rules of a site as it runs; None where it does not."""
    from housefly.errors import LinkError, TaskError
    from housefly.hub.client.discovery import find
    from housefly.tasks.api.questions import RulesQuestion
    from housefly.tasks.client.tasks_client import TasksClient

    try:
        with TasksClient(find(asked_site(options).name)) as tasks:
            found: RulesAnswer = tasks.ask_tasks(RulesQuestion())
    except (LinkError, TaskError):
        return None
    return found.rules


def _rules_of_site(name: str) -> tuple[Rule, ...]:
    from housefly.sites.loaded_site import read_site, site_file
    from housefly.tasks.rules.rule_file import rules_of

    site = read_site(name)
    return rules_of(site_file(name).parent / site.tasks.rules if site.tasks.rules else None)


def _services_of(site: Site) -> dict[str, ServiceInfo]:
    from housefly.tasks.document.open_library import OpenLibrary

    library = OpenLibrary(Path(site.tasks.documents) if site.tasks.documents else None)
    return {each: document.info() for each, document in library.items()}


def _rule_line(rule: Rule) -> str:
    return f"{rule.name}{'' if rule.enabled else ' (off)'}: {rule.words()}"


def _firing_line(firing: RuleFiring, now: float) -> str:
    what = f"{firing.rule}: {firing.service}: {firing.words}"
    return f"{clock_time(firing.at, now)}  {what}  [{firing.cause}]"


RULES_COMMANDS = CommandGroup(
    name="rules",
    help="what the house does by itself",
    metavar="list|check|dry-run",
    default="list",
    commands=(
        Subcommand(
            name="list",
            help="the rules of a site, in words",
            description="List the rules of a site, those that are off too.",
            add_arguments=add_asked_site,
            run=_list,
        ),
        Subcommand(
            name="check",
            help="check a file of rules",
            description="Read a file of rules; print what they say and what is wrong with them.",
            add_arguments=_add_check_arguments,
            run=_check,
        ),
        Subcommand(
            name="dry-run",
            help="what would have happened",
            description=(
                "Send what the room remembers through the rules again; print what they would have"
                " asked for. Nothing flies."
            ),
            add_arguments=_add_dry_run_arguments,
            run=_dry_run,
        ),
    ),
)
