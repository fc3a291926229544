"""Trajectories as ROS 2 bags: one `trajectory_msgs/JointTrajectory`, without an installation of ROS."""

from __future__ import annotations

import re
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from plategait.errors import InputError, check_kind
from plategait.export.trajectory import Trajectory
from plategait.files.output import check_writable, whole_file

SUFFIXES = (".mcap", ".db3")
TOPIC = "/joint_trajectory_controller/joint_trajectory"
_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_/.-]*")
_TOPIC = re.compile(r"/?[A-Za-z_][A-Za-z0-9_]*(/[A-Za-z_][A-Za-z0-9_]*)*")
_MESSAGE = "trajectory_msgs/msg/JointTrajectory"


def write_bag(
    trajectory: Trajectory,
    path: Path | str,
    *,
    joints: Sequence[str] | None = None,
    topic: str = TOPIC,
    field: str = "output",
) -> None:
    """Write a trajectory as a ROS 2 bag of one file, which `ros2 bag play` reads, with one message at time 0.

    Parameters
    ----------
    trajectory : Trajectory
        From rest to rest.
    path : Path or str
        Of the file: .mcap, or .db3 where ROS has no plug-in for that.
    joints : sequence of str, optional
        Name of the joint for each of `trajectory.axes`; "plate_x", "plate_rx" and so on by default.
    topic : str
        That the message is on.
    field : str
        What errors call the path.

    Raises
    ------
    InputError
        When rosbags is not installed, the trajectory is a cycle, a name is none, or the file cannot be written.
    """
    check_kind(trajectory, Trajectory, "trajectory", "trajectory(scenario.motion)")
    names = check_names(trajectory.axes, joints, topic)
    if trajectory.cycle:
        raise InputError("cycle", "a bag", "left out for a bag: a controller plays a trajectory once", "a .csv file")
    check_bag(path, field)
    from rosbags.rosbag2 import StoragePlugin, Writer  # pyright: ignore[reportMissingImports]
    from rosbags.typesys import Stores, get_typestore  # pyright: ignore[reportMissingImports]

    store = get_typestore(Stores.ROS2_HUMBLE)
    content = store.serialize_cdr(_message(trajectory, names, store.types), _MESSAGE)
    plugin = StoragePlugin.MCAP if Path(path).suffix.lower() == ".mcap" else StoragePlugin.SQLITE3
    with whole_file(path, SUFFIXES, field) as temporary, tempfile.TemporaryDirectory(dir=temporary.parent) as room:
        folder = Path(room) / "bag"
        with Writer(folder, version=8, storage_plugin=plugin) as writer:
            writer.write(writer.add_connection(topic, _MESSAGE, typestore=store), 0, content)
        # The folder's other file repeats what this one tells of itself.
        next(folder.glob(f"*{temporary.suffix.lower()}")).replace(temporary)


def check_bag(path: Path | str, field: str = "output") -> None:
    """Refuse a bag that cannot be written.

    Raises
    ------
    InputError
        When rosbags is not installed, or the file cannot be written.
    """
    try:
        import rosbags.rosbag2  # noqa: F401  # pyright: ignore[reportMissingImports]
    except ImportError:
        raise InputError(field, "nothing that writes bags", "installed", 'pip install "plategait[ros]"') from None
    check_writable(path, SUFFIXES, field)


def check_names(axes: Sequence[str], joints: Sequence[str] | None, topic: str) -> tuple[str, ...]:
    """Names of the joints, one for each axis.

    Raises
    ------
    InputError
        When there are more or fewer, or one of them or the topic is no name in ROS.
    """
    names = tuple(f"plate_{axis}" for axis in axes) if joints is None else tuple(joints)
    example = ",".join(f"plate_{axis}" for axis in axes)
    if len(names) != len(axes) or len(set(names)) < len(names) or not all(map(_NAME.fullmatch, names)):
        raise InputError("joints", ",".join(names), f"a different name for each of {', '.join(axes)}", example)
    if not _TOPIC.fullmatch(topic):
        raise InputError("topic", topic, "words of letters, digits and _, parted by /", TOPIC)
    return names


def _message(trajectory: Trajectory, names: tuple[str, ...], types: Any) -> Any:
    """The trajectory as one message, of the classes that rosbags makes of ROS 2's definitions."""
    time, duration = types["builtin_interfaces/msg/Time"], types["builtin_interfaces/msg/Duration"]
    point = types["trajectory_msgs/msg/JointTrajectoryPoint"]
    stamps = np.round(1e9 * trajectory.time).astype(np.int64)
    moves = np.ascontiguousarray(np.stack([trajectory.of(axis) for axis in trajectory.axes], axis=2))
    points = [
        point(positions=moves[0, i], velocities=moves[1, i], accelerations=moves[2, i], effort=np.array([]),
              time_from_start=duration(sec=stamp // 10**9, nanosec=stamp % 10**9))
        for i, stamp in enumerate(stamps.tolist())
    ]  # fmt: skip
    header = types["std_msgs/msg/Header"](stamp=time(sec=0, nanosec=0), frame_id="")
    return types[_MESSAGE](header=header, joint_names=list(names), points=points)
