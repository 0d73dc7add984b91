"""The page of faults."""

from pathlib import Path

from faults_page import faults_page


def test_the_page_of_faults_is_current() -> None:
    page = Path(__file__).resolve().parents[2] / "docs" / "faults.md"
    assert page.read_text(encoding="utf-8") == faults_page(), (
        "run: python scripts/faults_page.py > docs/faults.md"
    )
