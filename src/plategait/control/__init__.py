"""A sheet on a shaking plate as control sees it: what the motors can do next, and what a camera delivers of it."""
