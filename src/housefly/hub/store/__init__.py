"""The room's memory: what is where and what happened, now and in the past (TMS_DB), in SQLite or
PostgreSQL.
"""
