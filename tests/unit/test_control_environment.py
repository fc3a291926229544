"""The environments: Gymnasium's checks, and lanes of the vectorised one that are single ones, bit for bit."""

from __future__ import annotations

import importlib.util
import math
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from gymnasium.vector import AutoresetMode
from gymnasium.vector.utils import iterate

import plategait as pg
from plategait.control.environment import ID, PoseEnv
from plategait.control.options import PoseOptions, Variation
from plategait.control.task import DONE, LOST, PER_SECOND, SEEN
from plategait.control.vector import PoseVectorEnv

CHEESE = pg.preset("cheese").scenario
STRIP = CHEESE.replace(**{"sheet.outline": pg.Rectangle(length=0.05, width=0.03), "sheet.mass": 4e-3})
MENU = (
    CHEESE.motion.replace(angle=0, stroke=0),
    CHEESE.motion.replace(frequency=18, ramp="50 ms"),
    CHEESE.motion.replace(frequency=12, angle="-8 deg", offset={"rx": "2 deg"}),
    CHEESE.motion.replace(frequency=30.0, angle=0.4, ramp="15 ms"),  # which throws the sheet over
)
VARIED = {"stiffness": (0.5, 2), "friction": (0.7, 1.2), "mass": (0.8, 1.5), "height": ("0 mm", "8 mm")}


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("options", [{}, {"actions": MENU, "variation": VARIED}], ids=["drive", "menu"])
def test_gymnasium_finds_nothing_wrong(options: dict[str, Any]):
    env = gymnasium.make(ID, render_mode="rgb_array", **options)
    check_env(env.unwrapped)
    assert env.unwrapped.metadata["render_fps"] == 60


DRIVEN = {"variation": VARIED, "time_limit": 0.25, "hold": 0.1, "camera": {"rate": "50 Hz"}, "ramp": 0.02}
CHOSEN = {"actions": MENU, "time_limit": 0.4, "hold": 0.1}


def same(observation: np.ndarray, infos: dict[str, Any], lane: int, own: tuple[np.ndarray, dict[str, Any]]) -> None:
    np.testing.assert_array_equal(observation[lane], own[0])
    for name, value in own[1].items():
        np.testing.assert_array_equal(infos[name][lane], value)
        assert infos[f"_{name}"][lane]


@pytest.mark.parametrize("mode", list(AutoresetMode))
@pytest.mark.parametrize("options", [DRIVEN, CHOSEN], ids=["drive", "menu"])
def test_lanes_are_single_environments_bit_for_bit(mode: AutoresetMode, options: dict[str, Any]):
    """What Gymnasium has no checker for: lanes against single environments, whatever befalls them."""
    objects = [CHEESE, STRIP, CHEESE]
    vector = PoseVectorEnv(3, objects=objects[:2], autoreset_mode=mode, **options)
    singles = [PoseEnv(objects=each, **options) for each in objects]
    vector.action_space.seed(3)
    observation, infos = vector.reset(seed=11)
    for lane, env in enumerate(singles):
        same(observation, infos, lane, env.reset(seed=11 + lane))
    over, ended = np.zeros(3, dtype=bool), 0
    for _ in range(45):
        if mode is AutoresetMode.DISABLED and over.any():
            observation, infos = vector.reset(options={"reset_mask": over})
            assert infos["_pose"].tolist() == over.tolist()
            for lane in np.flatnonzero(over):
                same(observation, infos, lane, singles[lane].reset())
        actions = vector.action_space.sample()
        observation, *results, infos = vector.step(actions)
        before, over = over, np.zeros(3, dtype=bool)
        for lane, (env, action) in enumerate(zip(singles, iterate(vector.action_space, actions), strict=True)):
            result = tuple(values[lane] for values in results)
            if mode is AutoresetMode.NEXT_STEP and before[lane]:
                assert result == (0.0, False, False)
                same(observation, infos, lane, env.reset())
                continue
            own, *own_result, info = env.step(action)
            assert result == tuple(own_result)
            over[lane] = own_result[1] or own_result[2]
            if mode is AutoresetMode.SAME_STEP and over[lane]:
                assert infos["_final_obs"][lane]
                same(infos["final_obs"], infos["final_info"], lane, (own, info))
                own, info = env.reset()
            same(observation, infos, lane, (own, info))
        ended += over.sum()
    assert ended >= 3, "episodes that were over"


def alike(ours: dict[str, Any], theirs: dict[str, Any]) -> None:
    assert set(ours) == set(theirs)
    for name, value in ours.items():
        if isinstance(value, dict):
            alike(value, theirs[name])
        else:
            assert value.dtype == theirs[name].dtype
            assert all(np.array_equal(a, b) for a, b in zip(value, theirs[name], strict=True))


