from pathlib import Path

from site_page import site_page


def test_the_page_of_the_site_file_is_current() -> None:
    page = Path(__file__).resolve().parents[2] / "docs" / "site.md"
    assert page.read_text(encoding="utf-8") == site_page()
