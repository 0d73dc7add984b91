"""The address of the console."""

from __future__ import annotations

from pydantic import Field

from housefly.config.section import Section


class WebConfig(Section):
    """Where the console listens."""

    host: str = Field(
        default="127.0.0.1", description="address to listen on; only loopback is safe"
    )
    port: int = Field(
        default=8080,
        ge=0,
        le=65535,
        description="TCP port; 0 chooses a free one",
        json_schema_extra={"unit": "1"},
    )
