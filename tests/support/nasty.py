"""Values that nobody means: what a site file or a command line may hold by accident or malice."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from housefly.config.section import Section

TEXTS = (
    "x\0y",
    "a" * 300,
    "a" * 5000,
    "a/" * 3000,
    "é" * 200,
    "",
    " ",
    "\n",
    "two\nlines",
    "..",
    "/",
    "/dev/null",
    "/dev/zero",
    "~nobody-of-that-name/x",
    "con fig",
    "postgresql://",
    "http://[",
    "[bold",
)
"""As they can stand in a TOML file."""
NUMBERS: tuple[Any, ...] = (
    float("nan"),
    float("inf"),
    -float("inf"),
    1e308,
    -1e308,
    5e-324,
    10**400,
    -(10**400),
    2**63,
    -1,
    0,
    True,
)
STRUCTURES: tuple[Any, ...] = (
    [],
    {},
    [[]],
    [1, "a"],
    [{}],
    None,
    [float("inf")] * 3,
    {"a": {"b": []}},
    ["x\0y"],
    ["a" * 5000],
    {"x\0": 1},
)
VALUES: tuple[Any, ...] = (*TEXTS, *NUMBERS, *STRUCTURES)
WHOLE_FILES = (
    b"",
    b"\0",
    b"\xff\xfe",
    b"[" * 5000,
    b"a = " + b"[" * 5000,
    b"a = " + b"9" * 6000,
    b"drone = 5",
    b"[drone]\naddress = '\xf0'",
    b"lasers = 3",
    b"[[lasers]]",
    b"drone.profile = '/dev/zero'",
    b"[room]\nmodel = '/'",
    b"a\nb" * 2000,
    b"'' = 1",
    b"[limits]\nspeed = 1979-05-27T07:32:00Z",
)
"""Contents of a site file."""


def keys_of(section: type[Section], prefix: tuple[str, ...] = ()) -> Iterator[tuple[str, ...]]:
    """Yield the path of each key of a section and of those in it."""
    for name, field in section.model_fields.items():
        yield (*prefix, name)
        if isinstance(field.annotation, type) and issubclass(field.annotation, Section):
            yield from keys_of(field.annotation, (*prefix, name))


def tree_with(key: tuple[str, ...], value: Any) -> dict[str, Any]:
    """Return the tree of a site that sets one key."""
    tree: dict[str, Any] = {key[-1]: value}
    for name in reversed(key[:-1]):
        tree = {name: tree}
    return tree
