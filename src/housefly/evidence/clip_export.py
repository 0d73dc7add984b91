"""Clips with all that is known of them, as a ZIP file or a folder, and hashes to prove it by."""

from __future__ import annotations

import json
import shutil
import zipfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from datetime import UTC, datetime
from hashlib import file_digest, sha256
from pathlib import Path
from typing import TYPE_CHECKING

from housefly.errors import TaskError
from housefly.evidence.clip_values import ClipRefusal
from housefly.evidence.clip_writer import create_private

if TYPE_CHECKING:
    from housefly.evidence.clip_index import ClipIndex

_HASHES, _METADATA = "SHA256SUMS", "clips.json"
_CHUNK = 2**18
EXPORTED_MAX = 200
"""Clips in one export."""


@dataclass(frozen=True, slots=True)
class ClipExport:
    """What leaves the house.

    Attributes:
        files: of clips and snapshots.
        metadata: what each shows, when, why, and who did what with it: JSON.
    """

    files: tuple[Path, ...]
    metadata: bytes


def exported(index: ClipIndex, names: Sequence[str], who: str) -> ClipExport:
    """Return clips to export; it is written down who exports what.

    Args:
        index: of the clips.
        names: their ids.
        who: exports them.

    Raises:
        TaskError: there is no such clip, or too many are asked for.
        StoreError: the index does not answer.
    """
    wanted = list(dict.fromkeys(names))
    if not 1 <= len(wanted) <= EXPORTED_MAX:
        words = f"{len(wanted)} clips are no export; allowed: 1 to {EXPORTED_MAX}"
        raise TaskError(words, ClipRefusal.NO_SUCH_CLIP.value)
    files = tuple(index.file(name) for name in wanted)
    rows = [
        {
            **asdict(index.log_access(name, who, "exported")),
            "file": path.name,
            "views": [asdict(entry) | {"when": _date(entry.at)} for entry in index.audit_log(name)],
        }
        for name, path in zip(wanted, files, strict=True)
    ]
    dated = [row | {"when": _date(row["began_at"])} for row in rows]
    return ClipExport(files, json.dumps(dated, indent=1, ensure_ascii=False).encode())


def zipped(export: ClipExport) -> Iterator[bytes]:
    """Yield a ZIP file piece by piece, with a list of hashes; nothing of it is kept anywhere.

    ``sha256sum --check SHA256SUMS`` tells whether a file was changed later. May raise OSError.
    """
    sink = _Sink()
    # Pictures are compressed already.
    with zipfile.ZipFile(sink, "w", zipfile.ZIP_STORED) as archive:
        hashes = [_hash_line(export.metadata, _METADATA)]
        archive.writestr(_METADATA, export.metadata)
        for path in export.files:
            digest = sha256()
            with (
                path.open("rb") as source,
                archive.open(path.name, "w", force_zip64=True) as target,
            ):
                while piece := source.read(_CHUNK):
                    digest.update(piece)
                    target.write(piece)
                    yield sink.taken()
            hashes.append(f"{digest.hexdigest()}  {path.name}\n")
        archive.writestr(_HASHES, "".join(hashes))
    yield sink.taken()


def write_folder(export: ClipExport, folder: Path, more: Mapping[str, bytes]) -> tuple[Path, ...]:
    """Copy an export into a folder, for this user only, and return the files.

    Args:
        export: what leaves the house.
        folder: made if missing, mode 0700; files of the same name are replaced.
        more: further files by name.

    Raises:
        OSError: a file cannot be read or written.
    """
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    written = []
    for source in export.files:
        create_private(target := folder / source.name)
        shutil.copyfile(source, target)
        written.append(target)
    for name, content in {_METADATA: export.metadata, **more}.items():
        written.append(_written(folder / name, content))
    hashes = "".join(_file_line(path) for path in written)
    return (*written, _written(folder / _HASHES, hashes.encode()))


def _written(path: Path, content: bytes) -> Path:
    create_private(path)
    path.write_bytes(content)
    return path


def _file_line(path: Path) -> str:
    with path.open("rb") as file:
        return f"{file_digest(file, 'sha256').hexdigest()}  {path.name}\n"


def _hash_line(content: bytes, name: str) -> str:
    return f"{sha256(content).hexdigest()}  {name}\n"


def _date(at: object) -> str:
    """Return a Unix time [s] for people."""
    return datetime.fromtimestamp(float(str(at)), UTC).isoformat(timespec="seconds")


class _Sink:
    """A file that hands over what was written to it."""

    def __init__(self) -> None:
        self._waiting = bytearray()

    def write(self, data: bytes) -> int:
        self._waiting += data
        return len(data)

    def flush(self) -> None:
        """Nothing waits anywhere else."""

    def close(self) -> None:
        """Nothing is open."""

    def taken(self) -> bytes:
        taken, self._waiting = bytes(self._waiting), bytearray()
        return taken
