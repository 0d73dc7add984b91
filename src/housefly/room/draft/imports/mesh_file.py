"""Scans that trimesh reads: PLY, OBJ, STL and glTF."""

from __future__ import annotations

import json
import struct
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from housefly.errors import MissingPartError, RoomError
from housefly.messages.words import Words, figure
from housefly.room.draft.imports.scan_part import ScanFile, ScanPart, refuse_too_many_points

_TREE_MAX = 64 * 2**20
"""Longest JSON of a glTF [bytes]."""
_DRACO = "KHR_draco_mesh_compression"
_MESHOPT = ("EXT_meshopt_compression", "KHR_meshopt_compression", "MESHOPT_compression")
_QUANTIZED = "KHR_mesh_quantization"
_FLOAT = 5126
"""componentType of numbers that need no scaling."""


def read_mesh(path: Path) -> ScanFile:
    """Return the parts of a scan; raises RoomError, or what a broken file raises in trimesh."""
    try:
        import trimesh
    except ImportError as error:
        raise MissingPartError(
            Words("the reader of scans ({name})", name="trimesh"), "pip install 'housefly[import]'"
        ) from error
    if path.suffix.lower() in (".glb", ".gltf"):
        _check_gltf(path)
    scene: Any
    # Only files beside it may be named inside it, and nothing is fetched.
    with np.errstate(all="ignore"):
        scene = trimesh.load_scene(path, allow_remote=False, process=False)
    placed = [scene.geometry[scene.graph[node][1]] for node in scene.graph.nodes_geometry]
    count = sum(len(part.vertices) for part in placed if hasattr(part, "vertices"))
    refuse_too_many_points(count, path.name)
    found = scene.dump()
    shapes = [part for part in found if getattr(part, "vertices", None) is not None]
    lost = len(found) - len(shapes)
    if any(shape.vertices.ndim != 2 or shape.vertices.shape[1] != 3 for shape in shapes):
        raise RoomError(Words("{name} has points without three coordinates each", name=path.name))
    note = Words("left out: {n} parts that are neither points nor surfaces", n=figure(lost))
    return ScanFile(
        tuple(_part(shape) for shape in shapes if len(shape.vertices)),
        None,
        (note,) if lost else (),
    )


def _part(shape: Any) -> ScanPart:
    faces = getattr(shape, "faces", None)
    faces = np.empty((0, 3)) if faces is None else faces
    return ScanPart(
        np.asarray(shape.vertices, dtype=np.float64),
        np.asarray(faces, dtype=np.int64).reshape(-1, 3),
    )


def _check_gltf(path: Path) -> None:
    """Raise RoomError for a glTF whose points trimesh does not read, or reads as others."""
    tree = _gltf_tree(path)
    if not isinstance(tree, dict):
        return  # trimesh says what is wrong
    needed = _words(tree.get("extensionsRequired"))
    used = _words(tree.get("extensionsUsed")) | needed
    if _DRACO in used and find_spec("DracoPy") is None:
        raise RoomError(
            Words(
                "{name} stores its surfaces by {thing}, which is not read: export it without"
                " compression, or pip install DracoPy",
                name=path.name,
                thing=_DRACO,
            )
        )
    for name in _MESHOPT:
        if name in needed:
            raise RoomError(
                Words(
                    "{name} stores its surfaces by {thing}, which is not read: export it without"
                    " compression",
                    name=path.name,
                    thing=name,
                )
            )
    if _scales_integers(tree):
        raise RoomError(
            Words(
                "{name} stores its surfaces by {thing}, which is not read: export it without"
                " compression or quantization",
                name=path.name,
                thing=_QUANTIZED,
            )
        )
    for uri in _uris(tree):
        if not uri.startswith("data:") and not (path.parent / uri).is_file():
            raise RoomError(
                Words(
                    "{name} needs {thing}, which is not beside it: choose both files, or export it"
                    " as one .glb",
                    name=path.name,
                    thing=repr(uri),
                )
            )


def _gltf_tree(path: Path) -> Any:
    try:
        size = path.stat().st_size
        with path.open("rb") as file:
            if path.suffix.lower() == ".glb":
                head = file.read(20)
                size = min(size, struct.unpack("<I", head[12:16].ljust(4, b"\0"))[0])
            text = file.read(min(size, _TREE_MAX))
        return json.loads(text)
    except (OSError, ValueError, RecursionError):
        return None


def _words(value: Any) -> frozenset[str]:
    return frozenset(map(str, value)) if isinstance(value, list) else frozenset()


def _items(tree: dict[str, Any], key: str) -> list[dict[str, Any]]:
    value = tree.get(key)
    return [one for one in value if isinstance(one, dict)] if isinstance(value, list) else []


def _uris(tree: dict[str, Any]) -> list[str]:
    return [str(one["uri"]) for one in _items(tree, "buffers") if one.get("uri")]


def _scales_integers(tree: dict[str, Any]) -> bool:
    """Return whether positions are whole numbers that stand for parts of one."""
    accessors = tree.get("accessors")
    for mesh in _items(tree, "meshes"):
        for primitive in _items(mesh, "primitives"):
            attributes = primitive.get("attributes")
            at = attributes.get("POSITION") if isinstance(attributes, dict) else None
            if not (isinstance(at, int) and isinstance(accessors, list) and at < len(accessors)):
                continue
            accessor = accessors[at]
            if not isinstance(accessor, dict):
                continue
            if accessor.get("normalized") and accessor.get("componentType") != _FLOAT:
                return True
    return False
