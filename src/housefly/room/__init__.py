"""The room as a value: model, places, occupancy grid, drawing, import."""
