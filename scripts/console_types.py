"""Writes the console's TypeScript types of all messages: ``python scripts/console_types.py``."""

from __future__ import annotations

import dataclasses
import types
from enum import Enum
from pathlib import Path
from typing import Annotated, Any, Literal, Union, get_args, get_origin, get_type_hints

from housefly import web
from housefly.hub.api import answers as room_answers
from housefly.messages.words import Words
from housefly.tasks.api.answers import TaskAnswer
from housefly.web.api.coverage_layer import CoverageView
from housefly.web.api.edit_service import EditsView
from housefly.web.api.simulated_bell import BellView
from housefly.web.api.simulated_room import SimulationView
from housefly.web.flights.flight_book import FlightReplay, FlightsView
from housefly.web.messages.client_messages import ClientMessage
from housefly.web.messages.server_messages import ServerMessage
from housefly.web.new_site.draft_answers import HeardView, OpenedView, WrittenView
from housefly.web.new_site.draft_view import DraftView
from housefly.web.sockets.consoles import DronesView

_WIRE_FOLDER = Path(web.__file__).parent / "client" / "src" / "wire"
_MESSAGES_FILE = _WIRE_FOLDER / "messages.ts"
_ROOM_MESSAGES_FILE = _WIRE_FOLDER / "room-messages.ts"
_TASK_MESSAGES_FILE = _WIRE_FOLDER / "task-messages.ts"
_DRAFT_MESSAGES_FILE = _WIRE_FOLDER / "draft-messages.ts"
_HEADER = "// Generated from {source} by `python scripts/console_types.py`. Do not edit.\n"
_LINE_LENGTH = 100
_PLAIN: dict[Any, str] = {
    float: "number",
    int: "number",
    str: "string",
    bool: "boolean",
    types.NoneType: "null",
}
_SAID = """\
/** Words of the server: of ours the template and its values, of another version a text. */
export type Said = string | SaidWords;

export interface SaidWords extends Array<Said | { n: string }> {
  0: string;
}
"""


def generated_files() -> dict[Path, str]:
    """Return the text of every generated file."""
    return {
        _MESSAGES_FILE: _socket_types(),
        _ROOM_MESSAGES_FILE: _room_types(),
        _TASK_MESSAGES_FILE: _text("housefly/tasks/api", {"TaskAnswer": TaskAnswer}),
        _DRAFT_MESSAGES_FILE: _draft_types(),
    }


def _socket_types() -> str:
    """Return the TypeScript text of all messages of the socket and of every value inside them."""
    unions = {"ClientMessage": ClientMessage, "ServerMessage": ServerMessage}
    return _text("web/*_messages.py", unions)


def _room_types() -> str:
    """Return the TypeScript text of the answers of the room's API and of its news."""
    unions = {
        "RoomAnswer": room_answers.Answer
        | CoverageView
        | EditsView
        | BellView
        | SimulationView
        | FlightsView
        | FlightReplay
        | DronesView,
        "RoomNews": room_answers.News,
    }
    return _text("housefly/hub/api/answers.py", unions)


def _draft_types() -> str:
    """Return the TypeScript text of the answers to the page of ``housefly new``."""
    unions = {"DraftAnswer": DraftView | HeardView | WrittenView | OpenedView}
    return _text("housefly/web/new_site", unions, whole=True)


def _text(source: str, unions: dict[str, Any], *, whole: bool = False) -> str:
    """Return the declarations; ``whole`` says that browsers always send every key."""
    writer = _Writer(whole=whole)
    lines = [_type_alias(name, writer.name(union)) for name, union in unions.items()]
    return "\n".join([_HEADER.format(source=source), *writer.declarations.values(), *lines])


def _type_alias(name: str, union: str) -> str:
    """Return a declaration; a long union gets one line a member."""
    line = f"export type {name} = {union};\n"
    if len(line) <= _LINE_LENGTH:
        return line
    members = union.replace(" | ", "\n  | ")
    return f"export type {name} =\n  | {members};\n"


class _Writer:
    """Collects one declaration a type, in the order in which they are needed."""

    def __init__(self, *, whole: bool) -> None:
        self.declarations: dict[str, str] = {}
        self._whole = whole

    def name(self, kind: Any) -> str:
        if kind in _PLAIN:
            return _PLAIN[kind]
        if kind is Words:
            self.declarations["Said"] = _SAID
            return "Said"
        origin, arguments = get_origin(kind), get_args(kind)
        if origin is Annotated:
            return self.name(arguments[0])
        if origin is Literal:
            return " | ".join(f'"{value}"' for value in arguments)
        if origin in (Union, types.UnionType):
            return " | ".join(self.name(argument) for argument in arguments)
        if origin is tuple:
            return self._tuple(arguments)
        if origin is dict:
            return f"Record<string, {self.name(arguments[1])}>"
        return self._declared(kind)

    def _tuple(self, arguments: tuple[Any, ...]) -> str:
        if arguments[-1] is Ellipsis:
            inner = self.name(arguments[0])
            return f"({inner})[]" if " | " in inner else f"{inner}[]"
        return f"[{', '.join(self.name(argument) for argument in arguments)}]"

    def _declared(self, kind: type) -> str:
        if kind.__name__ not in self.declarations:
            self.declarations[kind.__name__] = ""
            text = self._enum(kind) if issubclass(kind, Enum) else self._interface(kind)
            # Dependencies were declared meanwhile; move this one behind them.
            del self.declarations[kind.__name__]
            self.declarations[kind.__name__] = text
        return kind.__name__

    def _enum(self, kind: type[Enum]) -> str:
        return _type_alias(kind.__name__, " | ".join(f'"{member.value}"' for member in kind))

    def _interface(self, kind: Any) -> str:
        hints = get_type_hints(kind, include_extras=True)
        from_browser = hasattr(kind, "__pydantic_config__") and not self._whole
        lines = []
        for item in dataclasses.fields(kind):
            optional = "?" if from_browser and item.default is not dataclasses.MISSING else ""
            lines.append(f"  {item.name}{optional}: {self.name(hints[item.name])};")
        return "\n".join([f"export interface {kind.__name__} {{", *lines, "}\n"])


if __name__ == "__main__":
    _WIRE_FOLDER.mkdir(parents=True, exist_ok=True)
    for path, text in generated_files().items():
        path.write_text(text, encoding="utf-8")
