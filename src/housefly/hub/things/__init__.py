"""What is in the room, and where it is by what every source last said of it (TMS_DB's catalogue and
its `now`).
"""
