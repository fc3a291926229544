"""Synthetic films against their own truth: what a frame shows is where the truth says, through real files too."""

from __future__ import annotations

import csv
import math

import av
import cv2
import numpy as np
import pytest

from plategait.camera.writer import schedule
from plategait.errors import InputError
from plategait.model.motion import rotation_of
from plategait.model.outline import Polygon
from plategait.model.presets import preset
from plategait.render.clip.appearance import Appearance
from plategait.render.clip.clip import SyntheticCamera, film, occlusions, truth_path, usual_camera
from plategait.render.snapshots import Snapshots
from plategait.simulation.run import simulate

# The dissertation's pancake bends most; 20 deg is between its Figs. 2.8 and 2.9.
SCENARIO = preset("pancake").scenario.replace(**{"duration": 0.8, "motion.angle": math.radians(20)})
SIZE = (640, 360)
CLEAR = Appearance(noise=0, exposure=0, defocus=0, texture=0, glare=0, gradient=0, shadow=0)
FPS = 30.0


@pytest.fixture(scope="module")
def simulation():
    return simulate(SCENARIO, snapshot_interval=SCENARIO.motion.period / 24)


@pytest.fixture(scope="module")
def clip(simulation, tmp_path_factory):
    """A film with an ordinary appearance, and its truth."""
    path = tmp_path_factory.mktemp("film") / "clip.mp4"
    return path, film(simulation, path, usual_camera(SCENARIO, *SIZE), FPS, Appearance(seed=1), seconds=0.4)


def synthetic_camera(simulation, appearance=CLEAR, **options) -> SyntheticCamera:
    scenario = simulation.scenario
    camera = usual_camera(scenario, *SIZE, **options)
    return SyntheticCamera(
        scenario, Snapshots.of(scenario, simulation.recordings[0], 0), camera, appearance, appearance.exposure / FPS
    )


def frames_of(path) -> list[np.ndarray]:
    with av.open(str(path)) as container:
        return [frame.to_ndarray(format="bgr24") for frame in container.decode(video=0)]


def blue_spots(picture: np.ndarray) -> list[np.ndarray]:
    """Middles of the two markers, the larger first, weighted by how blue a pixel is."""
    blue, _, red = (plane.astype(float) for plane in cv2.split(picture))
    # Markers have some 90 levels more blue than red, plate and background less than 25.
    bluer = np.maximum(blue - red - 30, 0)
    count, labels = cv2.connectedComponents((bluer > 0).astype(np.uint8))
    rows, columns = np.indices(bluer.shape)
    weights = sorted((bluer * (labels == k) for k in range(1, count)), key=lambda weight: -weight.sum())
    return [np.array([(columns * w).sum(), (rows * w).sum()]) / w.sum() for w in weights[:2]]


@pytest.mark.parametrize("distortion", [(), (-0.2, 0.05)])
def test_markers_are_seen_where_the_truth_says(distortion):
    # A stiff object: the middle of a marker that is bent is not the middle of its picture.
    scenario = preset("rigid-twin").scenario.replace(duration=0.6)
    simulation = simulate(scenario, snapshot_interval=scenario.motion.period / 24)
    filming = synthetic_camera(simulation, distortion=distortion)
    for time in (0.31, 0.42, 0.5):
        picture, share = filming.picture(time, [])
        middles, _ = filming.markers(*filming.snapshots.at(time))
        np.testing.assert_allclose(share, 1, atol=0.1)
        for spot, truth in zip(blue_spots(picture), filming.camera.project(middles), strict=True):
            # Markers are some 24 px by 10 px, made of 4 samples a pixel; perspective moves the middle by 0.1 px.
            assert np.abs(spot - truth).max() < 0.3


