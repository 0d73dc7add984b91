"""The part of a site file about Home Assistant: what it is shown, and what it may ask for."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from housefly.config.section import Section


class HomeAssistantConfig(Section):
    """Shows the room and its drones in Home Assistant, through the broker of [mqtt]."""

    enabled: bool = Field(default=False, description="start it; needs mqtt.broker")
    prefix: str = Field(
        default="homeassistant",
        pattern=r"^[A-Za-z0-9_-]{1,60}$",
        description="first part of its discovery topics, as it is set there",
    )
    discovery: Literal["entity", "device"] = Field(
        default="entity",
        description="one message an entity, or one a device, which 2024.3 does not read yet",
    )
    requests: Literal["off", "ask", "auto"] = Field(
        default="ask",
        description=(
            "what it may do: only STOP, ask a person, fly; auto only with a broker that asks for"
            " mqtt.username, so with none of our own"
        ),
    )
    answers: bool = Field(
        default=False,
        description="whether a yes may be said there; only with such a broker, as auto",
    )
    pictures: bool = Field(
        default=False,
        description=(
            "whether it gets pictures, unencrypted as all of [mqtt]: of a flight, without what"
            " privacy zones blank and in no mode that records nothing, and the last snapshot"
        ),
    )
