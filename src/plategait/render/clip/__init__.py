"""Films of simulated runs as a camera would take them, with the truth beside them."""