def test_corner_markers_are_detected_where_plate_and_camera_put_them(simulation):
    filming = synthetic_camera(simulation)
    time = 0.45
    picture, _ = filming.picture(time, [])
    _, pose = filming.snapshots.at(time)
    rotation, middle = filming.scene.plate_frame(pose)
    # Off its level by a good part of its 20 deg.
    assert abs(pose[3]) > math.radians(8)
    parameters = cv2.aruco.DetectorParameters()
    parameters.cornerRefinementMethod = cv2.aruco.CORNER_REFINE_SUBPIX
    dictionary = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50)
    corners, numbers, _ = cv2.aruco.ArucoDetector(dictionary, parameters).detectMarkers(picture)
    assert sorted(numbers.ravel()) == [0, 1, 2, 3]
    for number, detected in zip(numbers.ravel(), corners, strict=True):
        flat = filming.scene.target.corners[number]
        world = np.column_stack([flat, np.zeros(4)]) @ rotation.T + middle
        # The detector's own corner refinement is good to a few tenths of a pixel on markers of 40 px.
        assert np.abs(detected.reshape(4, 2) - filming.camera.project(world)).max() < 0.6


def test_the_files_frames_show_what_the_truth_says(clip):
    path, truth = clip
    frames = frames_of(path)
    assert len(frames) == len(truth.time) == 12
    visible = (truth.marker_share > 0.8).all(axis=1)
    assert visible.sum() >= 6
    errors = np.array([np.subtract(blue_spots(frames[k]), truth.marker_pixels[k]) for k in np.nonzero(visible)[0]])
    # Colour is stored at half the resolution, and moving markers are smeared over a few px along a curve.
    assert np.sqrt((errors**2).mean()) < 0.6


def test_the_truth_turns_as_the_simulation_does(simulation, clip):
    _, truth = clip
    samples = simulation.recordings[0].channels["time"]
    turned = np.unwrap(np.arctan2(*(simulation.recordings[0].channels[f"spin_{c}"] for c in ("cross", "dot"))))
    # Shapes between snapshots are straight lines: a hundredth of a swing of some 10 deg.
    np.testing.assert_allclose(
        truth.angle, np.interp(truth.started + truth.time, samples, turned), atol=math.radians(0.3)
    )
    assert np.abs(truth.marker_angle - truth.angle).max() < math.radians(20)
    for mine, name in ((truth.x, "centre_x"), (truth.y, "centre_y")):
        simulated = np.interp(truth.started + truth.time, samples, simulation.recordings[0].channels[name])
        # The same straight lines, of a swing of 10 mm.
        np.testing.assert_allclose(mine, simulated, atol=3e-4)


def test_the_picture_turns_the_same_way_as_the_object(simulation):
    # From straight above there is no perspective to speak of: the line of markers is the angle, counter-clockwise.
    filming = synthetic_camera(simulation, elevation=math.pi / 2, azimuth=0.0)
    time = 0.4
    spots = blue_spots(filming.picture(time, [])[0])
    nodes, pose = filming.snapshots.at(time)
    across = spots[1] - spots[0]
    # This camera has the bar's x downwards in the picture, and so y to the right.
    pictured = math.atan2(across[0], across[1])
    _, direction = filming.markers(nodes, pose)
    # The plate is tilted by up to 20 deg, which shortens y by 6 % and turns a diagonal by 1.7 deg.
    assert abs(math.remainder(pictured - direction, math.tau)) < math.radians(4)


