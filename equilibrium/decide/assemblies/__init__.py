"""Several bodies in the plane with contacts between them and with the ground."""
