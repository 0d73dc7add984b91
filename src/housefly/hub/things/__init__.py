"""What is in the room and where, by the last reports (TMS_DB's catalogue and `now`)."""
