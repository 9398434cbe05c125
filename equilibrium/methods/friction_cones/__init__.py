"""Methods that ask whether forces exist in the cones of friction."""
