"""The flight-quality gate: how fast, how near, how exact and how steady, scored on the truth."""
