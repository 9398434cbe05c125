"""The matroid of the normals: bases, circuits, signs, and what deletion and contraction count."""
