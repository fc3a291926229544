"""What is simulated: the sheet, the plate's motion, contact and friction, all of it as a scenario."""
