"""Static files that travel packed: compressed once when the client is built, not when asked for."""

from __future__ import annotations

from mimetypes import guess_type

from starlette.datastructures import Headers
from starlette.responses import Response
from starlette.staticfiles import StaticFiles
from starlette.types import Scope

_CODING = "br"


class PackedFiles(StaticFiles):
    """Files of a folder; ``name.br`` goes in place of ``name`` to whoever reads Brotli."""

    async def get_response(self, path: str, scope: Scope) -> Response:
        """Return a file, packed where it lies so and the browser reads it."""
        plain = await super().get_response(path, scope)
        if self.lookup_path(f"{path}.{_CODING}")[1] is None:
            return plain
        if not _reads_brotli(scope):
            plain.headers.add_vary_header("Accept-Encoding")
            return plain
        packed = await super().get_response(f"{path}.{_CODING}", scope)
        packed.headers["content-encoding"] = _CODING
        packed.headers["content-type"] = guess_type(path)[0] or "application/octet-stream"
        packed.headers.add_vary_header("Accept-Encoding")
        return packed


def _reads_brotli(scope: Scope) -> bool:
    offered = Headers(scope=scope).get("accept-encoding", "")
    parts = (part.replace(" ", "").partition(";") for part in offered.split(","))
    return any(name == _CODING and weight not in ("q=0", "q=0.0") for name, _, weight in parts)
