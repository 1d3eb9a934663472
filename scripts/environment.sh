# shellcheck shell=bash
# Sourced by the other scripts: the system's python before any other (catkin, roslaunch and rostest want its modules),
# and ROS where it is not part of the system.
export PATH=/usr/bin:$PATH
if [[ -e /opt/ros/noetic/setup.bash ]]; then
  set +u
  source /opt/ros/noetic/setup.bash
  set -u
fi

# Nothing of a robot that runs is touched: the demo has a master of its own, so has each rostest.
unset ROS_IP ROS_NAMESPACE
export ROS_HOSTNAME=localhost ROS_MASTER_URI=http://localhost:11411
