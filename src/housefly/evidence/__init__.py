"""Clips and snapshots: recorded only when a task asks, kept only as long as allowed."""
