"""Methods with a law for the forces of contacts: springs, friction, or both."""
