"""Clients of motion capture systems."""
