"""All task documents: those that ship, and a folder of one's own."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from errno import EFBIG
from pathlib import Path

from housefly.config.text import read_file
from housefly.errors import TaskError
from housefly.tasks.api.values import ReasonCode
from housefly.tasks.document.binding import bind
from housefly.tasks.document.document_parser import read_task
from housefly.tasks.document.marked_yaml import SIZE_MAX, document_error
from housefly.tasks.document.parameters import checked_parameters
from housefly.tasks.document.steps import StepKind, TaskStep
from housefly.tasks.document.task_document import BoundTask, TaskDocument
from housefly.tasks.document.templates import names_in

__all__ = ["BoundTask", "TaskDocument", "bind", "load_library", "read_task"]

SHIPPED = Path(__file__).parent / "shipped"
"""The folder of the documents that ship."""
FILES_MAX = 200
"""Most documents in one folder."""


def load_library(own_folder: Path | None = None) -> dict[str, TaskDocument]:
    """Return all documents by name, each checked, with the tasks that it calls.

    Args:
        own_folder: with documents of one's own; one of the name of a shipped task replaces it only
            when it says ``overrides: true``.

    Raises:
        TaskError: a document is wrong; names file, line, and what is allowed.
    """
    library = _read_folder(SHIPPED)
    if own_folder is not None:
        for name, document in _read_folder(own_folder).items():
            check_overrides(document, library)
            library[name] = document
    return linked(library)


def linked(library: dict[str, TaskDocument]) -> dict[str, TaskDocument]:
    """Return the documents with the tasks that they call; raises TaskError when one cannot be."""
    done: dict[str, TaskDocument] = {}
    for name in library:
        link(name, library, done)
    return {name: done[name] for name in sorted(done)}


def check_overrides(document: TaskDocument, shipped: Mapping[str, TaskDocument]) -> None:
    """Raise TaskError when a document takes the name of a shipped one without saying so."""
    if document.name in shipped and not document.overrides:
        words = f"{document.name} ships with Housefly; name it otherwise, or say overrides: true"
        raise document_error(document.source, 1, words)


def link(
    name: str,
    library: dict[str, TaskDocument],
    done: dict[str, TaskDocument],
    callers: tuple[str, ...] = (),
) -> TaskDocument:
    """Return a document with the tasks that it calls; raises TaskError when it cannot be.

    Args:
        name: of the document.
        library: all documents.
        done: those that are linked already; this one is added.
        callers: who calls it, from the first on.
    """
    if name in done:
        return done[name]
    document = library[name]
    calls: dict[str, TaskDocument] = {}
    for step in document.every_step():
        if step.kind is StepKind.CALL:
            called = str(step.arguments["task"])
            if called not in library:
                allowed = ", ".join(sorted(library))
                raise document_error(
                    document.source, step.line, f"there is no task {called!r}; allowed: {allowed}"
                )
            if called in (*callers, name):
                way = " -> ".join((*callers, name, called))
                raise document_error(document.source, step.line, f"tasks call in a ring: {way}")
            calls[called] = link(called, library, done, (*callers, name))
            _check_given(document, step, calls[called])
    done[name] = replace(document, calls=calls)
    return done[name]


def _check_given(document: TaskDocument, step: TaskStep, called: TaskDocument) -> None:
    """Raise TaskError when a call does not give what the task takes."""
    given = step.arguments.get("with", {})
    assert isinstance(given, dict)
    closed = {n: v for n, v in given.items() if not (isinstance(v, str) and names_in(v))}
    parameters = tuple(
        replace(parameter, required=parameter.required and parameter.name not in given)
        for parameter in called.parameters
    )
    unknown = {name: "x" for name in given if name not in {p.name for p in parameters}}
    try:
        checked_parameters(parameters, {**closed, **unknown})
    except TaskError as error:
        raise document_error(document.source, step.line, f"call {called.name}: {error}") from None


def document_files(folder: Path) -> tuple[Path, ...]:
    """Return the files of a folder of documents; raises TaskError for no folder, or too many."""
    if not folder.is_dir():
        raise TaskError(f"{folder}: there is no such folder", ReasonCode.BAD_PARAMETER.value)
    paths = sorted((*folder.glob("*.yaml"), *folder.glob("*.yml")))
    if len(paths) > FILES_MAX:
        raise TaskError(
            f"{folder}: {len(paths)} documents; allowed: {FILES_MAX}",
            ReasonCode.BAD_PARAMETER.value,
        )
    return tuple(paths)


def _read_folder(folder: Path) -> dict[str, TaskDocument]:
    found: dict[str, TaskDocument] = {}
    for path in document_files(folder):
        document = read_task(text_of(path), path.name)
        if document.name in found:
            other = found[document.name].source
            raise document_error(path.name, 1, f"{document.name} is the name of {other}, too")
        found[document.name] = document
    return found


def text_of(path: Path) -> str:
    """Return the text of a document; raises TaskError when it is too large or no text."""
    try:
        return read_file(path, 4 * SIZE_MAX).decode("utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        words = f"larger than {SIZE_MAX} characters"
        if getattr(error, "errno", 0) != EFBIG:
            reason = getattr(error, "strerror", None) or str(error)
            words = f"cannot be read as UTF-8 text: {reason}"
        raise document_error(path.name, 1, words) from error
