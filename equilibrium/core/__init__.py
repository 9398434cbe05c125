"""The law of a contact, and searches with any number of coordinates: trees, smooth contacts."""
