"""The solver of grasps in the plane: contact states, and a search with cuts."""
