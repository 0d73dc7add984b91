"""Feedback linearization, altitude and yaw laws (paper V-C)."""