def test_the_truth_is_written_beside_the_film(clip):
    path, truth = clip
    with open(truth_path(path), newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    np.testing.assert_allclose([float(r["time_s"]) for r in rows], truth.time, atol=1e-6)
    np.testing.assert_allclose([float(r["angle_deg"]) for r in rows], np.degrees(truth.angle), rtol=1e-6)
    np.testing.assert_allclose([float(r["plate_rx_deg"]) for r in rows], np.degrees(truth.plate_pose[:, 3]), atol=1e-5)
    assert sorted(p.name for p in path.parent.iterdir()) == ["clip.mp4", "clip.truth.csv"]


def test_what_covers_a_marker_hides_it_and_says_so(simulation):
    filming = synthetic_camera(simulation)
    _, bare = filming.picture(0.4, [])
    picture, share = filming.picture(0.4, [(1, 0.0, 0.0)])
    # The disk is wider than the rim marker; seen from the side it uncovers a little of it at most.
    assert bare[1] > 0.7
    assert share[1] < 0.25
    assert share[0] == pytest.approx(bare[0], abs=0.05)
    assert len(blue_spots(picture)) <= 2


def test_markers_turned_away_from_the_camera_are_not_seen(simulation):
    filming = synthetic_camera(simulation)
    nodes, pose = filming.snapshots.at(0.4)
    # Stand the object on edge, its upper side away from the camera.
    turned = nodes @ rotation_of(np.array([0, 0, 0, 0, -math.radians(100), 0.0])).T
    mesh = filming.scene.lit_mesh(turned, pose, np.ones(len(filming.scene.grid)), [])
    assert (filming.visible_share(filming.rasteriser.rasterise(mesh), turned, pose) == 0).all()


@pytest.mark.parametrize("share", [0.1, 0.4, 0.8])
def test_markers_are_covered_for_the_share_of_frames_asked_for(share):
    covered = [bool(occluders) for occluders in occlusions(20_000, share, seed=3)]
    # Runs of 4 frames: some 2000 independent ones, so that a standard deviation is 0.01.
    assert np.mean(covered) == pytest.approx(share, abs=0.04)
    assert not any(occlusions(100, 0.0, seed=3))


def test_exposure_smears_what_moves(simulation):
    sharp, _ = synthetic_camera(simulation).picture(0.45, [])
    smeared, _ = synthetic_camera(simulation, Appearance(**{**CLEAR.__dict__, "exposure": 0.8})).picture(0.45, [])
    detail = [cv2.Laplacian(cv2.cvtColor(p, cv2.COLOR_BGR2GRAY), cv2.CV_64F).var() for p in (sharp, smeared)]
    assert detail[1] < 0.6 * detail[0]


def test_noise_has_the_strength_asked_for(simulation):
    clear, _ = synthetic_camera(simulation).picture(0.4, [])
    noisy, _ = synthetic_camera(simulation, Appearance(**{**CLEAR.__dict__, "noise": 6.0})).picture(0.4, [])
    differs = noisy.astype(float) - clear
    # A corner of the background, which neither black nor white cuts off: 10 000 values, 0.7 % each.
    assert differs[:60, :60].std() == pytest.approx(6.0, rel=0.03)


def test_times_are_true_where_frames_are_missing_repeated_and_late(simulation, tmp_path):
    appearance = Appearance(drop=0.25, duplicate=0.3, jitter=0.2, noise=0, seed=4)
    truth = film(simulation, tmp_path / "poor.mp4", usual_camera(SCENARIO, *SIZE), FPS, appearance, seconds=0.5)
    with av.open(str(tmp_path / "poor.mp4")) as container:
        frames = list(container.decode(video=0))
        times = [frame.time for frame in frames]
        pictures = [frame.to_ndarray(format="gray").astype(int) for frame in frames]
    np.testing.assert_allclose(times, truth.time, atol=1e-5)
    assert truth.duplicate.any()
    assert len(truth.time) < 15
    changed = np.array([np.abs(a - b).mean() for a, b in zip(pictures[1:], pictures[:-1], strict=True)])
    # What repeats differs by the codec's second thoughts only.
    assert changed[truth.duplicate[1:]].max() < 0.5 * changed[~truth.duplicate[1:]].min()


def test_the_schedule_drops_and_repeats_as_often_as_asked():
    times = schedule(400, 30, drop=0.2, duplicate=0.1, jitter=0.1, seed=2)
    # 12 000 frames: standard deviations of 0.4 % and 0.3 %.
    assert len(times.time) == pytest.approx(0.8 * 12_000, rel=0.02)
    assert times.duplicate.mean() == pytest.approx(0.1, abs=0.012)
    assert (np.diff(times.time) > 0).all()
    assert schedule(1, 30).time[-1] == pytest.approx(29 / 30, abs=1e-5)


def test_the_same_seed_gives_the_same_film(simulation, tmp_path):
    for name in ("a", "b"):
        film(
            simulation,
            tmp_path / f"{name}.mkv",
            usual_camera(SCENARIO, 320, 180),
            FPS,
            Appearance(hidden=0.3),
            seconds=0.1,
        )
    assert (tmp_path / "a.truth.csv").read_bytes() == (tmp_path / "b.truth.csv").read_bytes()
    for a, b in zip(frames_of(tmp_path / "a.mkv"), frames_of(tmp_path / "b.mkv"), strict=True):
        np.testing.assert_array_equal(a, b)


def test_without_marks_there_are_none(simulation):
    bare, share = synthetic_camera(
        simulation, Appearance(**{**CLEAR.__dict__, "markers": False, "fiducials": False})
    ).picture(0.4, [])
    assert blue_spots(bare) == []
    assert (share == 0).all()
    dictionary = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50)
    assert cv2.aruco.ArucoDetector(dictionary).detectMarkers(bare)[1] is None


