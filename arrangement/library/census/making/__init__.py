"""How the lists of types were made, and what they say in numbers."""
