"""To machines and to other simulators: trajectories as CSV and ROS 2 bags, scenes as MJCF."""
