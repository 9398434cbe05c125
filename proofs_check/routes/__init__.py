"""Second routes of the claims, which share no code with the packages that they test."""
