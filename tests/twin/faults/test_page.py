"""The page of faults."""

from pathlib import Path

from housefly.twin.faults.page import faults_page


def test_the_page_of_faults_is_current() -> None:
    page = Path(__file__).resolve().parents[3] / "docs" / "faults.md"
    assert page.read_text(encoding="utf-8") == faults_page(), (
        "run: python -m housefly.twin.faults.page > docs/faults.md"
    )