@pytest.mark.parametrize("mode", [AutoresetMode.NEXT_STEP, AutoresetMode.SAME_STEP])
def test_what_is_told_has_the_form_of_gymnasium_s_own(mode: AutoresetMode):
    ours = gymnasium.make_vec(ID, num_envs=2, autoreset_mode=mode, **CHOSEN)
    theirs = gymnasium.make_vec(
        ID, num_envs=2, vectorization_mode="sync", vector_kwargs={"autoreset_mode": mode}, **CHOSEN
    )
    ours.action_space.seed(1)
    told, own = ours.reset(seed=5), theirs.reset(seed=5)
    np.testing.assert_array_equal(told[0], own[0])
    alike(told[1], own[1])
    for _ in range(30):
        actions = ours.action_space.sample()
        *told, infos = ours.step(actions)
        *own, own_infos = theirs.step(actions)
        for value, other in zip(told, own, strict=True):
            assert value.dtype == other.dtype
            np.testing.assert_array_equal(value, other)
        alike(infos, own_infos)


def test_an_episode_that_is_over_waits_where_none_follows_by_itself():
    vector = PoseVectorEnv(2, actions=MENU, time_limit=0.2, hold=0.1, autoreset_mode=AutoresetMode.DISABLED)
    vector.reset(seed=0)
    for _ in range(12):
        *_, truncated, _ = vector.step(np.array([0, 0]))
    assert truncated.all()
    with pytest.raises(gymnasium.error.ResetNeeded, match="lanes"):
        vector.step(np.array([0, 0]))
    vector.reset(options={"reset_mask": np.array([True, True])})
    assert not vector.step(np.array([0, 0]))[3].any()


def test_make_vec_takes_the_native_one_and_declares_how_episodes_follow():
    for mode in AutoresetMode:
        vector = gymnasium.make_vec(ID, num_envs=2, autoreset_mode=mode.value)
        assert isinstance(vector, PoseVectorEnv)
        assert vector.metadata["autoreset_mode"] is mode
    assert vector.observation_space.shape == (2, len(SEEN) + 5)
    with pytest.raises(gymnasium.error.ResetNeeded):
        vector.step(vector.action_space.sample())


def test_what_is_seen_is_the_way_to_the_goal():
    env = PoseEnv(camera={"position_noise": 0, "angle_noise": 0, "missed": 0, "delay": 0})
    told = {"start": (0.01, -0.02, math.radians(170)), "goal": (-0.03, 0.01, math.radians(-170))}
    observation, info = env.reset(options=told)
    turn, angle = math.radians(20), math.radians(170)
    expected = [-0.4, 0.3, math.cos(turn), math.sin(turn), 0.1, -0.2, math.cos(angle), math.sin(angle), 0, 1]
    np.testing.assert_allclose(observation[:10], expected, atol=1e-6)
    np.testing.assert_allclose(info["goal"], told["goal"])
    observation, *_ = env.step(np.array([0.1, 0.0, -1.0, 0.2, 0.0], dtype=np.float32))
    np.testing.assert_allclose(observation[10:], [0.1, 0, -1, 0.2, 0], atol=1e-6)
    late = PoseEnv(camera={"delay": "0.1 s"})
    assert late.reset(seed=0)[0][:10].tolist() == [0.0] * 10, "nothing has arrived"


def test_rewards_add_up_to_what_was_gained():
    rest = {"start": (0.0, 0.0, 0.0), "goal": (0.0, 0.002, 0.0)}
    env = PoseEnv(actions=MENU, hold=0.2, time_limit=1)
    env.reset(options=rest)
    rewards = []
    for _ in range(100):
        _, reward, terminated, truncated, info = env.step(np.int64(0))
        rewards.append(reward)
        if terminated or truncated:
            break
    assert (terminated, truncated, info["reached"], len(rewards)) == (True, False, True, 12)
    assert sum(rewards) == pytest.approx(12 / 60 * PER_SECOND + DONE, abs=1e-3)
    env.reset(options={"start": (0.0, 0.0, 0.0), "goal": (0.03, 0.0, math.pi)})
    before, total = 0.03 / 0.01 + math.pi / math.radians(20), 0.0
    for _ in range(60):
        _, reward, terminated, truncated, info = env.step(np.int64(3))
        total += reward
        if terminated or truncated:
            break
    assert info["status"] != ""
    assert not info["reached"]
    error = env.task.error[0]
    after = np.hypot(*error[:2]) / 0.01 + abs(error[2]) / math.radians(20)
    assert total == pytest.approx(before - after + LOST)
    env.reset(options={"start": (0.0, 0.0, 0.0), "goal": (0.03, 0.0, math.pi)})
    ends = [env.step(np.int64(0))[2:4] for _ in range(60)]
    assert ends[-1] == (False, True)
    assert not any(map(any, ends[:-1]))


