"""``housefly mcp``: let an assistant ask the room, and ask for flights."""

from __future__ import annotations

import os
import secrets
import sys
from argparse import ArgumentParser, Namespace
from pathlib import Path

from housefly.app.commands.subcommand import Subcommand
from housefly.errors import ConfigError, MissingPartError

MCP_KEY = "HOUSEFLY_MCP_KEY"
"""Environment variable with the bearer key of the HTTP server: others can read command lines."""
_SHORTEST_KEY = 16


def _add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument(
        "--site", default="", metavar="NAME", help="of the run (default: the newest)"
    )
    parser.add_argument(
        "--http", type=int, metavar="PORT", help="streamable HTTP on loopback instead of stdio"
    )
    parser.add_argument(
        "--console-only",
        action="store_true",
        help="people say yes in the console only, never through the assistant's program",
    )


def _run(options: Namespace) -> int:
    """Serve until the assistant leaves."""
    try:
        from housefly.tasks.assistants.mcp_server import room_server, serve_http
    except ModuleNotFoundError as error:
        if (error.name or "").split(".")[0] not in ("mcp", "mcp_types"):
            raise
        raise MissingPartError("the MCP server", "pip install 'housefly[mcp]'") from error
    from housefly.tasks.assistants.assistant_room import FoundRoom

    _find_announcements()
    server = room_server(FoundRoom(options.site), elicits=not options.console_only)
    if options.http is None:
        server.run("stdio")
        return 0
    if not 1 <= options.http <= 65535:
        raise ConfigError("--http", f"is {options.http}; allowed: a port from 1 to 65535")
    serve_http(server, options.http, _key(options.http))
    return 0


def _find_announcements() -> None:
    """Look for rooms where a login session has them: assistants start programs without its
    environment.
    """
    folder = Path(f"/run/user/{os.getuid()}")
    if not os.environ.get("XDG_RUNTIME_DIR") and os.access(folder, os.W_OK):
        os.environ["XDG_RUNTIME_DIR"] = str(folder)


def _key(port: int) -> str:
    """Return the key of the HTTP server; one of our own is told once."""
    key = os.environ.get(MCP_KEY, "")
    if key and len(key) < _SHORTEST_KEY:
        raise ConfigError(MCP_KEY, f"is too short; allowed: {_SHORTEST_KEY} letters or more")
    if not key:
        key = secrets.token_urlsafe(32)
        print(f"http://127.0.0.1:{port}/mcp  Authorization: Bearer {key}", file=sys.stderr)
    return key


MCP_COMMAND = Subcommand(
    name="mcp",
    help="let an assistant ask the room, and ask for flights",
    description=(
        "Speak the Model Context Protocol: an assistant may ask where things are, who is there and"
        " what happened, see the map and pictures, rehearse, and ask for a flight. It flies only"
        " after a person says yes, in the console or in the assistant's program.\n"
        "stdio is for programs that start this command; --http serves on loopback, for whoever has"
        f" the key: that in {MCP_KEY}, or one that is printed at the start."
    ),
    add_arguments=_add_arguments,
    run=_run,
)
