"""Whether anything balances a load: an equilibrium, or motions cut into regions that fail."""
