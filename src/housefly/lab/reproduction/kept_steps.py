"""The steps of Fig. 11 in a file."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
from pydantic import TypeAdapter, ValidationError

from housefly.config.profile import Interval
from housefly.lab.reproduction.angular_step import AngularStep
from housefly.lab.reproduction.fig11_angles import StepFlight

_CONSTANTS = TypeAdapter(dict[str, Interval])
_FIT = TypeAdapter(AngularStep)


def write_step_flight(path: Path, steps: StepFlight) -> None:
    """Write the steps; the file has its name only when it is whole."""
    part = path.with_suffix(f".{os.getpid()}.part")
    with part.open("wb") as file:
        np.savez(
            file,
            onboard=np.array(steps.onboard),
            tracked=np.array(steps.tracked),
            fit=np.array(_FIT.dump_json(steps.fit).decode()),
            constants=np.array(_CONSTANTS.dump_json(steps.constants).decode()),
        )
    part.replace(path)


def read_step_flight(path: Path) -> StepFlight | None:
    """Return the steps; None where the file is absent or damaged."""
    try:
        with np.load(path, allow_pickle=False) as file:
            onboard, tracked = file["onboard"], file["tracked"]
            return StepFlight(
                (onboard[0], onboard[1]),
                (tracked[0], tracked[1]),
                _FIT.validate_json(str(file["fit"])),
                _CONSTANTS.validate_json(str(file["constants"])),
            )
    except (OSError, ValueError, KeyError, IndexError, EOFError, ValidationError):
        return None
