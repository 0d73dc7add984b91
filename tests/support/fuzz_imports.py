"""Fuzz targets: files of rooms, plans and scans, that ``housefly new`` reads."""

from __future__ import annotations

import json
import struct
from collections.abc import Callable, Iterable
from pathlib import Path

from fuzz_target import DEEP, HUGE, FuzzTarget, as_file, split

from housefly.errors import MissingPartError, RoomError
from housefly.room.draft.imports.contracts import ImportHints
from housefly.room.draft.imports.dxf_plan import read_dxf
from housefly.room.draft.imports.imported import imported
from housefly.room.draft.imports.mesh_file import read_mesh
from housefly.room.draft.imports.point_file import read_pcd
from housefly.room.draft.imports.scan_part import without_broken_points
from housefly.room.draft.imports.svg_plan import read_svg
from housefly.room.draft.model import SiteDraft

_ERRORS = (RoomError, MissingPartError)
_SVG = (
    b'<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"'
    b' width="100%" viewBox="0 0 600 400"><style>.a, #b { display: none }</style>'
    b'<symbol id="s" viewBox="0 0 9 9"><path d="M0 0h9v9A3 3 0 0 1 0 9C1 1 2 2 3 3z"/></symbol>'
    b'<g id="walls" transform="rotate(30) scale(2)"><rect width="75%" height="400"/>'
    b'<use xlink:href="#s" x="9" width="50"/><circle class="a" r="2mm"/><text>a</text>'
    b'<polygon points="0,0 6,0 6,4"/></g></svg>'
)
_DXF = (
    b"0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n"
    b"2\nB\n8\n0\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n6\n21\n4\n0\nENDBLK\n0\nENDSEC\n0\nSECTION\n2\n"
    b"ENTITIES\n0\nINSERT\n8\nwalls\n2\nB\n10\n0\n20\n0\n41\n2\n70\n2\n0\nSOLID\n8\nwalls\n10\n0\n"
    b"20\n0\n11\n6\n21\n0\n12\n0\n22\n4\n13\n6\n23\n4\n0\nCIRCLE\n8\nw\n10\n1\n20\n1\n40\n2\n0\n"
    b"TEXT\n8\nw\n1\na\n0\nENDSEC\n0\nEOF\n"
)
_PLY = (
    b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    b"property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    b"0 0 0\n4 0 0\n4 3 nan\n3 0 1 2\n"
)
_PCD = (
    b"VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 1\n"
    b"POINTS 2\nDATA "
)


def _read(read: Callable[[Path], object], name: str) -> Callable[[bytes], None]:
    def parse(data: bytes) -> None:
        with as_file(data, name) as path:
            read(path)

    return parse


def _import(data: bytes) -> None:
    """First the end of the name, then after a line feed the file: a whole room, or why not."""
    end, content = split(data)
    if end in (b"svg", b"dxf", b"obj", b"ply"):
        with as_file(content, f"room.{end.decode()}") as path:
            imported(SiteDraft("fuzzed"), path, ImportHints(unexplored="free"))


def _mesh(data: bytes) -> None:
    """First the end of the name, then after a line feed the file."""
    end, content = split(data)
    if end in (b"ply", b"obj", b"stl", b"glb", b"gltf"):
        with as_file(content, f"scan.{end.decode()}") as path:
            try:
                scan = read_mesh(path)
            except _ERRORS:
                raise
            except Exception:  # what trimesh makes of it; the importer puts it into words
                return
            without_broken_points(scan.parts, path.name)


def _pcd(data: bytes) -> None:
    with as_file(data, "scan.pcd") as path:
        try:
            read_pcd(path)
        except _ERRORS:
            raise
        except Exception:  # what pypcd4 makes of it; the importer puts it into words
            return


def _mesh_seeds() -> Iterable[bytes]:
    yield b"ply\n" + _PLY
    yield b"obj\nv 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n"
    yield b"stl\n" + bytes(80) + struct.pack("<I12fH", 1, *range(12), 0)
    tree = {
        "asset": {"version": "2.0"},
        "extensionsRequired": ["KHR_mesh_quantization"],
        "buffers": [{"byteLength": 4, "uri": "data:application/octet-stream;base64,AAAAAA=="}],
        "bufferViews": [{"buffer": 0, "byteLength": 4}],
        "accessors": [{"bufferView": 0, "componentType": 5122, "count": 1, "type": "VEC3"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 0}]}],
        "nodes": [{"mesh": 0, "scale": [2, 2, 2]}],
        "scenes": [{"nodes": [0]}],
    }
    text = json.dumps(tree).encode()
    yield b"gltf\n" + text
    yield b"glb\n" + struct.pack("<4sIII4s", b"glTF", 2, 20 + len(text), len(text), b"JSON") + text
    yield b"gltf\n" + DEEP
    yield b'gltf\n{"accessors": [' + HUGE + b'], "buffers": [{"uri": 5}]}'


def _pcd_seeds() -> Iterable[bytes]:
    points = struct.pack("<6f", *range(6))
    yield _PCD + b"ascii\n0 0 0\n1 nan 1\n"
    yield _PCD + b"binary\n" + points
    yield _PCD + b"binary_compressed\n" + struct.pack("<II", 25, 24) + b"\x17" + points
    yield _PCD.replace(b"POINTS 2", b"POINTS " + HUGE) + b"binary\n"
    yield _PCD.replace(b"COUNT 1", b"COUNT " + HUGE) + b"ascii\n"


IMPORTS: dict[str, FuzzTarget] = {
    "room_file": FuzzTarget(_import, lambda: (b"dxf\n" + _DXF, b"ply\n" + _PLY), _ERRORS),
    "plan_svg": FuzzTarget(
        _read(read_svg, "plan.svg"), lambda: (_SVG,), _ERRORS, words=(b"%", b"<use", b"e400")
    ),
    "plan_dxf": FuzzTarget(
        _read(read_dxf, "plan.dxf"), lambda: (_DXF,), _ERRORS, words=(b"\n0\nINSERT\n", b"HATCH")
    ),
    "scan_mesh": FuzzTarget(_mesh, _mesh_seeds, _ERRORS, words=(b"nan", b"1e999")),
    "scan_pcd": FuzzTarget(_pcd, _pcd_seeds, _ERRORS),
}
