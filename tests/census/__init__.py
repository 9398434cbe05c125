"""How the lists of isomorphism classes are made; ``make census`` runs it."""
