"""Central planes as great circles: on the sphere and in its charts."""
