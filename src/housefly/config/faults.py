"""Faults of the simulated room, as a site file gives them."""

from __future__ import annotations

import re
from typing import Self

from pydantic import Field, model_validator

from housefly.config.section import Section

_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
_WHEN = rf"(?:@(?P<start>{_NUMBER})s?)?(?:\+(?P<duration>{_NUMBER})s?)?"
_SEED = r"(?:#(?P<seed>\d{1,10}))?"
_DRONE = r"(?:(?P<drone>[a-z][a-z0-9_-]{0,30}):\s+)?"
ROW_PATTERN = rf"{_DRONE}(?P<row>F\d\d)(?:/(?P<variant>[\w.-]+))?{_WHEN}{_SEED}"
"""A row of the catalogue in ``docs/faults.md``: ``F13/5cm@20s``."""
FAULT_PATTERN = (
    rf"{_DRONE}(?P<component>[a-z]+)(?:\.(?P<aspect>\w+))?:(?P<kind>[a-z]+){_WHEN}"
    rf"(?:=(?P<size>{_NUMBER}))?{_SEED}"
)
"""One component: ``mocap:wrong@20s+5s=0.3``."""


class FaultConfig(Section):
    """A fault of the simulated room; refused with real hardware. The words: ``docs/faults.md``."""

    fault: str = Field(
        min_length=3,
        max_length=120,
        description=(
            'a row of the catalogue ("F13@20s") or a component ("mocap:wrong@20s+5s=0.3"); where a'
            ' site has several drones it befalls the first, or the one named: "anna: F13@20s"'
        ),
    )

    @model_validator(mode="after")
    def _readable(self) -> Self:
        if not any(re.fullmatch(known, self.fault) for known in (ROW_PATTERN, FAULT_PATTERN)):
            raise ValueError(
                f"fault is {self.fault!r}; write a row of docs/faults.md as F13@20s, or a"
                " component as mocap:wrong@20s+5s=0.3 (what.side:how@start+duration=size#seed)"
            )
        return self
