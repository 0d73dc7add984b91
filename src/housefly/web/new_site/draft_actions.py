"""What the page may ask for: every action's fields, checked, and what it does to the draft."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Annotated, ClassVar, Literal, TypeVar

from pydantic import ConfigDict, Field, TypeAdapter, ValidationError

from housefly.config.validation import dotted, explain
from housefly.errors import ConfigError
from housefly.messages.words import Words, figure
from housefly.room.draft.imports.contracts import ImportHints
from housefly.room.draft.model import (
    Coordinate,
    Corners,
    SiteDraft,
    with_size,
    without_scanned,
)
from housefly.room.draft.site_of_draft import suggested_places
from housefly.room.draft.suggestions import suggested_pad
from housefly.web.new_site.draft_service import DraftService
from housefly.web.new_site.draft_view import DraftView
from housefly.web.new_site.uploads import Uploads

_STRICT = ConfigDict(extra="forbid")
Asked = TypeVar("Asked")
Version = Annotated[str, Field(max_length=64)]


@dataclass(frozen=True, slots=True)
class KeepDraft:
    """Take the draft as the page holds it; ``merges`` with the change before for undo."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    based_on: Version
    draft: SiteDraft
    merges: bool = False


@dataclass(frozen=True, slots=True)
class SizeRoom:
    """Make the room a rectangle: length, width and height [m]."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    based_on: Version
    length: Coordinate
    width: Coordinate
    height: Coordinate


@dataclass(frozen=True, slots=True)
class ImportRoom:
    """Make the room of a file that was uploaded; see ``ImportHints``."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    based_on: Version
    file: Annotated[str, Field(max_length=100)]
    unit: Annotated[float, Field(gt=0.0, le=1000.0, allow_inf_nan=False)] | None = None
    up: Literal["auto", "y", "z"] = "auto"
    layers: Annotated[tuple[Annotated[str, Field(max_length=60)], ...], Field(max_length=20)] = ()
    unexplored: Literal["wall", "free"] = "wall"


@dataclass(frozen=True, slots=True)
class EraseScanned:
    """Remove what a file brought, in a rectangle [m]."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    based_on: Version
    rectangle: Corners


@dataclass(frozen=True, slots=True)
class DraftRequest:
    """Do what the path says."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    based_on: Version


Action = Callable[[DraftService, Uploads, bytes], DraftView]


def parsed_request(kind: type[Asked], body: bytes) -> Asked:
    """Return a request; raises ConfigError naming the first bad key, its value and what may be."""
    try:
        return TypeAdapter(kind).validate_json(body)
    except ValidationError as error:
        first = error.errors()[0]
        key = dotted(first["loc"]).removeprefix("draft.") or "request"
        raise ConfigError(key, explain(first)) from error


def _keep(service: DraftService, _: Uploads, body: bytes) -> DraftView:
    asked = parsed_request(KeepDraft, body)
    return service.replace_drawn(asked.based_on, asked.draft, merges=asked.merges)


def _size(service: DraftService, _: Uploads, body: bytes) -> DraftView:
    asked = parsed_request(SizeRoom, body)
    return service.change(
        asked.based_on,
        lambda now: with_size(now, asked.length, asked.width, asked.height),
        Words(
            "a room of {a} x {b} m, {c} m high",
            a=figure(asked.length, "g"),
            b=figure(asked.width, "g"),
            c=figure(asked.height, "g"),
        ),
        notes=(),
    )


def _import(service: DraftService, uploads: Uploads, body: bytes) -> DraftView:
    from housefly.room.draft.imports.imported import imported  # readers of scans are large

    asked = parsed_request(ImportRoom, body)
    path = uploads.path_of(asked.file)
    hints = ImportHints(asked.unit, asked.up, asked.layers, asked.unexplored)
    found = imported(service.draft(), path, hints)
    return service.change(
        asked.based_on,
        lambda _: found.draft,
        Words("read {name}", name=asked.file),
        notes=found.notes,
    )


def _erase(service: DraftService, _: Uploads, body: bytes) -> DraftView:
    asked = parsed_request(EraseScanned, body)
    return service.change(
        asked.based_on,
        lambda now: without_scanned(now, asked.rectangle),
        Words("erased"),
    )


def _suggest_pad(service: DraftService, _: Uploads, body: bytes) -> DraftView:
    def padded(now: SiteDraft) -> SiteDraft:
        if (pad := suggested_pad(now)) is None:
            raise ConfigError(
                "pad", Words("the drone fits nowhere in this room: is there a free floor?")
            )
        return replace(now, pad=pad)

    based_on = parsed_request(DraftRequest, body).based_on
    return service.change(based_on, padded, Words("a roomy spot"))


def _suggest_places(service: DraftService, _: Uploads, body: bytes) -> DraftView:
    def placed(now: SiteDraft) -> SiteDraft:
        known = {place.name for place in now.places}
        fresh = tuple(place for place in suggested_places(now) if place.name not in known)
        if not fresh:
            raise ConfigError("places", Words("no further roomy spot can be reached from the pad"))
        return replace(now, places=(*now.places, *fresh))

    based_on = parsed_request(DraftRequest, body).based_on
    return service.change(based_on, placed, Words("roomy spots"))


def _undo(service: DraftService, _: Uploads, body: bytes) -> DraftView:
    return service.undo(parsed_request(DraftRequest, body).based_on)


def _redo(service: DraftService, _: Uploads, body: bytes) -> DraftView:
    return service.redo(parsed_request(DraftRequest, body).based_on)


ACTIONS: dict[str, Action] = {
    "/draft": _keep,
    "/draft/size": _size,
    "/draft/import": _import,
    "/draft/erase": _erase,
    "/draft/pad": _suggest_pad,
    "/draft/places": _suggest_places,
    "/draft/undo": _undo,
    "/draft/redo": _redo,
}
"""By path, all POST; each answers with the draft as it is then."""
