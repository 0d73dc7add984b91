"""What is in the room and where, from the last report of every source (TMS_DB's catalogue and `now`)."""
