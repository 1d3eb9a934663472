# shellcheck shell=bash
# Sourced by the other scripts: the system's python before any other (catkin, roslaunch and rostest want its modules),
# and ROS where it is not part of the system.
export PATH=/usr/bin:$PATH
if [[ -e /opt/ros/noetic/setup.bash ]]; then
  set +u
  source /opt/ros/noetic/setup.bash
  set -u
fi
