"""Flies the campaign of one file and returns its table and its summary."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from housefly.app.public.temporary_folder import TemporaryFolder
from housefly.lab.campaigns.folder import CampaignFolder
from housefly.lab.campaigns.plan import plan_campaign
from housefly.lab.campaigns.runner import LocalFleet, fly_chunks
from housefly.lab.campaigns.spec import COLUMN_WORDS, CampaignSpec, load_spec
from housefly.lab.campaigns.summary import GridPoint, summarize_campaign, value_text, write_summary
from housefly.sites.loaded_site import read_site


@dataclass(frozen=True, slots=True, eq=False)
class CampaignResult:
    """A campaign that is over.

    Attributes:
        spec: what was asked for.
        points: means and shares with their intervals, for each point of the grid.
        table: ``results.parquet``, one row for each drone.
        folder: of the results.
    """

    spec: CampaignSpec = field(repr=False)
    points: tuple[GridPoint, ...] = field(repr=False)
    table: Path
    folder: Path
    _temporary: TemporaryFolder | None = field(default=None, repr=False)

    @property
    def rows(self) -> tuple[dict[str, float | str], ...]:
        """The points as rows for a data frame; measure ``x`` is in ``x``, ``x_low``, ``x_high``."""
        return tuple(_row(self.spec, point) for point in self.points)

    def close(self) -> None:
        """Remove the folder if it is a temporary one."""
        if self._temporary is not None:
            self._temporary.remove()


def run_campaign(
    file: str | Path, *, out: str | Path | None = None, threads: int | None = None
) -> CampaignResult:
    """Fly all drones of a campaign file on this machine, or those that ``out`` still lacks.

    Args:
        file: of the campaign (``docs/campaigns.md`` lists every key).
        out: folder of the results, where a stopped campaign goes on. None takes a temporary one,
            which is removed with the returned ``CampaignResult``.
        threads: number of threads; None for one a core.

    Raises:
        ConfigError: a value is wrong, or ``out`` holds another campaign.
        RecordingError: ``out`` cannot be written to.
        MissingPartError: pyarrow is not installed.
    """
    path = Path(file)
    spec = load_spec(path)
    beside = path.parent / spec.site
    plan = plan_campaign(spec, read_site(str(beside) if beside.exists() else spec.site))
    temporary = TemporaryFolder() if out is None else None
    with CampaignFolder(temporary.path if temporary else Path(out or ""), plan) as folder:
        fly_chunks(plan, folder.missing(), folder, LocalFleet(threads))
        table = folder.finish()
        points = summarize_campaign(spec, table)
        write_summary(folder.path / "summary.csv", spec, points)
    return CampaignResult(spec, points, table, folder.path, temporary)


def _row(spec: CampaignSpec, point: GridPoint) -> dict[str, float | str]:
    row: dict[str, float | str] = {
        name: value_text(name, value) if name in COLUMN_WORDS else value
        for name, value in zip(spec.grid, point.values, strict=True)
    }
    row["drones"] = point.drones
    for name, estimate in point.estimates.items():
        row |= {name: estimate.value, f"{name}_low": estimate.low, f"{name}_high": estimate.high}
    return row
