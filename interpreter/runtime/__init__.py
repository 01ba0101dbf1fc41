"""What compiled scenes run on: names, sinks, directives, functions of the language."""
