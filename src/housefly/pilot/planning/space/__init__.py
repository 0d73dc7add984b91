"""The room in three dimensions: clearance by voxels, shortest ways, ways at any angle."""
