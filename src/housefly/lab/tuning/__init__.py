"""Gains, filter and margins for one drone and one tracking system (paper V-C)."""
