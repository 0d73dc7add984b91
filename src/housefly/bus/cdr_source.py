"""Grows the source of a function that reads or writes one message type in CDR.

Between two parts of variable length stands a run of plain numbers, which one ``struct`` reads or
writes. How it is padded depends on where it begins, so there are eight of each, one for every
remainder of the position.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from itertools import count
from struct import Struct, calcsize
from typing import Any

BASE_CODES = {
    "bool": "?",
    "byte": "b",
    "char": "B",
    "int8": "b",
    "int16": "h",
    "int32": "i",
    "int64": "q",
    "uint8": "B",
    "uint16": "H",
    "uint32": "I",
    "uint64": "Q",
    "float32": "f",
    "float64": "d",
}
"""What ``struct`` calls the plain types of ROS."""
_LONGEST = 8
"""Nothing is aligned to more [bytes]."""


class CdrSource:
    """Lines of a function body, the constants they use, and the run that is not read yet.

    Args:
        order: "<" or ">", as of ``struct``.
        run_line: makes of a struct's name, the run's number and the run's expressions the line that
            reads or writes the run at ``pos``.
    """

    def __init__(self, order: str, run_line: Callable[[str, int, Sequence[str]], str]) -> None:
        self.constants: dict[str, Any] = {}
        self._order, self._run_line = order, run_line
        self._lines: list[str] = []
        self._depth = 1
        self._numbers = count()
        self._run = next(self._numbers)
        self._codes: list[str] = []
        self._values: list[str] = []

    def name(self) -> str:
        """Return a name that nothing has yet."""
        return f"v{next(self._numbers)}"

    def constant(self, value: object) -> str:
        """Return the name of a constant."""
        name = f"C{next(self._numbers)}"
        self.constants[name] = value
        return name

    def line(self, text: str) -> None:
        """Append a line at the present depth."""
        self._lines.append("    " * self._depth + text)

    @contextmanager
    def block(self, head: str) -> Iterator[None]:
        """Append a head, and what is appended meanwhile below it."""
        self.line(head)
        self._depth += 1
        yield
        self.flush()
        self.line("pass")
        self._depth -= 1

    def number(self, code: str, value: str = "") -> str:
        """Append a number to the run; returns what it is called once the run was read.

        Args:
            code: of ``struct``.
            value: what is written, as an expression.
        """
        self._codes.append(code)
        self._values.append(value)
        return f"r{self._run}[{len(self._codes) - 1}]"

    def flush(self) -> None:
        """End the run."""
        if not self._codes:
            return
        table = self.constant(_padded(self._order, self._codes))
        self.line(f"s = {table}[pos & {_LONGEST - 1}]")
        self.line(self._run_line("s", self._run, self._values))
        self.line("pos += s.size")
        self._run, self._codes, self._values = next(self._numbers), [], []

    def function(self, head: str, result: str) -> Callable[..., Any]:
        """Return the function of this head, body and result."""
        self.flush()
        self.line(f"return {result}")
        source = "\n".join((f"def made({head}):", *self._lines))
        exec(compile(source, "<cdr>", "exec"), self.constants)
        made: Callable[..., Any] = self.constants["made"]
        return made


def _padded(order: str, codes: Sequence[str]) -> tuple[Struct, ...]:
    """Return the structs of a run, by the remainder of the position at which it begins."""
    return tuple(Struct(order + _form(codes, start)) for start in range(_LONGEST))


def _form(codes: Sequence[str], at: int) -> str:
    parts = []
    for code in codes:
        size = calcsize(f"<{code}")
        padding = -at % size
        parts.append(f"{padding}x{code}" if padding else code)
        at += padding + size
    return "".join(parts)
