"""Closed forms and small models: a rigid object on the plate, beams and plates, two links."""
