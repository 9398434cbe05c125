"""How the lists of types were made; `make census` runs it. The wheel has the lists alone."""
