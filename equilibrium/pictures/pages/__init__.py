"""Pages: the resisted forces of a grasp, and a proof that is stepped through."""
