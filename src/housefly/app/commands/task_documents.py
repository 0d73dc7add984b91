"""``housefly task check``, ``rehearse``, ``import-rpn``: documents of tasks, before they fly."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

from housefly.app.commands.asked_room import DEFAULT_SITE, add_asked_site
from housefly.app.commands.subcommand import CommandGroup, Subcommand
from housefly.app.commands.tasks import running_tasks
from housefly.app.terminal import note_console, plain_console
from housefly.errors import ConfigError, LinkError

if TYPE_CHECKING:
    from housefly.tasks.api.values import RehearsalReport


def _add_check_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help="YAML file of a task, or a folder of them")


def _check(options: Namespace) -> int:
    """Say what is wrong with a document, or what it takes."""
    from housefly.tasks.document.library import SHIPPED, linked, load_library, read_task, text_of

    if options.file.is_dir():
        library = load_library(options.file)
        ours = [one for one in library.values() if (options.file / one.source).exists()]
    else:
        document = read_task(text_of(options.file), options.file.name)
        shipped = load_library(None)
        is_shipped = options.file.resolve().parent == SHIPPED
        if document.name in shipped and not (document.overrides or is_shipped):
            raise ConfigError(
                "name",
                f"{document.name} ships with Housefly; name it otherwise, or say overrides: true",
                options.file.name,
            )
        ours = [linked(shipped | {document.name: document})[document.name]]
    for document in ours:
        info = document.info()
        flies = "flies" if info.flies else "flies nothing"
        plain_console.print(f"{info.name}: {info.title}; {flies}", soft_wrap=True)
        for parameter in info.parameters:
            unit = f" [{parameter.unit}]" if parameter.unit else ""
            needed = "needed" if parameter.required else f"default {parameter.default}"
            plain_console.print(
                f"  {parameter.name}: {parameter.type}{unit}, {needed}; {parameter.about}",
                soft_wrap=True,
            )
    return 0


def _add_rehearse_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("service", help="as `housefly tasks --services` lists them")
    parser.add_argument("parameters", nargs="*", metavar="NAME=VALUE", help="of the service")
    add_asked_site(parser)


def _rehearse(options: Namespace) -> int:
    """Rehearse a service in the room as it is now; exit code 0 when it may fly."""
    from housefly.app.task_words import rehearsal_line

    parameters = dict(_parameter(text) for text in options.parameters)
    try:
        with running_tasks(options) as tasks:
            report = tasks.rehearse(options.service, **parameters)
    except LinkError:
        site = options.site or DEFAULT_SITE
        note_console.print(
            f"no room is running: this is for {site} as it is modelled, nobody in it", style="dim"
        )
        report = _rehearsed_offline(site, options.service, parameters)
    plain_console.print(rehearsal_line(report), soft_wrap=True)
    if report.may_fly:
        plain_console.print(report.words, soft_wrap=True)
    return 0 if report.may_fly else 1


def _rehearsed_offline(site: str, service: str, parameters: dict[str, str]) -> RehearsalReport:
    from housefly.app.compiling import CompiledPart, compile_once
    from housefly.lab.rehearsal.rehearsed_flight import RehearsedSite
    from housefly.lab.rehearsal.room_now import RoomNow
    from housefly.sites.loaded_site import load_site
    from housefly.tasks.document.library import bind
    from housefly.tasks.document.open_library import OpenLibrary

    loaded = load_site(site)
    own = loaded.site.tasks.documents
    task = bind(OpenLibrary(Path(own) if own else None).document(service), parameters)
    compile_once(CompiledPart.CHAIN, plain_console.print)
    return RehearsedSite(loaded).rehearse(task, RoomNow(), _nobody)


def _nobody(question: Any) -> NoReturn:
    raise LinkError("no room is running: nobody remembers anything")


def _parameter(text: str) -> tuple[str, str]:
    name, found, value = text.partition("=")
    if not found or not name:
        raise ConfigError("parameters", f"is {text!r}; allowed: NAME=VALUE, as subject=sofa")
    return name, value


def _add_import_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("text", help="task string of ROS-TMS, quoted: '9001$pid 9007$pid +'")
    parser.add_argument("--name", required=True, help="of the new task: small letters, digits, _")
    parser.add_argument("--title", default="", help="of the new task, for people")
    parser.add_argument(
        "--called",
        action="append",
        default=[],
        metavar="ID=NAME",
        help="what this room calls an id of their database; repeatable",
    )
    parser.add_argument("--tell", action="store_true", help="ask people for what a drone cannot do")
    parser.add_argument("--out", type=Path, metavar="FILE", help="write it there, not to screen")


def _import(options: Namespace) -> int:
    """Print a task string of ROS-TMS as a document, or write it into a file."""
    from housefly.tasks.document.rpn_import import import_rpn

    names = dict(_called(text) for text in options.called)
    document = import_rpn(options.text, options.name, options.title, names, options.tell)
    if options.out is None:
        plain_console.print(document, soft_wrap=True, end="")
        return 0
    options.out.write_text(document, encoding="utf-8")
    plain_console.print(f"written: {options.out}; `housefly task check {options.out}`")
    return 0


def _called(text: str) -> tuple[int, str]:
    number, _, name = text.partition("=")
    if not number.isdecimal() or not name:
        raise ConfigError("--called", f"is {text!r}; allowed: ID=NAME, as 20001=cup")
    return int(number), name


TASK_COMMANDS = CommandGroup(
    name="task",
    help="documents of tasks: check, rehearse, import",
    metavar="WHAT",
    commands=(
        Subcommand(
            name="check",
            help="is a document right, and what does it take",
            description=(
                "Read a task document (YAML), or a folder of them; say the first thing that is"
                " wrong, with its line, or what each takes. docs/tasks.md teaches them."
            ),
            add_arguments=_add_check_arguments,
            run=_check,
        ),
        Subcommand(
            name="rehearse",
            help="would it fly, how long, how near to anything; nothing flies",
            description=(
                "Fly a service in lock step in the room as it is now, people and things"
                " included; nothing flies for real. Exit code 0 when it may fly."
            ),
            add_arguments=_add_rehearse_arguments,
            run=_rehearse,
            epilog="example:\n  housefly task rehearse look subject=refrigerator\n",
        ),
        Subcommand(
            name="import-rpn",
            help="turn a task string of ROS-TMS into a document",
            description=(
                "Turn a reverse-Polish task string of ROS-TMS into a task document (docs/tasks.md)."
            ),
            add_arguments=_add_import_arguments,
            run=_import,
        ),
    ),
)
