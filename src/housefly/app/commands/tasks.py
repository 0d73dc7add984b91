"""``housefly ask``, ``tasks``, ``cancel``: ask the room for something, see it done, end it."""

from __future__ import annotations

import os
import re
import sys
import time
from argparse import ArgumentParser, Namespace
from dataclasses import replace
from typing import TYPE_CHECKING

from housefly.app.commands.asked_room import add_asked_site, found_room
from housefly.app.commands.offline_tasks import answer_offline, kept_tasks, shipped_services
from housefly.app.commands.subcommand import Subcommand
from housefly.app.parse_time import TIME_FORMS, parse_time
from housefly.app.terminal import plain_console
from housefly.errors import ConfigError, LinkError

if TYPE_CHECKING:
    from housefly.tasks.api.answers import SentenceAnswer, TaskBoard
    from housefly.tasks.api.values import ServiceInfo, TaskStatus
    from housefly.tasks.client.tasks_client import TasksClient
    from housefly.tasks.intents.intent import Language

_WATCH_PERIOD = 0.5


def running_tasks(options: Namespace) -> TasksClient:
    """Return a client of the tasks of the running room; raises LinkError if there is none."""
    import getpass

    from housefly.tasks.client.tasks_client import TasksClient

    return TasksClient(found_room(options), f"{getpass.getuser()} at the terminal")


def _add_ask_arguments(parser: ArgumentParser) -> None:
    add_asked_site(parser)
    parser.add_argument("words", nargs="+", help="what you would say, quoted or not")
    parser.add_argument(
        "--language", choices=("en", "de", "ja"), help="of the words (default: $LANG's, else en)"
    )
    parser.add_argument(
        "--no-wait", action="store_true", help="say the number of the task and leave"
    )
    parser.add_argument("--no-fly", action="store_true", help="answer only; start nothing")
    parser.add_argument(
        "--drone",
        default="",
        metavar="NAME",
        help="which drone flies, or is ordered (default: any)",
    )


def _check_drone(name: str) -> None:
    """Raise ConfigError for what is no name of a drone; whether there is one, the room knows."""
    from housefly.config.drone import NAME_PATTERN
    from housefly.config.text import shortened

    if name and re.fullmatch(NAME_PATTERN, name) is None:
        raise ConfigError(
            "--drone",
            f"is {shortened(name, 40)!r}; allowed: a name of [[drones]] in the site file: a-z, 0-9,"
            " - and _, a letter first",
        )


def _ask(options: Namespace) -> int:
    """Say a sentence; print its answer, and the task that it starts until it ends."""
    _check_drone(options.drone)
    from housefly.app.task_progress import follow
    from housefly.tasks.api.questions import Sentence
    from housefly.tasks.api.values import RequestSurface, TaskStage

    said = Sentence(
        " ".join(options.words),
        options.language or _language(os.environ.get("LANG", "")),
        surface=RequestSurface.COMMAND_LINE,
        fly=not options.no_fly,
        drone=options.drone,
    )
    try:
        found = running_tasks(options)
    except LinkError:
        answer = answer_offline(options, said)
        _print_answer(answer)
        return 0 if answer.understood else 1
    with found as tasks:
        answer = tasks.ask_tasks(replace(said, by=tasks.by, owner=tasks.owner))
        _print_answer(answer)
        task = answer.task
        if answer.offer is not None and _says_yes():
            task = tasks.request(
                answer.offer.service, answer.offer.drone, **answer.offer.parameters
            )
        if task is None:
            return 0 if answer.understood else 1
        if options.no_wait:
            plain_console.print(f"task {task.id}; `housefly tasks` shows it")
            return 0
        try:
            ended = follow(tasks, task.id)
        except KeyboardInterrupt:
            number = task.id
            plain_console.print(f"task {number} goes on; `housefly cancel {number}` ends it")
            return 130
    return 0 if ended.state is TaskStage.DONE else 1


def _print_answer(answer: SentenceAnswer) -> None:
    plain_console.print(answer.words, soft_wrap=True)
    for suggestion in answer.suggestions:
        plain_console.print(f'  housefly ask "{suggestion}"', soft_wrap=True)


def _language(locale: str) -> Language:
    """Return the language of a locale such as "de_AT.UTF-8", English for one that is not known."""
    known: dict[str, Language] = {"de": "de", "ja": "ja"}
    return known.get(locale[:2].lower(), "en")


def _says_yes() -> bool:
    """Return whether somebody at the terminal says yes."""
    return sys.stdin.isatty() and input("yes / no > ").strip().lower() in ("y", "yes", "ja", "はい")


