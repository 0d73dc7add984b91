"""QR codes: the page's drawing and the terminal's letters show the same modules."""

from __future__ import annotations

import re

import pytest
import segno
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.web.http.qr_code import qr_lines, qr_view

MARGIN = 4


def modules_of_drawing(text: str) -> list[list[bool]]:
    view = qr_view(text)
    rows = [[False] * view.size for _ in range(view.size)]
    parts = re.findall(r"M(\d+) (\d+)h(\d+)v1h-(\d+)z", view.path)
    for x, y, length, back in ((int(n) for n in part) for part in parts):
        assert length == back
        for k in range(length):
            assert not rows[y][x + k], "nothing is drawn twice"
            rows[y][x + k] = True
    return rows


def modules_of_terminal(text: str) -> list[list[bool]]:
    rows = []
    for line in qr_lines(text):
        rows.append([letter not in "█▀" for letter in line])
        rows.append([letter not in "█▄" for letter in line])
    return rows


@settings(max_examples=20)
@given(text=st.text(st.characters(min_codepoint=33, max_codepoint=126), min_size=1, max_size=120))
def test_page_and_terminal_show_what_the_encoder_made(text: str) -> None:
    made = segno.make_qr(text, error="m", boost_error=False)
    expected = [[bool(cell) for cell in row] for row in made.matrix_iter(border=MARGIN)]
    assert modules_of_drawing(text) == expected
    shown = modules_of_terminal(text)
    assert [row[: len(expected)] for row in shown[: len(expected)]] == expected
    assert not any(any(row) for row in shown[len(expected) :])


@pytest.mark.parametrize("host", ["192.168.178.123", "[fd12:3456:789a:bcde:1234:5678:9abc:def0]"])
def test_a_link_fits_a_terminal_of_80_by_30(host: str) -> None:
    lines = qr_lines(f"https://{host}:8080/?token={'A' * 44}")
    assert len(lines) <= 27 and {len(line) for line in lines} <= set(range(40, 54))
