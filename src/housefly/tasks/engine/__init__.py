"""The open tasks of one drone: queue, runs, rehearsals, and what they do."""
