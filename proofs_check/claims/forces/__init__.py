"""Claims on grasps: the model, the tables, proofs, methods, modes, and space."""
