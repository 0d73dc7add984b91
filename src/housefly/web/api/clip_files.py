"""Clips and snapshots over HTTP: ``/api/v1/clips/{id}``, in parts as players ask for them.

``/api/v1/clips.zip?clip=...&clip=...`` is several of them with all that is known, to take away.
Whoever watches one is written down, in the clips' own book and in the audit log: the first
request of a session for a clip, whatever part it asks for, and then again after ten minutes.
With ``still=1``, as a list shows it, the clips' own book says "seen small", and the log nothing.
"""

from __future__ import annotations

import asyncio
import threading
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Protocol

from starlette.requests import Request
from starlette.responses import FileResponse, Response, StreamingResponse
from starlette.routing import Route

from housefly.errors import HouseflyError, TaskError
from housefly.evidence.clip_export import ClipExport, zipped
from housefly.tasks.api.values import ReasonCode
from housefly.web.access.audit_log import AuditLog
from housefly.web.access.bearer import bears
from housefly.web.access.session_auth import SessionAuth
from housefly.web.api.tasks_api import task_refusal

_WATCH_PERIOD = 600.0
"""Requests of one session for one clip within it are one watching [s]."""
_ZIP = "application/zip"
_TYPES = {".mp4": "video/mp4", ".jpg": "image/jpeg"}


class ClipBook(Protocol):
    """What the server needs of ``evidence.clip_index.ClipIndex``."""

    def file(self, name: str) -> Path:
        """Return the file of a clip; raises TaskError when there is none."""
        ...

    def log_access(self, name: str, who: str, what: str = "watched") -> object:
        """Write down who saw, copied or exported a clip; raises TaskError, StoreError."""
        ...

    def export(self, names: Sequence[str], who: str) -> ClipExport:
        """Return clips to export, and write down who does; raises TaskError, StoreError."""
        ...

    def close(self) -> None:
        """Close it."""
        ...


class ClipFiles:
    """The files of the clips.

    Args:
        index: knows them; None where there are none.
        auth: the console's sessions.
        key: the bearer token of programs; "" lets none in.
        name_of: the name that others see for a session's owner.
        audit: where it is written down who watched.
        clock: monotonic [s].
    """

    def __init__(
        self,
        index: ClipBook | None,
        auth: SessionAuth,
        key: str,
        name_of: Callable[[str], str],
        audit: AuditLog | None = None,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._index, self._auth, self._key = index, auth, key
        self._name_of, self._audit, self._clock = name_of, audit, clock
        self._lock = threading.Lock()
        self._written: dict[tuple[str, ...], float] = {}

    def routes(self) -> list[Route]:
        """Return the routes, relative to ``API_PREFIX``."""
        return [
            Route("/clips/{clip}", self._show, methods=["GET"]),
            Route("/clips.zip", self._export, methods=["GET"]),
        ]

    async def _export(self, request: Request) -> Response:
        """Stream several clips as one ZIP file; the middleware has looked at the role."""
        if (who := self._who(request)) is None:
            return task_refusal(401, "this browser has no session", ReasonCode.NOT_ALLOWED)
        name, session = who
        names = request.query_params.getlist("clip")
        if request.method != "GET":
            return Response(media_type=_ZIP)
        try:
            export = await asyncio.to_thread(self._taken_away, names, name)
        except TaskError as error:
            return task_refusal(404, str(error))
        except HouseflyError as error:
            return task_refusal(503, str(error), ReasonCode.NOT_READY)
        if self._audit is not None:
            self._audit.record(name, session, f"exported the clips {', '.join(names)}")
        attached = {"content-disposition": 'attachment; filename="clips.zip"'}
        headers = {"cache-control": "no-store", **attached}
        return StreamingResponse(zipped(export), media_type=_ZIP, headers=headers)

    def _taken_away(self, names: list[str], who: str) -> ClipExport:
        """Return what leaves the house; raises TaskError, StoreError."""
        if self._index is None:
            raise TaskError("no clips are kept here", ReasonCode.BAD_PARAMETER.value)
        return self._index.export(names, who)

    async def _show(self, request: Request) -> Response:
        if (who := self._who(request)) is None:
            return task_refusal(401, "this browser has no session", ReasonCode.NOT_ALLOWED)
        name, session = who
        clip = str(request.path_params["clip"])
        downloads, is_still = ("download" in request.query_params, "still" in request.query_params)
        shows = request.method == "GET"
        try:
            file = await asyncio.to_thread(self._file, clip)
            what = "exported" if downloads else "seen small" if is_still else "watched"
            begins = shows and await asyncio.to_thread(self._write_down, clip, name, session, what)
        except TaskError as error:
            return task_refusal(404, str(error))
        except HouseflyError as error:
            return task_refusal(503, str(error), ReasonCode.NOT_READY)
        if not file.is_file():
            return task_refusal(404, f"the file of the clip {clip!r} is gone")
        if self._audit is not None and begins and not is_still:
            did = "downloaded" if downloads else "watched"
            self._audit.record(name, session, f"{did} the clip {clip}")
        return FileResponse(
            file,
            media_type=_TYPES[file.suffix],
            filename=file.name if downloads else None,
            headers={"cache-control": "no-store"},
        )

    def _file(self, clip: str) -> Path:
        """Return a clip's file; raises TaskError, StoreError."""
        if self._index is None:
            raise TaskError("no clips are kept here", ReasonCode.BAD_PARAMETER.value)
        return self._index.file(clip)

    def _write_down(self, clip: str, who: str, session: str, what: str) -> bool:
        """Write down who sees a clip, unless that was done lately; raises TaskError, StoreError."""
        key, now = (clip, who, session, what), self._clock()
        with self._lock:
            self._written = {
                one: at for one, at in self._written.items() if now - at < _WATCH_PERIOD
            }
            if self._index is None or key in self._written:
                return False
            self._index.log_access(clip, who, what)
            self._written[key] = now
        return True

    def _who(self, request: Request) -> tuple[str, str] | None:
        """Return who asks, and the name of their session, or None for nobody."""
        if bears(request, self._key):
            return "a program", ""
        if (session := self._auth.session_of(request)) is None:
            return None
        return session.user or self._name_of(session.owner), session.name
