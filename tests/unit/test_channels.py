"""The list of channels against the core's own, and what is made of it."""

from __future__ import annotations

import numpy as np
import plategait._native as native
import pytest

from plategait.campaign.series import thinned
from plategait.engine.channels import CHANNELS, ROTATION, SERIES, check_series
from plategait.errors import InputError
from plategait.model.presets import preset
from plategait.simulation.dataset import dataset_of
from plategait.simulation.run import simulate


def test_the_channels_are_the_core_s_own_in_its_order():
    assert list(CHANNELS) == list(native.CHANNELS)
    assert all(channel.long_name and channel.unit for channel in CHANNELS.values())


def test_every_channel_is_recorded_and_every_series_but_the_time_is_written():
    simulation = simulate(preset("cheese").scenario.replace(duration=0.2))
    assert list(simulation.recordings[0].channels) == list(CHANNELS)
    data = dataset_of(simulation)
    for name in set(SERIES) - {ROTATION.name}:
        assert data[name].attrs == {"long_name": CHANNELS[name].long_name, "units": CHANNELS[name].unit}


def test_amounts_add_up_shares_average_and_states_are_interpolated():
    recording = simulate(preset("cheese").scenario.replace(duration=0.5)).recordings[0]
    time, interval, count = recording["time"], 0.05, 9
    end = (count - 1) * interval
    for name in (name for name, channel in SERIES.items() if channel.kind == "amount"):
        total = np.interp(end, time, np.cumsum(recording[name])) - recording[name][0]
        assert thinned(recording, name, interval, count).sum() == pytest.approx(total, abs=1e-12)
    for name in (name for name, channel in SERIES.items() if channel.kind == "share"):
        touched = np.interp(end, time, np.cumsum(recording[name] * np.diff(time, prepend=0.0)))
        assert thinned(recording, name, interval, count)[1:].mean() == pytest.approx(touched / end, abs=1e-12)
    at = np.arange(count) * interval
    np.testing.assert_array_equal(
        thinned(recording, "plate_x", interval, count), np.interp(at, time, recording["plate_x"])
    )


def test_no_channel_is_refused_with_the_nearest():
    with pytest.raises(InputError, match=r'record\.channels.*"friction_loss"'):
        check_series(["rotation", "friction_los"], "record.channels")
