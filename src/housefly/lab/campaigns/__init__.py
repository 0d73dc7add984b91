"""Campaigns: many flights from one specification, resumable, on one machine or many."""
