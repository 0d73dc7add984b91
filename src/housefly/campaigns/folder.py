"""The folder of one campaign: what it is of, one Parquet part a chunk, and at the end one table of all drones.

A part is written under another name and then renamed, so that a part that is there is whole. Each part carries the mark of its
campaign; a part that is foreign, torn or of another size counts as not flown.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
from importlib import metadata
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.campaigns.plan import Chunk, Plan
from housefly.errors import ConfigError, MissingPartError, RecordingError
from housefly.experiments.cases import PARAMETERS, Cases
from housefly.experiments.outcomes import MEASURES, OUTCOME, Outcomes

try:
    import pyarrow as pa
    import pyarrow.parquet as pq
except ImportError as error:
    raise MissingPartError("pyarrow (results as Parquet)", "pip install 'housefly[lab]'") from error

DESCRIPTION = "campaign.json"
RESULTS = "results.parquet"
PARTS = "parts"
UNITS = {parameter.name: parameter.unit for parameter in PARAMETERS} | {measure.name: measure.unit for measure in MEASURES}


def describe(plan: Plan) -> dict[str, Any]:
    """Return everything that the numbers depend on, as plain values."""
    return {
        "spec": plan.spec.model_dump(mode="json"),
        "sites": [leg.site.model_dump(mode="json") for leg in plan.legs],
        "ways": [[list(point) for point in leg.mission.waypoints] for leg in plan.legs],
        "housefly": metadata.version("housefly"),
    }


class CampaignFolder:
    """Results on disk, part by part."""

    def __init__(self, path: Path, plan: Plan, *, fresh: bool = False) -> None:
        """Open the folder of a campaign, or make it.

        Raises:
            ConfigError: the folder holds another campaign; the message names what differs.
            RecordingError: it cannot be written.
        """
        self.path = path
        self._plan = plan
        text = json.dumps(describe(plan), indent=1, sort_keys=True)
        self._mark = hashlib.sha256(text.encode()).hexdigest()
        try:
            if fresh and path.is_dir():
                self._clear()
            (path / PARTS).mkdir(parents=True, exist_ok=True)
            self._claim(text)
        except OSError as error:
            raise RecordingError(f"{path} cannot be written: {error.strerror}") from error

    def missing(self) -> tuple[Chunk, ...]:
        """Return the chunks that are not there yet."""
        return tuple(chunk for chunk in self._plan.chunks if not self._is_whole(chunk))

    def write(self, chunk: Chunk, flown: Outcomes) -> None:
        """Keep the results of a chunk; raises RecordingError when the disk does not take them."""
        cases, cells = self._plan.cases_of(chunk)
        path = self._part(chunk)
        half = path.with_suffix(".writing")
        try:
            pq.write_table(self._table(cases, cells, flown, chunk), half, compression="zstd")
            half.replace(path)
        except OSError as error:
            half.unlink(missing_ok=True)
            raise RecordingError(
                f"{path} cannot be written: {error.strerror or error}; what was flown is kept: run the same again"
            ) from error

    def finish(self) -> pa.Table:
        """Join all parts into ``results.parquet`` and return the table, drones in order."""
        table = pa.concat_tables([pq.read_table(self._part(chunk)) for chunk in self._plan.chunks])
        table = table.replace_schema_metadata({b"campaign": self._mark.encode()})
        half = self.path / f"{RESULTS}.writing"
        try:
            pq.write_table(table, half, compression="zstd")
            half.replace(self.path / RESULTS)
        except OSError as error:
            raise RecordingError(f"{self.path / RESULTS} cannot be written: {error.strerror or error}") from error
        return table

    def _part(self, chunk: Chunk) -> Path:
        return self.path / PARTS / f"part-{chunk.number:06d}.parquet"

    def _is_whole(self, chunk: Chunk) -> bool:
        try:
            found = pq.read_metadata(self._part(chunk))
        except (OSError, pa.ArrowInvalid):
            return False
        marks = found.metadata or {}
        return bool(marks.get(b"campaign") == self._mark.encode() and found.num_rows == chunk.stop - chunk.start)

    def _table(self, cases: Cases, cells: NDArray[np.int64], flown: Outcomes, chunk: Chunk) -> pa.Table:
        varying = (*self._plan.spec.grid, *self._plan.spec.draw)
        columns: dict[str, NDArray[Any]] = {"cell": cells, "seed": cases["seed"]}
        columns |= {name: cases[name] for name in varying}
        columns |= {name: flown[name] for name in OUTCOME.names or ()}
        fields = [
            pa.field(name, pa.from_numpy_dtype(values.dtype), metadata={b"unit": UNITS.get(name, "1").encode()})
            for name, values in columns.items()
        ]
        marks = {b"campaign": self._mark.encode(), b"chunk": str(chunk.number).encode()}
        return pa.table([np.ascontiguousarray(values) for values in columns.values()], schema=pa.schema(fields, metadata=marks))

    def _claim(self, text: str) -> None:
        description = self.path / DESCRIPTION
        if not description.is_file():
            half = description.with_suffix(".writing")
            half.write_text(text, encoding="utf-8")
            half.replace(description)
            return
        there = description.read_text(encoding="utf-8")
        if there != text:
            raise ConfigError(
                "--out",
                f"{self.path} holds another campaign (it differs in {_difference(there, text)}): "
                "choose another folder, or --fresh",
            )

    def _clear(self) -> None:
        """Remove what an earlier campaign left; refuses a folder that is none."""
        if not any(self.path.iterdir()):
            return
        if not (self.path / DESCRIPTION).is_file():
            raise ConfigError("--fresh", f"{self.path} is not the folder of a campaign: nothing was removed")
        shutil.rmtree(self.path / PARTS, ignore_errors=True)
        for name in (DESCRIPTION, RESULTS):
            (self.path / name).unlink(missing_ok=True)


def _difference(there: str, here: str) -> str:
    try:
        old, new = json.loads(there), json.loads(here)
    except ValueError:
        return f"{DESCRIPTION} cannot be read"
    return ", ".join(_differing(old, new, ""))[:300] or "the order of keys"


def _differing(old: Any, new: Any, key: str) -> list[str]:
    if isinstance(old, dict) and isinstance(new, dict):
        names = sorted(set(old) | set(new))
        return [found for name in names for found in _differing(old.get(name), new.get(name), f"{key}.{name}".lstrip("."))]
    return [] if old == new else [key]


def free_space(path: Path) -> int:
    """Return how many bytes are free where a folder is or will be."""
    while not path.exists() and path != path.parent:
        path = path.parent
    return shutil.disk_usage(os.fspath(path)).free
