"""The constructs of SDL, one place each: what a block is called, what it accepts, what it yields."""
