"""What an SVG shows is read as a browser shows it, or counted by name."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from housefly.errors import RoomError
from housefly.room.draft.imports.contracts import Imported
from housefly.room.draft.imports.drawing import LeftOut
from housefly.room.draft.imports.imported import imported
from housefly.room.draft.imports.svg_plan import read_svg
from housefly.room.draft.model import SiteDraft

pytest.importorskip("svgpathtools")

ROOM = '<rect x="0" y="0" width="600" height="400"/>'
SPACES = (
    'xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" '
    'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"'
)


def svg(folder: Path, body: str, attributes: str = 'viewBox="0 0 800 600"') -> Path:
    path = folder / "plan.svg"
    path.write_text(f"<svg {SPACES} {attributes}>{body}</svg>", encoding="utf-8")
    return path


def read(folder: Path, body: str, attributes: str = 'viewBox="0 0 800 600"') -> Imported:
    return imported(SiteDraft("flat"), svg(folder, body, attributes))


LEAVES = {
    '<path d="M0 0h9v9"/>': "",
    "<rect width='20' height='5'/>": "",
    '<circle r="30"/>': "",
    '<ellipse rx="30" ry="4"/>': "",
    '<line x2="50"/>': "",
    '<polyline points="0,0 5,5 9,0"/>': "",
    '<polygon points="0,0 5,5 9,0"/>': "",
    "<text>a</text>": "none",
    '<image href="a.png"/>': "none",
    '<path d="M0 0 L q"/>': "broken",
    '<circle r="2em"/>': "broken",
    '<line x2="50" transform="turn(3)"/>': "broken",
    '<rect width="5" height="5" style="display:none"/>': "hidden",
    '<rect width="5" height="5" class="away"/>': "hidden",
    '<line x2="50" visibility="hidden"/>': "hidden",
    '<path d="M0 0h9" opacity="0"/>': "hidden",
    '<path d="M0 0h9" fill="none" stroke="none"/>': "hidden",
    "<title>a</title>": "silent",
    '<defs><path id="d" d="M0 0h9"/></defs>': "silent",
}
WHY = {"none": LeftOut.NO_SHAPE, "broken": LeftOut.BROKEN, "hidden": LeftOut.HIDDEN}
GROUPS = {
    "<g>{}</g>": False,
    '<g transform="rotate(20) scale(2)">{}</g>': False,
    '<svg x="5" width="50%" height="20" viewBox="0 0 9 9">{}</svg>': False,
    '<a href="b">{}</a>': False,
    '<g style="display: none">{}</g>': True,
    '<g class="away">{}</g>': True,
}
TREE = st.recursive(
    st.sampled_from(sorted(LEAVES)).map(lambda leaf: (leaf, [(LEAVES[leaf], False)])),
    lambda inner: st.tuples(st.sampled_from(sorted(GROUPS)), st.lists(inner, max_size=3)).map(
        lambda pair: (
            pair[0].format("".join(text for text, _ in pair[1])),
            [(why, gone or GROUPS[pair[0]]) for _, whys in pair[1] for why, gone in whys],
        )
    ),
    max_leaves=8,
)


@settings(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(tree=TREE)
def test_what_is_read_and_what_is_left_out_are_all_that_is_shown(
    tmp_path: Path, tree: tuple[str, list[tuple[str, bool]]]
) -> None:
    body, whys = tree
    drawing = read_svg(svg(tmp_path, f"<style>.away {{ display: none }}</style>{body}"))
    loud = [(why, gone) for why, gone in whys if why != "silent"]
    assert len(drawing.shapes) + drawing.left_out.total() == len(loud)
    assert len(drawing.shapes) == sum(1 for why, gone in loud if not why and not gone)
    hidden = sum(n for (why, _), n in drawing.left_out.items() if why is LeftOut.HIDDEN)
    assert hidden >= sum(1 for why, _ in loud if why == "hidden")


def test_what_is_used_stands_where_it_is_used(tmp_path: Path) -> None:
    found = read(
        tmp_path,
        '<defs><symbol id="piece" viewBox="0 0 10 10"><rect width="10" height="10"/></symbol>'
        '<line id="long" x1="0" y1="0" x2="600" y2="0"/></defs>'
        '<g id="walls"><use xlink:href="#long" x="100" y="100"/>'
        '<use href="#long" transform="translate(100,500)"/>'
        '<line x1="100" y1="100" x2="100" y2="500"/><line x1="700" y1="100" x2="700" y2="500"/>'
        '<use href="#piece" x="300" y="200" width="100" height="200"/><use href="#gone"/></g>',
    )
    assert found.draft.bounds == (0.0, 0.0, 6.0, 4.0)
    # The symbol keeps its shape: a square in the middle of its place.
    square = {point for wall in found.draft.walls[4:] for point in (wall.start, wall.end)}
    assert square == {(2.0, 1.5), (3.0, 1.5), (3.0, 2.5), (2.0, 2.5)}
    assert "left out: 1 use of '#gone', which is not in it (cannot be read)" in found.notes


@pytest.mark.parametrize("attributes", ['width="100%"', 'width="100%" height="auto"', ""])
def test_a_page_of_any_size_is_read(tmp_path: Path, attributes: str) -> None:
    assert read(tmp_path, ROOM, attributes).draft.bounds == (0.0, 0.0, 6.0, 4.0)


def test_shares_of_the_page_are_lengths_and_its_background_is_no_wall(tmp_path: Path) -> None:
    found = read(
        tmp_path,
        '<rect width="100%" height="100%"/><g id="Mauern"><rect width="75%" height="50%"/></g>',
    )
    assert found.draft.bounds == (0.0, 0.0, 6.0, 3.0)
    assert "left out: 1 rect as large as the page (no lines or shapes)" in found.notes


def test_hidden_groups_are_no_walls_and_are_counted(tmp_path: Path) -> None:
    found = read(
        tmp_path,
        f'<g inkscape:label="Wände">{ROOM}<g display="none"><line x2="600" y2="400"/></g></g>'
        '<g inkscape:label="Möbel"><circle cx="100" cy="100" r="30"/></g>',
    )
    assert len(found.draft.walls) == 4
    assert "walls are taken from the layers 'Wände'" in found.notes
    assert "left out: 1 line (hidden, or on a layer that is frozen or off)" in found.notes
    assert "left out: 1 'Möbel' (on layers without walls)" in found.notes


@pytest.mark.parametrize(
    ("attributes", "sides", "words"),
    [
        ('width="9000mm" viewBox="0 0 600 400"', (9.0, 6.0), "0.015 m each, as the file says"),
        ('width="180mm" viewBox="0 0 600 400"', (9.0, 6.0), "were drawn at 1:50, a room of 9 m"),
        ('width="900" viewBox="0 0 600 400"', (6.0, 4.0), "taken for centimetres"),
    ],
)
def test_a_page_in_metres_or_drawn_to_scale_says_the_unit(
    tmp_path: Path, attributes: str, sides: tuple[float, float], words: str
) -> None:
    found = read(tmp_path, ROOM, attributes)
    assert found.draft.bounds is not None
    assert found.draft.bounds[2:] == pytest.approx(sides)
    assert words in "\n".join(found.notes)


def test_a_wall_is_as_thick_as_it_is_drawn(tmp_path: Path) -> None:
    found = read(tmp_path, f'<g stroke="black" stroke-width="12" transform="scale(2)">{ROOM}</g>')
    assert {wall.thickness for wall in found.draft.walls} == {0.24}


def test_any_encoding_that_the_file_names_is_read(tmp_path: Path) -> None:
    text = '<?xml version="1.0" encoding="UTF-16"?><svg><rect id="壁" width="6" height="4"/></svg>'
    path = tmp_path / "plan.svg"
    path.write_bytes(text.encode("utf-16"))
    assert "'壁'" in imported(SiteDraft("flat"), path).notes[0]


@pytest.mark.parametrize(
    "body",
    [
        '<g id="a"><use href="#a"/><path d="M0 0h9"/></g>',
        "".join(f'<g id="a{n}">' + f'<use href="#a{n - 1}"/>' * 10 + "</g>" for n in range(1, 8))
        + '<path id="a0" d="M0 0h9"/>',
    ],
)
def test_what_uses_itself_without_end_is_refused(tmp_path: Path, body: str) -> None:
    with pytest.raises(RoomError, match=r"nested deeper|more than 100000"):
        read(tmp_path, body)
