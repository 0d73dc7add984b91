from __future__ import annotations

from pathlib import Path

import pytest
from console_types import generated_files


@pytest.mark.parametrize("path", generated_files(), ids=lambda path: str(path.name))
def test_the_typescript_types_are_current(path: Path) -> None:
    assert path.read_text(encoding="utf-8") == generated_files()[path], (
        "run: python scripts/console_types.py"
    )
