"""Keeps what people changed of rules on the page: one file, whole or not at all."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated

from pydantic import Field, TypeAdapter, ValidationError

from housefly.config.durable import write_whole
from housefly.errors import StoreError
from housefly.tasks.rules.rule import Name
from housefly.tasks.rules.rule_change import RuleChange
from housefly.tasks.rules.rule_file import MAX_RULES

CHANGES_FILE = "rule_changes.json"
_Changes = Annotated[dict[Name, RuleChange], Field(max_length=MAX_RULES)]
_CHANGES: TypeAdapter[dict[str, RuleChange]] = TypeAdapter(_Changes)


class ChangeStore:
    """The changes of the page, by rule, in the folder of the tasks.

    Args:
        folder: created if missing.

    Attributes:
        problem: why what was kept could not be read, in words, or "".
    """

    def __init__(self, folder: Path) -> None:
        self.problem = ""
        self._file = folder / CHANGES_FILE

    def load(self) -> dict[str, RuleChange]:
        """Return what was kept; nothing, and a problem, when it cannot be read."""
        try:
            return _CHANGES.validate_json(self._file.read_bytes())
        except FileNotFoundError:
            return {}
        except (OSError, ValidationError) as error:
            reason = str(error).splitlines()[0]
            # Whoever had wanted to be asked must not be flown over because a file is broken.
            self.problem = f"{self._file} cannot be read ({reason}); every rule asks first"
            return {}

    def keep(self, changes: Mapping[str, RuleChange]) -> None:
        """Write them; raises StoreError when the disk refuses, or the file could not be read."""
        if self.problem:
            raise StoreError(f"mend or delete it first, then start again: {self.problem}")
        try:
            text = _CHANGES.dump_json(dict(changes), indent=2, exclude_defaults=True)
            write_whole(self._file, text + b"\n")
        except OSError as error:
            raise StoreError(error.strerror or str(error)) from error
