"""The kit of pictures and pages: it knows no planes and no grasps."""
