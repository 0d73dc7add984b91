"""Reads the reverse-Polish task strings of ROS-TMS into a tree.

``9001$oid 9002$oid + 9001$uid +``: subtasks with arguments after ``$``, ``+`` one after the other,
``|`` at the same time; variants stand between ``;``. ROS2-TMS writes the arguments as JSON:
``9300${"announce": "hello"}``.
"""

from __future__ import annotations

import json
import re
from dataclasses import dataclass

from housefly.errors import TaskError
from housefly.tasks.api.values import ReasonCode

LENGTH_MAX = 4_000
"""Longest string [characters]."""
SUBTASKS_MAX = 100
"""Most subtasks in one variant."""
_ID = re.compile(r"\d{4,5}")
_BLACKBOARD = re.compile(r":\s*\(([A-Za-z_][\w.]*)\)")
_OPERATORS = frozenset("+|")


@dataclass(frozen=True, slots=True)
class RpnSubtask:
    """One subtask: its id, its arguments as words, and those that JSON names."""

    id: int
    arguments: tuple[str, ...] = ()
    named: tuple[tuple[str, str | float | bool], ...] = ()

    def argument(self, *names: str) -> str | float | bool | None:
        """Return the first argument of one of these names; None without one."""
        return next((value for key, value in self.named if key in names), None)


@dataclass(frozen=True, slots=True)
class RpnGroup:
    """Several nodes, one after the other or at the same time."""

    is_parallel: bool
    parts: tuple[RpnNode, ...]


RpnNode = RpnSubtask | RpnGroup


def read_rpn(text: str) -> tuple[RpnNode, ...]:
    """Return the variants of a task string.

    Raises:
        TaskError: BAD_PARAMETER; says at which word and what is expected.
    """
    if len(text) > LENGTH_MAX or not text.isprintable():
        raise rpn_error(f"expected one line of at most {LENGTH_MAX} printable letters")
    variants = [_words(part) for part in _parts(text, ";")]
    nodes = tuple(_variant(words) for words in variants if words)
    if not nodes:
        raise rpn_error("there is no subtask in it; expected something like 9001$pid +")
    return nodes


def rpn_error(problem: str) -> TaskError:
    """Return the error for a task string."""
    return TaskError(f"this task string cannot be read: {problem}", ReasonCode.BAD_PARAMETER.value)


def _variant(words: list[str]) -> RpnNode:
    stack: list[RpnNode] = []
    count = 0
    for word in words:
        if word not in _OPERATORS:
            stack.append(_subtask(word))
            count += 1
            if count > SUBTASKS_MAX:
                raise rpn_error(f"more than {SUBTASKS_MAX} subtasks")
        elif len(stack) >= 2:
            second, first = stack.pop(), stack.pop()
            stack.append(_joined(first, second, word == "|"))
        elif not stack:
            raise rpn_error(f"{word} has nothing before it")
        # ROS-TMS writes one subtask alone with an operator, too: 9001$pid +
    if len(stack) != 1:
        raise rpn_error(f"{len(stack)} parts are not joined; each two need a + or | behind them")
    return stack[0]


def _joined(first: RpnNode, second: RpnNode, is_parallel: bool) -> RpnNode:
    parts: tuple[RpnNode, ...] = (first,)
    if isinstance(first, RpnGroup) and first.is_parallel is is_parallel:
        parts = first.parts
    return RpnGroup(is_parallel, (*parts, second))


def _subtask(word: str) -> RpnSubtask:
    number, _, rest = word.partition("$")
    if not _ID.fullmatch(number):
        raise rpn_error(f"{word[:40]!r} is no subtask; expected its id, such as 9001$oid")
    if rest.startswith("{"):
        return RpnSubtask(int(number), named=_json(rest))
    return RpnSubtask(int(number), tuple(rest.split("$")) if rest else ())


def _json(text: str) -> tuple[tuple[str, str | float | bool], ...]:
    """Return JSON arguments; a value (a.b) of their blackboard becomes the text "(a.b)"."""
    try:
        tree = json.loads(_BLACKBOARD.sub(r': "(\1)"', text))
    except (ValueError, RecursionError) as error:
        raise rpn_error(f"{text[:60]!r} are no JSON arguments: {error}") from None
    values = tree.items() if isinstance(tree, dict) else ()
    if not all(isinstance(value, (str, int, float, bool)) for _, value in values):
        raise rpn_error(f"{text[:60]!r}: expected names with texts, numbers, true or false")
    return tuple((str(key), value) for key, value in values)


def _parts(text: str, separator: str) -> list[str]:
    """Split a text where a separator stands outside of braces and quotes."""
    parts, depth, quoted, escaped = [""], 0, False, False
    for letter in text:
        if letter == separator and not depth and not quoted:
            parts.append("")
            continue
        parts[-1] += letter
        if quoted:
            quoted = letter != '"' or escaped
            escaped = letter == "\\" and not escaped
        elif letter == '"' and depth:
            quoted = True
        elif letter in "{}":
            depth += 1 if letter == "{" else -1
    if depth or quoted:
        raise rpn_error("a brace or a quote is not closed")
    return parts


def _words(text: str) -> list[str]:
    return [word for word in _parts(text.replace("\t", " "), " ") if word]
