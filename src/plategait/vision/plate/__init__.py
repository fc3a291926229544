"""Where the plate is, how it swings, and the plate seen straight."""
