"""The task documents of a running house: a wrong one is told, all others go on."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path
from threading import Lock

from housefly.errors import TaskError
from housefly.tasks.api.values import ReasonCode, ServiceInfo
from housefly.tasks.document.document_parser import read_task
from housefly.tasks.document.library import (
    check_overrides,
    document_files,
    link,
    load_library,
    text_of,
)
from housefly.tasks.document.marked_yaml import document_error
from housefly.tasks.document.task_document import TaskDocument

_NAME_LINE = re.compile(r"^name:[ \t]*([a-z][a-z0-9_]*)[ \t]*$", re.MULTILINE)
_OVERRIDES_LINE = re.compile(r"^overrides:[ \t]*true[ \t]*$", re.MULTILINE)

_Mark = tuple[tuple[str, int, int], ...]


@dataclass(frozen=True, slots=True)
class _Found:
    documents: dict[str, TaskDocument]
    broken: dict[str, str]


NO_DRONE = "this room has no drone"


class OpenLibrary(Mapping[str, TaskDocument]):
    """All documents by name; one's own are read again when their files have changed.

    A wrong document is no service, nor is the shipped one that it was to replace. Thread-safe.

    Args:
        own_folder: with documents of one's own, or None.
        has_drone: whether there is a drone; without one nothing that flies is a service.
        has_camera: whether the drone has a camera; without one nothing that looks is a service.
    """

    def __init__(
        self, own_folder: Path | None = None, *, has_drone: bool = True, has_camera: bool = True
    ) -> None:
        self._folder, self._lock = own_folder, Lock()
        self._has_drone, self._has_camera = has_drone, has_camera
        self._mark: _Mark | None = None
        self._found = _Found({}, {})
        self.refresh()

    def __getitem__(self, name: str) -> TaskDocument:
        return self._found.documents[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._found.documents)

    def __len__(self) -> int:
        return len(self._found.documents)

    @property
    def problems(self) -> tuple[str, ...]:
        """What is wrong with one's own documents: file, line and reason."""
        return tuple(self._found.broken.values())

    def refresh(self) -> None:
        """Read one's own documents again, if any file has changed."""
        with self._lock:
            mark = _mark_of(self._folder)
            if mark != self._mark:
                self._found, self._mark = _read(self._folder), mark

    def _objection(self, document: TaskDocument) -> tuple[ReasonCode, str] | None:
        """Return why a document is no service here, or None where it is one."""
        if document.flies and not self._has_drone:
            return ReasonCode.NO_DRONE, "needs a drone, and this room has none"
        if document.looks and not self._has_camera:
            return ReasonCode.NO_CAMERA, "needs a camera, and the drone has none"
        return None

    def services(self) -> tuple[ServiceInfo, ...]:
        """Return what can be asked for now, and at the end what cannot, with why."""
        self.refresh()
        found = self._found
        broken = [
            ServiceInfo(name, name, f"cannot be asked for: {problem}", (), False, problem)
            for name, problem in sorted(found.broken.items())
        ]
        offered = (one for one in found.documents.values() if self._objection(one) is None)
        return (*(document.info() for document in offered), *broken)

    def document(self, service: str) -> TaskDocument:
        """Return a service's document as its file says now.

        Raises:
            TaskError: UNKNOWN_SERVICE; says what there is, or what is wrong with the document;
                NO_DRONE; NO_CAMERA where it looks and the drone has none.
        """
        self.refresh()
        found = self._found
        if service in found.documents:
            document = found.documents[service]
            if (objection := self._objection(document)) is not None:
                code, why = objection
                raise TaskError(f"{service} {why}", code.value)
            return document
        unknown = ReasonCode.UNKNOWN_SERVICE.value
        if service in found.broken:
            words = f"the service {service!r} cannot be asked for: {found.broken[service]}"
            raise TaskError(words, unknown)
        near = get_close_matches(service, found.documents, 1)
        hint = f"did you mean {near[0]}?" if near else f"there is {', '.join(found.documents)}"
        raise TaskError(f"there is no service {service!r}: {hint}", unknown)


def _mark_of(folder: Path | None) -> _Mark:
    """Return what changes when a file of a folder does."""
    try:
        files = document_files(folder) if folder is not None else ()
        kept = [(path.name, path.stat()) for path in files]
    except (OSError, TaskError) as error:
        return ((str(error), 0, 0),)
    return tuple((name, stat.st_mtime_ns, stat.st_size) for name, stat in kept)


def _read(folder: Path | None) -> _Found:
    shipped = load_library()
    library, broken = dict(shipped), dict[str, str]()
    try:
        files = document_files(folder) if folder is not None else ()
    except TaskError as error:
        return _Found(library, {"own documents": str(error)})
    replaced = set[str]()
    for path in files:
        try:
            document = read_task(text_of(path), path.name)
        except TaskError as error:
            name, replaces = _meant(path)
            broken[name if replaces or name not in library else path.name] = str(error)
            replaced |= {name} if replaces else set()
            continue
        try:
            check_overrides(document, shipped)
            _check_is_only(document, library, shipped)
        except TaskError as error:
            broken[path.name] = str(error)
        else:
            library[document.name] = document
    for name in replaced:
        # The shipped one does perhaps what its owner did not want any more.
        library.pop(name, None)
    return _linked(library, broken)


def _check_is_only(
    document: TaskDocument, library: Mapping[str, TaskDocument], shipped: Mapping[str, TaskDocument]
) -> None:
    """Raise TaskError for the second of one's own documents of the same name."""
    other = library.get(document.name)
    if other is not None and other is not shipped.get(document.name):
        words = f"{document.name} is the name of {other.source}, too"
        raise document_error(document.source, 1, words)


def _linked(library: dict[str, TaskDocument], broken: dict[str, str]) -> _Found:
    done: dict[str, TaskDocument] = {}
    for name in sorted(library):
        try:
            link(name, library, done)
        except TaskError as error:
            broken[name] = str(error)
    return _Found({name: done[name] for name in sorted(done)}, broken)


def _meant(path: Path) -> tuple[str, bool]:
    """Return which service a wrong document is about, and whether it replaces a shipped one."""
    try:
        text = text_of(path)
    except TaskError:
        text = ""
    found = _NAME_LINE.search(text)
    return (found[1] if found else path.stem), bool(_OVERRIDES_LINE.search(text))
