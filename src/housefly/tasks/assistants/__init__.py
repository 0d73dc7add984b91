"""What assistants may ask of a room, over MCP."""
