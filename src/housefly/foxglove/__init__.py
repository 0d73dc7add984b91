"""The room live in Foxglove: one WebSocket that anybody on this machine may watch."""
