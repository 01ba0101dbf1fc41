"""minipov: the tracer room."""
