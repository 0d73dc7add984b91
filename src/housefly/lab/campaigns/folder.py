"""The folder of one campaign: its description, one Parquet part per chunk, one final table.

A part is written under a temporary name and then renamed, so an existing part is complete. Each
part carries the mark of its campaign; a foreign, torn or wrongly sized part counts as not flown.
"""

from __future__ import annotations

import fcntl
import hashlib
import json
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from housefly.config.text import read_file
from housefly.errors import ConfigError, MissingPartError, RecordingError
from housefly.lab.campaigns.plan import Chunk, Plan
from housefly.lab.campaigns.provenance import describe_plan
from housefly.lab.experiments.cases import CASE, PARAMETERS, Cases
from housefly.lab.experiments.outcomes import MEASURES, OUTCOME, Outcomes

_MAX_KEYS_NAMED = 4
"""At most this many differing keys are named; the rest are counted."""

try:
    import pyarrow as pa
    import pyarrow.parquet as pq
except ImportError as error:
    raise MissingPartError("pyarrow (results as Parquet)", "pip install 'housefly[lab]'") from error

DESCRIPTION_FILE = "campaign.json"
_RESULTS_FILE = "results.parquet"
_PARTS_FOLDER = "parts"
_LOCK_FILE = ".lock"
_UNITS = {parameter.name: parameter.unit for parameter in PARAMETERS} | {
    measure.name: measure.unit for measure in MEASURES
}
_SCHEMA = pa.schema(
    [
        pa.field(
            name, pa.from_numpy_dtype(kind), metadata={b"unit": _UNITS.get(name, "1").encode()}
        )
        for name, kind in [("cell", np.dtype(np.int64))]
        + [(name, table[name]) for table in (CASE, OUTCOME) for name in table.names or ()]
    ]
)
"""Columns of the results: the grid point's number, the drone, its measures."""


