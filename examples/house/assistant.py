"""Ask the room as an assistant does, over MCP: where is the cup, and may the drone look?

Needs `pip install 'housefly[mcp]'` and a room that runs (`housefly demo`). The drone flies only
after you have said yes here.
"""

import asyncio
import os
import sys

from mcp import Client, StdioServerParameters
from mcp.client.session import ClientRequestContext
from mcp_types import ElicitRequestParams, ElicitResult

SERVER = StdioServerParameters(
    command=sys.executable, args=["-m", "housefly.cli", "mcp"], env=dict(os.environ)
)


async def person(context: ClientRequestContext, params: ElicitRequestParams) -> ElicitResult:
    """Show a question to whoever sits here."""
    said = input(f"{params.message} [y/N] ")
    return ElicitResult(action="accept", content={"fly": said.lower().startswith("y")})


async def main() -> None:
    """Ask, rehearse, request."""
    async with Client(SERVER, elicitation_callback=person) as room:
        flight = {"service": "look", "parameters": {"subject": "cup"}}
        for tool, given in (
            ("where_is", {"thing": "cup"}),
            ("rehearse", flight),
            ("request_flight", flight),
        ):
            found = await room.call_tool(tool, given)
            print(tool, found.structured_content)


asyncio.run(main())
