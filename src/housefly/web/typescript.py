"""Writes the console's TypeScript types from the vocabulary: ``python -m housefly.web.typescript``."""

from __future__ import annotations

import dataclasses
import types
from enum import Enum
from pathlib import Path
from typing import Annotated, Any, Literal, Union, get_args, get_origin, get_type_hints

from housefly.web import vocabulary

TARGET = Path(__file__).parent / "client" / "src" / "wire" / "messages.ts"
HEADER = "// Generated from housefly/web/vocabulary.py by `python -m housefly.web.typescript`. Do not edit.\n"
PLAIN: dict[Any, str] = {float: "number", int: "number", str: "string", bool: "boolean", types.NoneType: "null"}


def typescript() -> str:
    """Return the TypeScript text of all messages and of every value inside them."""
    writer = _Writer()
    unions = {"ClientMessage": vocabulary.ClientMessage, "ServerMessage": vocabulary.ServerMessage}
    lines = [f"export type {name} = {writer.name(union)};\n" for name, union in unions.items()]
    return "\n".join([HEADER, *writer.declarations.values(), *lines])


class _Writer:
    """Collects one declaration a type, in the order in which they are needed."""

    def __init__(self) -> None:
        self.declarations: dict[str, str] = {}

    def name(self, kind: Any) -> str:
        if kind in PLAIN:
            return PLAIN[kind]
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
        values = " | ".join(f'"{member.value}"' for member in kind)
        return f"export type {kind.__name__} = {values};\n"

    def _interface(self, kind: Any) -> str:
        hints = get_type_hints(kind, include_extras=True)
        from_browser = hasattr(kind, "__pydantic_config__")
        lines = []
        for item in dataclasses.fields(kind):
            optional = "?" if from_browser and item.default is not dataclasses.MISSING else ""
            lines.append(f"  {item.name}{optional}: {self.name(hints[item.name])};")
        return "\n".join([f"export interface {kind.__name__} {{", *lines, "}\n"])


if __name__ == "__main__":
    TARGET.parent.mkdir(parents=True, exist_ok=True)
    TARGET.write_text(typescript(), encoding="utf-8")
