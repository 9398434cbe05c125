"""What several views of planes share: their space, coordinates, names and axes."""
