"""The part of a site file about the live view in Foxglove."""

from __future__ import annotations

from ipaddress import ip_address

from pydantic import Field, field_validator

from housefly.config.section import Section

APP_ORIGIN = "https://app.foxglove.dev"
"""Where the pages of the Foxglove app come from."""


class FoxgloveConfig(Section):
    """A live WebSocket for Foxglove, read-only; docs/foxglove.md has its channels.

    It asks nobody who they are, so it is for programs of this machine: from another one through
    `ssh -L 8765:127.0.0.1:8765 HOST`.
    """

    enabled: bool = Field(default=False, description="start it; needs the extra `foxglove`")
    host: str = Field(
        default="127.0.0.1", description="loopback address to listen on; it asks for no password"
    )
    port: int = Field(
        default=8765,
        ge=0,
        le=65535,
        description="TCP port; 0 chooses a free one",
        json_schema_extra={"unit": "1"},
    )
    origins: tuple[str, ...] = Field(
        default=(APP_ORIGIN,),
        max_length=20,
        description=(
            "pages of a browser that may look, by their origin; a program that is no browser names"
            " none, and may"
        ),
    )

    @field_validator("host")
    @classmethod
    def _loopback(cls, host: str) -> str:
        try:
            is_here = host == "localhost" or ip_address(host).is_loopback
        except ValueError:
            is_here = False
        if not is_here:
            raise ValueError(
                f"is {host!r}; allowed: a loopback address such as 127.0.0.1, because whoever"
                " reaches it sees the room"
            )
        return host