class CampaignFolder:
    """Results on disk, part by part; one process at a time."""

    def __init__(self, path: Path, plan: Plan, *, fresh: bool = False) -> None:
        """Open the folder of a campaign, or make it; ``fresh`` forgets what an earlier run left.

        Raises:
            ConfigError: the folder holds another campaign (the message names what differs), or
                another process uses it.
            RecordingError: it cannot be written.
        """
        self.path = path
        self.landed = 0
        self._plan = plan
        description = describe_plan(plan)
        self._mark = (
            hashlib.sha256(json.dumps(description, sort_keys=True).encode()).hexdigest().encode()
        )
        with _telling(path):
            path.mkdir(parents=True, exist_ok=True)
            if fresh:
                self._refuse_strangers()
            self._lock = (path / _LOCK_FILE).open("w")
            self._hold()
            if fresh:
                self._clear()
            (path / _PARTS_FOLDER).mkdir(exist_ok=True)
            self._claim(description)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *reason: object) -> None:
        self.close()

    def close(self) -> None:
        """Let other processes use the folder."""
        self._lock.close()

    def missing(self) -> tuple[Chunk, ...]:
        """Return the chunks still to be flown; every existing part is read and checked."""
        chunks = tuple(chunk for chunk in self._plan.chunks if not self._is_whole(chunk))
        self.landed = self._plan.drones - sum(chunk.drones for chunk in chunks)
        return chunks

    def write(self, chunk: Chunk, flown: Outcomes) -> None:
        """Write the results of a chunk; raises RecordingError when that fails."""
        marks = {b"campaign": self._mark, b"chunk": str(chunk.number).encode()}
        columns = _columns(*self._plan.cases_of(chunk), flown)
        table = pa.table(
            [columns[name] for name in _SCHEMA.names], schema=_SCHEMA.with_metadata(marks)
        )
        with _whole(self._part(chunk)) as half:
            pq.write_table(table, half, compression="zstd", write_page_checksum=True)
        self.landed += chunk.drones

    def finish(self) -> Path:
        """Join all parts into one file, drones in order, and return its path.

        Raises RecordingError when a part is not complete.
        """
        path = self.path / _RESULTS_FILE
        schema = _SCHEMA.with_metadata({b"campaign": self._mark})
        with _whole(path) as half, pq.ParquetWriter(half, schema, compression="zstd") as writer:
            for chunk in self._plan.chunks:
                part = self._read(chunk)
                if part is None:
                    raise RecordingError(f"{self._part(chunk)} is not whole: run the same again")
                writer.write_table(part.replace_schema_metadata(schema.metadata))
        return path

    def _part(self, chunk: Chunk) -> Path:
        return self.path / _PARTS_FOLDER / f"part-{chunk.number:06d}.parquet"

    def _is_whole(self, chunk: Chunk) -> bool:
        return self._read(chunk) is not None

    def _read(self, chunk: Chunk) -> pa.Table | None:
        """Return a part; None when it is absent, torn, or of another campaign or chunk."""
        try:
            table = pq.ParquetFile(self._part(chunk), page_checksum_verification=True).read()
        except (OSError, ValueError, pa.ArrowException):
            return None
        marks = table.schema.metadata or {}
        ours = (marks.get(b"campaign"), marks.get(b"chunk")) == (
            self._mark,
            str(chunk.number).encode(),
        )
        return (
            table
            if ours and table.num_rows == chunk.drones and table.schema.equals(_SCHEMA)
            else None
        )

    def _hold(self) -> None:
        try:
            fcntl.flock(self._lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError as error:
            self._lock.close()
            raise ConfigError(
                "--out",
                f"another process writes into {self.path}; wait for it or choose another folder",
            ) from error

    def _claim(self, description: dict[str, Any]) -> None:
        file = self.path / DESCRIPTION_FILE
        if not file.is_file():
            with _whole(file) as half:
                half.write_text(json.dumps(description, indent=1), encoding="utf-8")
            return
        text = read_file(file).decode("utf-8", "replace")
        differing = _describe_differences(text, description)
        if differing:
            self.close()
            raise ConfigError(
                "--out",
                f"{self.path} holds another campaign ({differing}): choose another folder, or start"
                " over with --fresh",
            )

    def _refuse_strangers(self) -> None:
        strangers = {file.name for file in self.path.iterdir()} - {_LOCK_FILE, _PARTS_FOLDER}
        if strangers and DESCRIPTION_FILE not in strangers:
            raise ConfigError(
                "--fresh", f"{self.path} is not the folder of a campaign: nothing was removed"
            )

    def _clear(self) -> None:
        if (self.path / _PARTS_FOLDER).is_dir():
            shutil.rmtree(self.path / _PARTS_FOLDER)
        for name in (DESCRIPTION_FILE, _RESULTS_FILE):
            (self.path / name).unlink(missing_ok=True)


def _columns(cases: Cases, cells: NDArray[np.int64], flown: Outcomes) -> dict[str, NDArray[Any]]:
    tables = {name: table[name] for table in (cases, flown) for name in table.dtype.names or ()}
    return {
        name: np.ascontiguousarray(values) for name, values in ({"cell": cells} | tables).items()
    }


@contextmanager
def _whole(path: Path) -> Iterator[Path]:
    """Yield a temporary path to write to and rename it on success; a failure leaves nothing."""
    half = path.with_name(f"{path.name}.writing")
    with _telling(path):
        try:
            yield half
            half.replace(path)
        except BaseException:
            half.unlink(missing_ok=True)
            raise


@contextmanager
def _telling(path: Path) -> Iterator[None]:
    try:
        yield
    except OSError as error:
        raise RecordingError(
            f"{path} cannot be written: {error.strerror or error}; what has landed is kept, run the"
            " same again to go on"
        ) from error


def _describe_differences(there: str, here: dict[str, Any]) -> str:
    """Return how a description on disk (JSON) differs from ours; "" when it does not."""
    try:
        old = json.loads(there)
    except (ValueError, RecursionError):
        return "its description cannot be read"
    found = _differing(old, json.loads(json.dumps(here)), "")
    more = f" and {len(found) - _MAX_KEYS_NAMED} more" if len(found) > _MAX_KEYS_NAMED else ""
    return f"it differs in {', '.join(found[:_MAX_KEYS_NAMED])}{more}" if found else ""


def _differing(old: Any, new: Any, key: str) -> list[str]:
    if isinstance(old, dict) and isinstance(new, dict):
        return [
            told
            for name in sorted(set(old) | set(new))
            for told in _differing(old.get(name), new.get(name), f"{key}.{name}" if key else name)
        ]
    return [] if old == new else [f"{key}: there {_short(old)}, here {_short(new)}"]


def _short(value: Any) -> str:
    text = "nothing" if value is None else json.dumps(value)
    return text if len(text) <= 40 else f"{text[:37]}..."
