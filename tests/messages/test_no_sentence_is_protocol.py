"""No code compares, searches or cuts a sentence that another part has made.

Looked at is the syntax of the source: comparisons, ``in``, the methods of texts that search or cut,
and regular expressions, where what they are used on is a field of words (``messages.words.Words``)
of a message, a refusal, a trouble or the console's verdict. A field whose name is common
(``text``, ``words``, ``value`` ...) counts where its owner has one of the names in ``OWNERS``. What
a name does not show, a sentence that goes through a variable, is not seen; of the console's code
the types see it (``Said`` has no methods of a text).
"""

from __future__ import annotations

import ast
import dataclasses
import re
import typing
from collections.abc import Iterator
from pathlib import Path

import pytest

import house
from housefly import messages
from housefly.messages.words import Words
from housefly.pilot.behavior import mission
from housefly.pilot.safety import gate
from housefly.web.messages import server_messages, verdict_message

COMMON = {"text", "words", "value", "limit", "title", "place", "fault", "why", "known"}
OWNERS = {"event", "trouble", "rule", "refused", "answer", "failing", "check", "verdict", "stop"}
METHODS = {
    *("startswith", "endswith", "split", "rsplit", "partition", "rpartition", "splitlines"),
    *("find", "rfind", "index", "rindex", "count", "replace", "removeprefix", "removesuffix"),
    *("match", "search", "fullmatch", "findall", "finditer", "sub"),
}
CLIENT = house.PACKAGE / "web" / "client" / "src"


def fields_of_words() -> set[str]:
    """Return the names of all fields that hold words, or several."""
    found = set()
    for module in (messages, mission, gate, server_messages, verdict_message):
        for kind in vars(module).values():
            if not (isinstance(kind, type) and dataclasses.is_dataclass(kind)):
                continue
            hints = typing.get_type_hints(kind)
            found |= {name for name, hint in hints.items() if _is_words(hint)}
    return found


def _is_words(hint: object) -> bool:
    return hint is Words or Words in typing.get_args(hint)


def offences(source: str, fields: set[str]) -> Iterator[int]:
    """Yield the lines of a source that compare, search or cut words."""

    def is_sentence(node: ast.AST) -> bool:
        if not isinstance(node, ast.Attribute) or node.attr not in fields:
            return False
        owner = node.value.attr if isinstance(node.value, ast.Attribute) else ""
        owner = node.value.id if isinstance(node.value, ast.Name) else owner
        return node.attr not in COMMON or owner in OWNERS

    def is_text(node: ast.AST) -> bool:
        is_text = isinstance(node, ast.Constant) and isinstance(node.value, str)
        return isinstance(node, ast.JoinedStr) or (is_text and node.value != "")

    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Compare):
            sides = (node.left, *node.comparators)
            if any(map(is_sentence, sides)) and any(map(is_text, sides)):
                yield node.lineno
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            looked_at = (node.func.value, *node.args)
            if node.func.attr in METHODS and any(map(is_sentence, looked_at)):
                yield node.lineno


@pytest.mark.parametrize(
    "bad",
    [
        'event.text.startswith("moved")',
        '"furniture" in outputs.reason',
        'step.outputs.reason == "a"',
        're.match("a", answer.reason)',
        'known.waiting.split(":")',
        'verdict.headline != f"{a}"',
    ],
)
def test_a_sentence_that_is_read_is_found(bad: str) -> None:
    assert list(offences(bad, fields_of_words())) == [1]


def test_no_code_compares_searches_or_cuts_a_sentence() -> None:
    fields = fields_of_words()
    assert {"reason", "text", "mend", "headline", "waiting", "banner"} <= fields
    found = [
        f"{path}:{line}"
        for path in sorted(house.PACKAGE.rglob("*.py"))
        for line in offences(path.read_text(encoding="utf-8"), fields)
    ]
    assert found == []


_CUT = re.compile(
    r"\.(?:text|reason|headline|detail|banner|mend)\??\."
    r"(?:startsWith|endsWith|replace|split|includes|match|indexOf|slice|search)\("
)


def test_the_console_cuts_no_sentence() -> None:
    files: list[Path] = [path for path in CLIENT.rglob("*.ts*") if "new" not in path.parts]
    assert len(files) > 100
    assert [path.name for path in files if _CUT.search(path.read_text(encoding="utf-8"))] == []
