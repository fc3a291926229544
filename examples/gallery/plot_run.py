"""
One run, and what it shows
==========================

A slice of cheese on a plate that tilts by 12 deg at 12 Hz, at the border of walking and running.
"""

import plategait as pg

cheese = pg.preset("cheese").scenario
run = pg.simulate(cheese.replace(**{"motion.frequency": "12 Hz", "motion.angle": "12 deg", "duration": "2 s"}))
print(run)

# %%
# Its rotation, its legs and its height over time.

figure = run.plot()
