"""Fly a thousand drones that differ, and read the results as any tool of data people reads them.

Needs: pyarrow: the extra `lab`, which `make setup` brings.
Learns: a campaign is a file; every drone is a row; shares and means come with intervals; with a
    folder to keep, a second run goes on where the first one stopped.
Prints: how many drones flew, what a look into the results says, then for each mode, rate and
    latency the share of stable flights and the error.
"""

import sys
from pathlib import Path

import housefly

try:
    import pyarrow.compute as pc
    import pyarrow.parquet as pq
except ModuleNotFoundError:
    sys.exit("pyarrow is missing; install it with: pip install 'housefly[lab]'")

result = housefly.run_campaign(Path(__file__).with_name("08_tracking_rate.toml"))
spec = result.spec
print(f"{spec.points} points x {spec.seeds} seeds = {spec.drones} drones")

table = pq.read_table(result.table)
slowest = pc.max(table["arrival_time"]).as_py()
print(f"{table.num_rows} rows of {table.num_columns} columns; the slowest took {slowest:.1f} s")

for row in result.rows:
    where = ", ".join(f"{name} {row[name]}" for name in spec.grid)
    share = f"{row['stable']:4.0%} stable ({row['stable_low']:.0%} to {row['stable_high']:.0%})"
    print(f"{where}: {share}, {100 * row['rms_error']:.1f} cm off the path")
