"""Grasps in space: their picture, page, proofs, and slices of what they resist."""