def _add_tasks_arguments(parser: ArgumentParser) -> None:
    add_asked_site(parser)
    parser.add_argument("--watch", action="store_true", help="again whenever it changes")
    parser.add_argument("--history", action="store_true", help="all that were asked for")
    parser.add_argument(
        "--since", default="1d", metavar="TIME", help=f"of --history: {TIME_FORMS} (default: 1d)"
    )
    parser.add_argument("--services", action="store_true", help="what can be asked for")
    parser.add_argument(
        "--reply",
        nargs=2,
        metavar=("TASK", "CHOICE"),
        help="answer what a task asks: 12 yes",
    )
    parser.add_argument("--pause", type=int, metavar="TASK", help="let it hover where it is")
    parser.add_argument(
        "--continue", type=int, metavar="TASK", dest="proceed", help="go on with it"
    )


def _tasks(options: Namespace) -> int:
    """Print the board, what can be asked for, or what was asked for."""
    from housefly.app.task_words import board_lines, shows_the_same, task_line

    now = time.time()
    since = parse_time(options.since, now, "--since")
    try:
        found = running_tasks(options)
    except LinkError:
        if options.services:
            _print_services(shipped_services(options))
        elif options.history:
            _print_history(kept_tasks(options, since), now)
        else:
            raise
        return 0
    with found as tasks:
        if (changed := _changed_task(tasks, options)) is not None:
            plain_console.print(task_line(changed), soft_wrap=True)
            return 0
        if options.services:
            _print_services(tasks.services())
            return 0
        if options.history:
            _print_history(tasks.task_history(since, limit=1000), now)
            return 0
        shown: TaskBoard | None = None
        while True:
            board = tasks.tasks()
            if shown is None or not shows_the_same(board, shown):
                lines = board_lines(board)
                plain_console.print(
                    "\n".join([*lines, ""] if options.watch else lines), soft_wrap=True
                )
                shown = board
            if not options.watch:
                return 0
            time.sleep(_WATCH_PERIOD)


def _print_services(services: tuple[ServiceInfo, ...]) -> None:
    if not services:
        plain_console.print("nothing: every service flies, and this room has no drone")
    for service in services:
        known = ", ".join(parameter.name for parameter in service.parameters)
        takes = "" if service.problem else f"  [{known}]"
        plain_console.print(f"{service.name:<12} {service.about}{takes}", soft_wrap=True)


def _print_history(newest_first: tuple[TaskStatus, ...], now: float) -> None:
    from housefly.app.task_words import history_line

    for task in reversed(newest_first):
        plain_console.print(history_line(task, now), soft_wrap=True)
        for words in task.report:
            plain_console.print(f"    = {words}", soft_wrap=True)
    if not newest_first:
        plain_console.print("nothing was asked for in that time")


def _changed_task(tasks: TasksClient, options: Namespace) -> TaskStatus | None:
    """Reply to a task, pause or continue it, as the options say; None when they say nothing."""
    from housefly.app.task_progress import find_task

    if options.reply is not None:
        number, choice = options.reply
        if not number.isdigit():
            raise ConfigError("--reply", f"is {number!r}; allowed: the number of a task, a choice")
        question = find_task(tasks, int(number)).question
        return tasks.reply(int(number), choice, question.id if question else "confirm")
    if options.pause is not None:
        return tasks.pause(options.pause)
    if options.proceed is not None:
        return tasks.proceed(options.proceed)
    return None


def _add_cancel_arguments(parser: ArgumentParser) -> None:
    add_asked_site(parser)
    parser.add_argument(
        "task", nargs="?", type=int, default=0, help="its number (default: every open task)"
    )


def _cancel(options: Namespace) -> int:
    """End a task, or all of them."""
    from housefly.app.task_words import task_line

    with running_tasks(options) as tasks:
        ended = tasks.cancel(options.task)
    for task in ended:
        plain_console.print(task_line(task), soft_wrap=True)
    if not ended:
        plain_console.print("no task is open")
    return 0


ASK_COMMAND = Subcommand(
    name="ask",
    help="say what you want: a question is answered, a wish is flown",
    description=(
        "Say a sentence to the room that runs. A question is answered; a wish is rehearsed, then"
        " flown, and its progress is printed until it ends (exit code 0 only if it was done).\n"
        "Whoever may type here may fly: no further question is asked. Ctrl-C leaves the task to"
        " itself; `housefly cancel` ends it, and the drone comes home."
    ),
    add_arguments=_add_ask_arguments,
    run=_ask,
    epilog=(
        'examples:\n  housefly ask "look at the refrigerator"\n  housefly ask where is the cup\n'
        '  housefly ask --language de "schau nach dem Eingang"\n'
        "  housefly tasks --services      what else can be asked for\n"
    ),
)

TASKS_COMMAND = Subcommand(
    name="tasks",
    help="what flies, what waits, what was done",
    description="Print the open tasks with their steps, and those that ended lately.",
    add_arguments=_add_tasks_arguments,
    run=_tasks,
)

CANCEL_COMMAND = Subcommand(
    name="cancel",
    help="end a task; the drone comes home",
    description=(
        "End one task, or every open one. One that flies ends as its document says: the drone"
        " comes home and lands."
    ),
    add_arguments=_add_cancel_arguments,
    run=_cancel,
)
