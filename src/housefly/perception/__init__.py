"""Detects people and things that no map shows: background subtraction, clustering, tracking."""
