"""Keeps the mode of the house and what the rules remember: one file, whole or not at all."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from pydantic import TypeAdapter, ValidationError

from housefly.config.durable import write_whole
from housefly.config.house_mode import HouseMode
from housefly.errors import StoreError
from housefly.tasks.rules.rule_memory import RuleMemory

_FILE = "rules.json"


@dataclass(frozen=True, slots=True)
class KeptRules:
    """What is kept over a restart."""

    mode: HouseMode
    memory: RuleMemory = field(default_factory=RuleMemory)


_KEPT: TypeAdapter[KeptRules] = TypeAdapter(KeptRules)


class RuleStore:
    """One file in the folder of the tasks.

    Args:
        folder: created if missing.
        first_mode: of the house, when nothing was kept yet.

    Attributes:
        problem: why what was kept could not be read, in words, or "".
    """

    def __init__(self, folder: Path, first_mode: HouseMode) -> None:
        self.problem = ""
        self._file, self._first_mode = folder / _FILE, first_mode

    def load(self) -> KeptRules:
        """Return what was kept; when it cannot be read, the house is in mode privacy."""
        try:
            return _KEPT.validate_json(self._file.read_bytes())
        except FileNotFoundError:
            return KeptRules(self._first_mode)
        except (OSError, ValidationError) as error:
            # Whoever had chosen privacy must not be recorded because a file is broken.
            self.problem = (
                f"{self._file} cannot be read ({_first_line(error)}); the house is in mode privacy"
            )
            return KeptRules(HouseMode.PRIVACY)

    def keep(self, kept: KeptRules) -> None:
        """Write it; raises StoreError when the disk refuses."""
        try:
            write_whole(self._file, _KEPT.dump_json(kept))
        except OSError as error:
            raise StoreError(error.strerror or str(error)) from error


def _first_line(error: Exception) -> str:
    return str(error).splitlines()[0]
