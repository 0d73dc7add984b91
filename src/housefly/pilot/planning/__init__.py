"""Paths through the occupancy grid (paper IV-B)."""
