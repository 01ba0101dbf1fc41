"""minipov: the interpreter room."""
