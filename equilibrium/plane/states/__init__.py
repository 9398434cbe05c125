"""Contact states one by one: the linear system of each, its exact solutions."""