@pytest.mark.parametrize(
    ("field", "change"),
    [("noise", -1.0), ("exposure", 1.5), ("crf", 99), ("drop", math.nan), ("object_colour", (1, 2, 300))],
)
def test_an_appearance_that_cannot_be_is_refused(field, change):
    with pytest.raises(InputError, match=f"appearance.{field}"):
        Appearance(**{field: change})


def test_a_film_that_cannot_be_made_leaves_no_file(simulation, tmp_path):
    path = tmp_path / "clip.mp4"
    without = simulate(SCENARIO.replace(duration=0.1, transient=0.0))
    for refused, arguments in (
        ("seconds", {"seconds": 5.0}),
        ("seconds", {"start": 2.0}),
        ("fps", {"fps": 0.0}),
        ("camera", {"camera": usual_camera(SCENARIO, 321, 181)}),
    ):
        with pytest.raises(InputError, match=refused):
            film(simulation, path, **arguments)
    with pytest.raises(InputError, match="recording"):
        film(without, path)
    with pytest.raises(InputError, match="output"):
        film(simulation, tmp_path / "clip.avi")
    assert not list(tmp_path.iterdir())


def test_an_object_of_any_shape_carries_its_markers_from_its_centre_of_mass(simulation):
    corners = (("0 mm", "0 mm"), ("90 mm", "0 mm"), ("0 mm", "90 mm"))
    scenario = SCENARIO.replace(**{"sheet.outline": Polygon(corners=corners), "sheet.pitch": 0.005, "duration": 0.2})
    shaken = simulate(scenario, snapshot_interval=scenario.motion.period / 24)
    filming = synthetic_camera(shaken)
    picture, share = filming.picture(0.0, [])
    # At the start it lies flat; a marker of 60 square px is counted to a few of them.
    np.testing.assert_allclose(share, 1, atol=0.1)
    nodes, pose = filming.snapshots.at(0.0)
    centre = blue_spots(picture)[0]
    # The lattice's steps along the hypotenuse hold its centre where the triangle's is to a mm, about 2 px.
    assert np.abs(centre - filming.camera.project(nodes.mean(axis=0))).max() < 2.5
    assert filming.scene.sheet_frame(nodes, pose)[0] == pytest.approx(0, abs=1e-3)


def test_glare_makes_the_plate_white_somewhere(simulation):
    level = 3 / SCENARIO.motion.frequency
    plain, shiny = (
        synthetic_camera(simulation, Appearance(**{**CLEAR.__dict__, "glare": glare})).picture(level, [])[0]
        for glare in (0.0, 1.0)
    )
    # The background, two thirds of the picture, is darker; the shine is a patch of some 30 mm on a plate of 126 mm.
    assert (plain.min(axis=2) > 250).mean() == 0
    assert 0.005 < (shiny.min(axis=2) > 250).mean() < 0.3
