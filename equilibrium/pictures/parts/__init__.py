"""What several views of grasps share: symbols, numbers as labels, the body, panels of a plane."""
