"""The address of the console, and what makes it safe to reach from other machines."""

from __future__ import annotations

from typing import Self

from pydantic import Field, model_validator

from housefly.config.section import Section


class WebConfig(Section):
    """Where the console listens.

    Beyond loopback it needs a certificate (``housefly cert``); ``housefly run --lan`` sets host,
    certificate and key for one run.
    """

    host: str = Field(
        default="127.0.0.1",
        description="address to listen on; beyond loopback only with TLS",
    )
    port: int = Field(
        default=8080,
        ge=0,
        le=65535,
        description="TCP port; 0 chooses a free one",
        json_schema_extra={"unit": "1"},
    )
    tls_certificate: str = Field(
        default="",
        description=(
            "PEM file of the server's certificate, as `housefly cert` makes it; empty: no TLS."
            " Browsers may ask for the console under the names in it"
        ),
    )
    tls_key: str = Field(
        default="", description="PEM file of its key, which only this user may read"
    )
    users: str = Field(
        default="",
        description=(
            "file of those who may log in, kept by `housefly user add NAME --role fly`; empty:"
            " `users.json` beside the room's memory"
        ),
    )

    @model_validator(mode="after")
    def _certificate_and_key(self) -> Self:
        if bool(self.tls_certificate) != bool(self.tls_key):
            raise ValueError(
                "tls_certificate and tls_key belong together: give both (`housefly cert` prints"
                " them) or none"
            )
        return self
