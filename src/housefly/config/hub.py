"""The part of a site file about the room's memory."""

from __future__ import annotations

from pydantic import Field

from housefly.config.section import Section, quantity


class HubConfig(Section):
    """The room's memory: what is where and what happened, kept and answered."""

    enabled: bool = Field(default=True, description="start it; false flies without a memory")
    store: str = Field(
        default="",
        max_length=500,
        description=(
            'SQLite file, or postgresql://user@host/database; "" is a file of this site in the'
            " user's state folder"
        ),
    )
    things: str = Field(
        default="", description="catalogue of further things (TOML), relative to the site file"
    )
    edits: bool = Field(
        default=True,
        description=(
            "whether places and zones may be edited in the console and apply from the next"
            " start on, in mode default"
        ),
    )
    keep_days: float = quantity(14.0, 0.05, 3650.0, "d", "samples are kept so long at 10 Hz")
    keep_events_days: float = quantity(
        0.0, 0.0, 3650.0, "d", "what happened is kept so long; 0 keeps it for good"
    )
