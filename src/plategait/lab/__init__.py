"""The lab: one HTML file in which the engine itself runs, with what it shows and what it knows."""
