"""Which thing contains which: chains that never form a cycle."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from housefly.errors import ThingError

_ContainerOf = Callable[[str], str]
"""Maps the id of a thing to the id of its container, "" for none."""


def chain_of(thing: str, container: _ContainerOf) -> tuple[str, ...]:
    """Return what contains a thing, the closest first.

    Raises:
        ThingError: the thing would contain itself; the message lists the cycle.
    """
    found: list[str] = []
    at = container(thing)
    while at:
        found.append(at)
        if at == thing or at in found[:-1]:
            raise ThingError(f"{' is in '.join((thing, *found))}: a thing cannot be inside itself")
        at = container(at)
    return tuple(found)


def contents_of(thing: str, things: Iterable[str], container: _ContainerOf) -> tuple[str, ...]:
    """Return everything inside a thing, nested contents included, in the order of ``things``."""
    children: dict[str, list[str]] = {}
    every = tuple(things)
    for child in every:
        children.setdefault(container(child), []).append(child)
    found: set[str] = set()
    waiting = list(children.get(thing, ()))
    while waiting:
        child = waiting.pop()
        found.add(child)
        waiting += children.get(child, ())
    return tuple(child for child in every if child in found)
