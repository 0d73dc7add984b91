"""The blocks of an identification flight as a file beside its recording."""

from __future__ import annotations

import json
from pathlib import Path

from housefly.config.text import read_text_file
from housefly.errors import RecordingError
from housefly.lab.identification.pattern import Axis, Block
from housefly.lab.identification.samples import Flown

_FILE_NAME = "blocks.json"


def write_blocks(folder: Path, flown: tuple[Flown, ...]) -> None:
    """Write which blocks were flown, and when each began."""
    rows = [
        {
            "axis": own.block.axis.value,
            "amplitude": own.block.amplitude,
            "part": own.block.part,
            "signs": own.block.signs,
            "tail": own.block.tail,
            "began": own.began,
        }
        for own in flown
    ]
    (folder / _FILE_NAME).write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")


def read_blocks(folder: Path) -> tuple[Flown, ...]:
    """Return the blocks that were flown; raises RecordingError when the file is not readable."""
    try:
        rows = json.loads(read_text_file(folder / _FILE_NAME))
        return tuple(
            Flown(
                Block(
                    Axis(row["axis"]),
                    float(row["amplitude"]),
                    float(row["part"]),
                    tuple(map(float, row["signs"])),
                    float(row["tail"]),
                ),
                float(row["began"]),
            )
            for row in rows
        )
    except (OSError, ValueError, KeyError, TypeError, RecursionError) as error:
        raise RecordingError(f"{folder / _FILE_NAME} is no list of blocks: {error}") from error
