"""Kalman filter (paper V-D)."""
