"""Whatever bytes a file holds, it becomes a room or is refused in words."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from housefly.errors import HouseflyError, MissingPartError
from housefly.room.draft.codec import draft_from_json, draft_to_json
from housefly.room.draft.imports.imported import IMPORT_SUFFIXES, imported
from housefly.room.draft.model import SiteDraft

BEGINNINGS = {
    ".ply": b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    b"property float z\nend_header\n",
    ".obj": b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    ".stl": b"solid a\n",
    ".glb": b"glTF\x02\x00\x00\x00",
    ".gltf": b'{"asset": {"version": "2.0"}, "buffers": [{"uri": "/etc/hostname"}]}',
    ".svg": b'<svg xmlns="http://www.w3.org/2000/svg"><path d="M0,0 L',
    ".dxf": b"0\nSECTION\n2\nENTITIES\n",
    ".yaml": b"image: map.pgm\n",
}


@pytest.mark.parametrize("suffix", IMPORT_SUFFIXES)
@settings(max_examples=25, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(tail=st.binary(max_size=200) | st.text("0123456789 .,-eLMlaAzZ\n\"<>/=", max_size=200).map(
    str.encode
), begins=st.booleans())  # fmt: skip
def test_any_bytes_are_a_room_or_refused(
    tmp_path: Path, suffix: str, tail: bytes, begins: bool
) -> None:
    path = tmp_path / f"file{suffix}"
    path.write_bytes((BEGINNINGS.get(suffix, b"") if begins else b"") + tail)
    try:
        found = imported(SiteDraft("any"), path)
    except HouseflyError as error:
        assert str(error)
        return
    assert draft_from_json(draft_to_json(found.draft)) == found.draft


@pytest.mark.parametrize(
    ("suffix", "module"),
    [
        (".ply", "trimesh"),
        (".svg", "svgpathtools"),
        (".dxf", "ezdxf"),
        (".pcd", "pypcd4"),
        (".las", "laspy"),
        (".laz", "lazrs"),
        (".e57", "pye57"),
    ],
)
def test_a_reader_that_is_not_installed_is_named_with_the_line_that_installs_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, suffix: str, module: str
) -> None:
    monkeypatch.setitem(sys.modules, module, None)
    (tmp_path / f"room{suffix}").write_text("x")
    with pytest.raises(MissingPartError, match=re.escape("pip install 'housefly[import]'")):
        imported(SiteDraft("any"), tmp_path / f"room{suffix}")


def test_an_endless_name_of_a_file_is_refused(tmp_path: Path) -> None:
    with pytest.raises(HouseflyError):
        imported(SiteDraft("any"), tmp_path / ("x" * 5000 + ".ply"))
