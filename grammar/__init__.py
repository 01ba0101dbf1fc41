"""minipov: the grammar room."""
