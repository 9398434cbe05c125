"""The slip lab: an interactive page for grasps."""
