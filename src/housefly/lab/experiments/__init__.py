"""The closed loop for thousands of drones at once, made of the functions that the live pilot calls."""
