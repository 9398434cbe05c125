"""The search for equilibria: contact states, the linear system of each, its exact solution."""
