"""The decision in space: smoothed contacts first, then a tree of contact states."""
