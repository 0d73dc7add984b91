"""Drone drivers."""
