"""What a claim is, and what its verdict rests on."""
