"""The room's memory: stores what every sensor reports and answers questions about it.

No flight waits for it.
"""
