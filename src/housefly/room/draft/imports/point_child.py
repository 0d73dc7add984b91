"""Reads LAS and LAZ (laspy) and E57 (pye57) in a process of its own, with bounded memory and time.

Their compiled parts end the whole process on some broken files, where Python's would raise.
"""

from __future__ import annotations

import json
import re
import resource
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from housefly.errors import RoomError
from housefly.messages.words import UNSAID, Words, error_words, figure, from_tree, tree
from housefly.numeric import FloatArray
from housefly.room.draft.imports.scan_part import ScanFile, cloud_part, refuse_too_many_points

_SECONDS, _MEMORY = 600, 12 * 2**30
"""What one file may take: of the processor [s], and of addresses [bytes]."""
_REFUSED = 3
"""Exit status after an error that was put into words."""
_CHUNK = 1_000_000
_NOISE = (7, 18)
"""Classes of LAS for low and high noise."""
_GEO_UNIT = 3076
"""GeoTIFF key of the linear unit."""
_GEO_UNITS = {9001: 1.0, 9002: 0.3048, 9003: 0.304800609601219}
_WKT_UNIT = re.compile(
    r'UNIT\["[^"]*(?:metre|meter|foot|feet)[^"]*",\s*([\d.eE+-]+)', re.IGNORECASE
)

_Read = tuple[FloatArray, float, Words]
"""Points, metres per unit or 0, and a note or UNSAID."""


def read_apart(kind: str, path: Path) -> ScanFile:
    """Return the points of a file, read in a child process.

    Args:
        kind: las or e57.
        path: of the file.

    Raises:
        RoomError: it cannot be read.
    """
    with TemporaryDirectory(prefix="housefly-scan-") as folder:
        kept = Path(folder) / "points.npz"
        line = [sys.executable, "-m", __name__, kind, str(path.absolute()), str(kept)]
        done = subprocess.run(line, capture_output=True, check=False)
        said = done.stderr.decode(errors="replace").strip().splitlines() or [""]
        if done.returncode == _REFUSED:
            raise RoomError(from_tree(json.loads(said[-1])))
        if done.returncode != 0:
            raise RoomError(
                Words("{name} cannot be read: its reader broke; is the file whole?", name=path.name)
            )
        with np.load(kept) as found:
            points, unit = found["points"], float(found["unit"])
            note = from_tree(json.loads(str(found["note"])))
    return ScanFile((cloud_part(points),), unit or None, (note,) if note else ())


def main() -> int:
    """Read the file that the command line names and keep its points; returns the exit status."""
    kind, path, kept = sys.argv[1], Path(sys.argv[2]), sys.argv[3]
    resource.setrlimit(resource.RLIMIT_CPU, (_SECONDS, _SECONDS))
    resource.setrlimit(resource.RLIMIT_AS, (_MEMORY, _MEMORY))
    try:
        points, unit, note = _READERS[kind](path)
    except RoomError as error:
        _tell(error_words(error))
        return _REFUSED
    except Exception as error:  # a broken file makes its reader fail in any way
        said = str(error).strip().partition("\n")[0] or type(error).__name__
        _tell(
            Words(
                "{name} cannot be read as a scan: {why}; is the file whole?",
                name=path.name,
                why=said,
            )
        )
        return _REFUSED
    np.savez(kept, points=points, unit=unit, note=json.dumps(tree(note)))
    return 0


def _tell(words: Words) -> None:
    """Print words for the parent, on one line."""
    print(json.dumps(tree(words)), file=sys.stderr)


def _las(path: Path) -> _Read:
    import laspy

    parts, noise = [np.empty((0, 3))], 0
    with laspy.open(path) as reader:
        header = reader.header
        refuse_too_many_points(header.point_count, path.name)
        for chunk in reader.chunk_iterator(_CHUNK):
            points = np.column_stack([chunk.x, chunk.y, chunk.z]).astype(np.float64)
            is_noise = np.isin(np.asarray(chunk.classification), _NOISE)
            noise += int(is_noise.sum())
            parts.append(points[~is_noise])
    note = Words("left out: {n} points that it calls noise", n=figure(noise))
    return np.vstack(parts), _las_unit(header), note if noise else UNSAID


def _las_unit(header: Any) -> float:
    """Return metres per unit where a LAS says them, else 0."""
    for record in (*header.vlrs, *(header.evlrs or ())):
        for key in getattr(record, "geo_keys", ()):
            if key.id == _GEO_UNIT and key.value_offset in _GEO_UNITS:
                return _GEO_UNITS[key.value_offset]
        if found := _WKT_UNIT.search(getattr(record, "string", "")):
            return float(found[1])
    return 0.0


def _e57(path: Path) -> _Read:
    import pye57

    document = pye57.E57(str(path))
    numbers = range(document.scan_count)
    count = sum(document.get_header(number).point_count for number in numbers)
    refuse_too_many_points(count, path.name)
    axes = ("cartesianX", "cartesianY", "cartesianZ")
    parts = [np.empty((0, 3))]
    for number in numbers:
        scan = document.read_scan(number, ignore_missing_fields=True)
        parts.append(np.column_stack([scan[axis] for axis in axes]))
    return np.vstack(parts), 1.0, UNSAID


_READERS: dict[str, Callable[[Path], _Read]] = {"las": _las, "e57": _e57}


if __name__ == "__main__":
    sys.exit(main())
