from pathlib import Path

from campaign_tables import columns_table, measures_table


def test_the_page_of_campaigns_lists_every_column_and_measure_as_they_are() -> None:
    page = Path(__file__).resolve().parents[2] / "docs" / "campaigns.md"
    text = page.read_text(encoding="utf-8")
    assert columns_table() in text
    assert measures_table() in text
