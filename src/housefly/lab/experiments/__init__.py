"""The closed loop for thousands of drones at once, with the compiled step of the live pilot."""