def test_what_varies_differs_from_episode_to_episode_and_goes_by_the_seed():
    env = PoseEnv(variation=VARIED)
    scenarios = []
    for seed in (1, None, 1):
        env.reset(seed=seed)
        scenarios.append(env.task.plant.session.scenarios[0])
    assert scenarios[0] == scenarios[2]
    first, second = scenarios[:2]
    for read in (lambda s: s.sheet.bending_stiffness, lambda s: s.friction.static, lambda s: s.sheet.mass,
                 lambda s: s.motion.height, lambda s: s.start.x):  # fmt: skip
        assert read(first) != read(second)
    assert 0.5 <= first.sheet.bending_stiffness / CHEESE.sheet.bending_stiffness <= 2
    assert first.sheet.bending_stiffness / CHEESE.sheet.bending_stiffness != first.sheet.mass / CHEESE.sheet.mass
    assert first.friction.ratio == pytest.approx(CHEESE.friction.ratio)
    assert first.replace() == first, "as valid as any"


def test_starts_and_goals_lie_within_reach():
    vector = PoseVectorEnv(64, reach=("5 mm", "30 mm"))
    _, infos = vector.reset(seed=0)
    for poses in (infos["pose"], infos["goal"]):
        farthest = np.abs(poses).max(axis=0)
        assert (farthest <= [0.005, 0.03, math.pi]).all()
        assert (farthest >= [0.0045, 0.027, 2.9]).all()  # 64 draws: beyond nine tenths but for a chance of 0.1 %
    assert PoseOptions(reach="20 mm").reach == (0.02, 0.02)


def test_pictures_show_the_goal_and_the_sheet():
    vector = PoseVectorEnv(2, objects=[CHEESE, STRIP], render_mode="rgb_array", size=(320, 240))
    vector.reset(seed=1)
    first = vector.render()
    assert first is not None
    assert [(picture.shape, picture.dtype) for picture in first] == [((240, 320, 3), np.uint8)] * 2
    red = [((p[..., 0] > 150) & (p[..., 1] < 120) & (p[..., 2] < 120)).sum() for p in first]
    assert min(red) > 30
    vector.step(vector.action_space.sample())
    vector.reset(seed=5)
    later = vector.render()
    assert later is not None
    assert (first[0] != later[0]).any()


def test_what_environments_refuse():
    env = PoseEnv()
    env.reset(seed=0)
    vector = PoseVectorEnv(2)
    timed = CHEESE.replace(time_step=1e-4)
    for call, field in (
        (lambda: PoseEnv(objects=[CHEESE, STRIP]), "objects"),
        (lambda: PoseEnv(obejcts="cheese"), "obejcts"),
        (lambda: PoseEnv(actions=MENU, free=["angle"]), "free"),
        (lambda: PoseEnv(actions=()), "actions"),
        (lambda: PoseEnv(actions=(MENU[0].replace(ramp=0),)), "actions"),
        (lambda: PoseEnv(hold="30 s"), "hold"),
        (lambda: PoseEnv(render_mode="human"), "render_mode"),
        (lambda: PoseEnv(camera={"delay": "-1 s"}), "camera.delay"),
        (lambda: PoseEnv(variation={"mass": (2, 1)}), "variation.mass"),
        (lambda: PoseEnv(free=["yaw"]), "free"),
        (lambda: PoseOptions(objects=[timed], variation=Variation(mass=(0.001, 1))), "time_step"),
        (lambda: env.reset(options={"gaol": (0, 0, 0)}), "options.gaol"),
        (lambda: env.reset(options={"goal": (0, 0)}), "options.goal"),
        (lambda: env.step(np.zeros(3, dtype=np.float32)), "actions"),
        (lambda: PoseVectorEnv(0), "num_envs"),
        (lambda: PoseVectorEnv(2, autoreset_mode="now"), "autoreset_mode"),
        (lambda: vector.reset(seed=[1]), "seed"),
        (lambda: vector.reset(options={"reset_mask": np.zeros(2, dtype=bool)}), "options.reset_mask"),
    ):
        with pytest.raises(pg.InputError, match=rf"^{field}"):
            call()


@pytest.mark.skipif(importlib.util.find_spec("stable_baselines3") is None, reason="Stable-Baselines3 is not installed")
def test_stable_baselines_has_the_same_lanes():
    from stable_baselines3 import PPO

    from plategait.control.baselines import PoseVecEnv

    ours, theirs = (
        PoseVectorEnv(2, actions=MENU, time_limit=0.2, hold=0.1, autoreset_mode="SameStep"),
        PoseVecEnv(2, actions=MENU, time_limit=0.2, hold=0.1),
    )
    theirs.seed(4)
    np.testing.assert_array_equal(ours.reset(seed=4)[0], theirs.reset())
    for _ in range(15):
        actions = ours.action_space.sample()
        observation, reward, terminated, truncated, infos = ours.step(actions)
        own = theirs.step(actions)
        np.testing.assert_array_equal(observation, own[0])
        np.testing.assert_allclose(reward, own[1], rtol=1e-6)
        np.testing.assert_array_equal(terminated | truncated, own[2])
        for lane in np.flatnonzero(own[2]):
            np.testing.assert_array_equal(own[3][lane]["terminal_observation"], infos["final_obs"][lane])
            assert own[3][lane]["TimeLimit.truncated"] == (truncated[lane] and not terminated[lane])
    PPO("MlpPolicy", theirs, n_steps=8, batch_size=16, n_epochs=1, device="cpu").learn(16)
