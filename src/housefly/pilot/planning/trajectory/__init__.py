"""A smooth curve through free voxels and the times on it: what is planned is what is flown."""
