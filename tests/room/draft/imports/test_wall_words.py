"""Layers that hold walls are known by their names in the languages that plans are drawn in."""

from __future__ import annotations

import unicodedata

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.room.draft.imports.plan import names_any, names_wall

WALLS = (
    "A-WALL", "IfcWallStandardCase", "walls-exterior", "Partitions", "Wände", "Aussenwand",
    "WAENDE_INNEN", "Mauerwerk", "Cloisons", "Murs porteurs", "MUR", "paroi", "Muro", "MUROS EXT",
    "Tabiques", "Paredes", "Parete", "pareti interne", "Tramezzi", "Muren-muur", "Väggar", "Vægge",
    "Ściany", "Стены", "壁", "外壁", "間仕切り壁", "墙体", "벽체",
)  # fmt: skip
OTHERS = ("0", "A-DOOR", "Möbel", "Türen", "Portes", "Fenêtres", "家具", "MURAL-ART", "Lemur", "")


@pytest.mark.parametrize("form", ["NFC", "NFD"])
@given(change=st.sampled_from([str.upper, str.lower, str.title, str]))
def test_words_for_wall_are_known_in_any_case_and_form(form: str, change: type[str]) -> None:
    for name in WALLS:
        assert names_wall(change(unicodedata.normalize(form, name))), name
    for name in OTHERS:
        assert not names_wall(change(unicodedata.normalize(form, name))), name


def test_a_word_that_is_said_is_found_without_its_accents() -> None:
    assert names_any("Bestand|WÄNDE EG", ("wande",))
    assert not names_any("Decken", ("wande",))
