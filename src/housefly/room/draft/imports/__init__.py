"""Rooms from files: maps, scans and floor plans become the walls and boxes of a draft."""
