"""From scenarios through an engine to what the runs show."""
