"""Whether forces inside the cones, in space round ones, balance one wrench, or every one."""
