"""Fly a thousand drones that differ, and read the results as any tool of data people reads them.

Learns: a campaign is a file; every drone is a row; shares and means come with intervals; a second
    run goes on where it stopped.
Prints: how many drones fly, what a look into the results says, then for each mode, rate and latency
    the share of stable flights
and the error.
"""

import tempfile
from pathlib import Path

import pyarrow.compute as pc
import pyarrow.parquet as pq

from housefly.app.loaded_site import read_site
from housefly.lab.campaigns.folder import CampaignFolder
from housefly.lab.campaigns.plan import plan_campaign
from housefly.lab.campaigns.runner import LocalFleet, fly_chunks
from housefly.lab.campaigns.spec import load_spec
from housefly.lab.campaigns.summary import summarize_campaign, value_text

spec = load_spec(Path(__file__).parent / "08_tracking_rate.toml")
plan = plan_campaign(spec, read_site(spec.site))
print(f"{spec.points} points x {spec.seeds} seeds = {plan.drones} drones")

with tempfile.TemporaryDirectory() as out, CampaignFolder(Path(out), plan) as folder:
    fly_chunks(plan, folder.missing(), folder, LocalFleet())
    results = folder.finish()
    table = pq.read_table(results)
    slowest = pc.max(table["arrival_time"]).as_py()
    print(
        f"{table.num_rows} rows of {table.num_columns} columns; the slowest arrival took"
        f" {slowest:.1f} s"
    )
    cells = summarize_campaign(spec, results)

for cell in cells:
    where = ", ".join(
        f"{name} {value_text(name, value)}" for name, value in zip(spec.grid, cell.values, strict=True)
    )
    stable, error = cell.estimates["stable"], cell.estimates["rms_error"]
    share = f"{stable.value:4.0%} stable ({stable.low:.0%} to {stable.high:.0%})"
    print(f"{where}: {share}, {100 * error.value:.1f} cm off the path")
