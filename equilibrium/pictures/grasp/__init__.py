"""A grasp in the plane, its forces and motions, and proofs about it."""
