"""From video to pose: what a camera sees of the plate and the object on it."""
