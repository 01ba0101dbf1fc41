"""minipov: the minipov room."""
