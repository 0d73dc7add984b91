"""Clips with all that is known of them in one ZIP file, and with hashes to prove it by."""

from __future__ import annotations

import json
import zipfile
from collections.abc import Sequence
from dataclasses import asdict
from hashlib import file_digest, sha256
from pathlib import Path
from typing import IO

from housefly.errors import TaskError
from housefly.tasks.api.values import ReasonCode
from housefly.tasks.evidence.clip_index import ClipIndex
from housefly.tasks.evidence.clip_writer import make_private

_HASHES, _METADATA = "SHA256SUMS", "clips.json"
EXPORTED_MAX = 200
"""Clips in one export."""


def export_clips(index: ClipIndex, names: Sequence[str], who: str, file: Path) -> None:
    """Write clips and snapshots, their metadata, who watched them, and a list of hashes.

    ``sha256sum --check SHA256SUMS`` tells whether one of them was changed later. It is written down
    who exported what.

    Args:
        index: of the clips.
        names: their ids.
        who: exports them.
        file: the ZIP file to write, for this user only; an old one is replaced.

    Raises:
        TaskError: there is no such clip, or too many are asked for.
        StoreError: the index does not answer.
        OSError: the file cannot be written.
    """
    wanted = list(dict.fromkeys(names))
    if not 1 <= len(wanted) <= EXPORTED_MAX:
        words = f"{len(wanted)} clips are no export; allowed: 1 to {EXPORTED_MAX}"
        raise TaskError(words, ReasonCode.BAD_PARAMETER.value)
    clips = [(index.watched(name, who, "exported"), index.file(name)) for name in wanted]
    rows = [
        {
            **asdict(info),
            "file": path.name,
            "views": [asdict(view) for view in index.views(info.id)],
        }
        for info, path in clips
    ]
    metadata = json.dumps(rows, indent=1, ensure_ascii=False).encode()
    make_private(file)
    try:
        with file.open("r+b") as target:
            _write(target, metadata, [path for _, path in clips])
    except OSError:
        file.unlink(missing_ok=True)
        raise


def _write(target: IO[bytes], metadata: bytes, paths: Sequence[Path]) -> None:
    hashes = [(sha256(metadata).hexdigest(), _METADATA)]
    # Pictures are compressed already.
    with zipfile.ZipFile(target, "w", zipfile.ZIP_STORED) as archive:
        archive.writestr(_METADATA, metadata)
        for path in paths:
            with path.open("rb") as source:
                hashes.append((file_digest(source, "sha256").hexdigest(), path.name))
            archive.write(path, path.name)
        lines = "".join(f"{digest}  {name}\n" for digest, name in hashes)
        archive.writestr(_HASHES, lines)
