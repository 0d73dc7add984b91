"""What every table of a site file is made of."""

from __future__ import annotations

from typing import Any

from pydantic import BaseModel, ConfigDict, Field


def quantity(default: float, low: float, high: float, unit: str, meaning: str) -> Any:
    """Declare a number with its default, inclusive range, unit and one-line meaning."""
    return Field(default, ge=low, le=high, allow_inf_nan=False, description=meaning, json_schema_extra={"unit": unit})


class Section(BaseModel):
    """A frozen table of the site file that knows all its keys."""

    model_config = ConfigDict(frozen=True, extra="forbid", strict=False)
