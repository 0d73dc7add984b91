"""The room's memory, now and in the past (TMS_DB), in SQLite or PostgreSQL."""
