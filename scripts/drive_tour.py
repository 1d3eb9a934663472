#!/usr/bin/python3
"""Sends the robot to one goal after the other and prints, for each, how long it was planned to take, how long it took, and
how well the trajectory was tracked. Exits with 1 when a goal is not reached.

  drive_tour.py X,Y,YAW...      in the frame `map` [m], [deg]
"""
import math
import statistics
import sys
import threading
import time

import rosgraph
import rospy
from geometry_msgs.msg import PoseStamped
from std_srvs.srv import Trigger

from fourwis_navigation.msg import ModeTrajectory, PlannerStatus, Tracking, TrajectoryPoint

MODES = {TrajectoryPoint.ACKERMANN: 'ackermann', TrajectoryPoint.LATERAL: 'lateral',
         TrajectoryPoint.PARALLEL: 'parallel'}
HEADER = ('goal', 'modes', 'planned', 'driven', 'lateral mean/max', 'longitudinal', 'at the goal')
ENABLE_ATTEMPTS = 30
ROW = '{:<22} {:<28} {:>8} {:>8}  {:>16}  {:>13}  {:>14}'


def yaw_of(quaternion):
    return 2.0 * math.atan2(quaternion.z, quaternion.w)


def millimetres(errors):
    sizes = [abs(error) * 1e3 for error in errors] or [0.0]
    return f'{statistics.mean(sizes):.1f}/{max(sizes):.1f} mm'


class Drive:
    """One goal, from being sent to the robot's being at rest."""

    def __init__(self, goal):
        self.goal = goal
        self.trajectory = None
        self.steps = []
        self.failure = None
        self.done = threading.Event()

    def on_trajectory(self, trajectory):
        if trajectory.points:
            self.trajectory = trajectory

    def on_status(self, status):
        """The planner decides: what the controller gives up it plans anew."""
        if status.goal.header.stamp != self.goal.header.stamp:
            return
        if status.state == PlannerStatus.FAILED:
            self.failure = f'{status.status}: {status.message}'
        if status.state in (PlannerStatus.FAILED, PlannerStatus.ARRIVED):
            self.done.set()

    def on_tracking(self, step):
        if self.trajectory is not None and step.trajectory == self.trajectory.header.stamp:
            self.steps.append(step)

    def modes(self):
        return ' '.join(dict.fromkeys(MODES[point.mode] for point in self.trajectory.points))

    def row(self, pose):
        x, y, yaw = self.goal.pose.position.x, self.goal.pose.position.y, yaw_of(self.goal.pose.orientation)
        name = f'{x:.2f} {y:.2f} {math.degrees(yaw):.0f} deg'
        if self.failure:
            return f'{name:<22} {self.failure}'
        driving = [step for step in self.steps if step.state == Tracking.DRIVING]
        elapsed = (self.steps[-1].header.stamp - self.steps[0].header.stamp).to_sec()
        away = math.hypot(pose.position.x - x, pose.position.y - y)
        turned = abs(math.remainder(yaw_of(pose.orientation) - yaw, 2.0 * math.pi))
        return ROW.format(name, self.modes(), f'{self.trajectory.points[-1].t:.1f} s', f'{elapsed:.1f} s',
                          millimetres([step.lateral_error for step in driving]),
                          millimetres([step.longitudinal_error for step in driving]),
                          f'{away * 1e3:.1f} mm {math.degrees(turned):.2f}')


class Tour:
    """Collects what planner, controller and base report of one drive after the other."""

    def __init__(self):
        self.drive = None
        self.pose = None
        self.goals = rospy.Publisher('move_base_simple/goal', PoseStamped, queue_size=1)
        rospy.Subscriber('trajectory', ModeTrajectory, lambda message: self.drive and self.drive.on_trajectory(message))
        rospy.Subscriber('move_base/planner_status', PlannerStatus,
                         lambda message: self.drive and self.drive.on_status(message))
        rospy.Subscriber('mpc_controller/tracking', Tracking,
                         lambda message: self.drive and self.drive.on_tracking(message))
        rospy.Subscriber('base_simulator/pose', PoseStamped, self.on_pose)

    def on_pose(self, message):
        self.pose = message.pose

    def go(self, goal):
        """Sends the robot there and prints the drive's row; whether it got there."""
        self.drive = Drive(goal)
        self.goals.publish(goal)
        while not self.drive.done.wait(0.2):
            if rospy.is_shutdown():
                return False
        print(self.drive.row(self.pose), flush=True)
        return self.drive.failure is None


def goal_at(text):
    x, y, degrees = (float(number) for number in text.split(','))
    goal = PoseStamped()
    goal.header.frame_id = 'map'
    goal.header.stamp = rospy.Time.now()
    goal.pose.position.x, goal.pose.position.y = x, y
    goal.pose.orientation.z = math.sin(math.radians(degrees) / 2.0)
    goal.pose.orientation.w = math.cos(math.radians(degrees) / 2.0)
    return goal


def wait_for_controller():
    """Before rospy begins: whose clock it takes is known once the nodes run."""
    master = rosgraph.Master('/drive_tour')
    while not (master.is_online() and any(topic.endswith('mpc_controller/tracking')
                                          for topic, _ in master.getPublishedTopics('/'))):
        time.sleep(0.1)


def enable_base():
    """Waits until its drives have booted; whether it is enabled, or needs not be."""
    if not rospy.has_param('/can_bridge'):
        return True
    rospy.wait_for_service('/can_bridge/enable')
    enable = rospy.ServiceProxy('/can_bridge/enable', Trigger)
    for _ in range(ENABLE_ATTEMPTS):
        answer = enable()
        if answer.success:
            return True
        time.sleep(1.0)
    print(f'the base is not enabled: {answer.message}', flush=True)
    return False


def main(goals):
    wait_for_controller()
    rospy.init_node('drive_tour', disable_signals=True)
    tour = Tour()
    rospy.wait_for_message('move_base/planner_status', PlannerStatus)
    rospy.wait_for_message('mpc_controller/tracking', Tracking)
    rospy.wait_for_message('map', rospy.AnyMsg)
    while tour.goals.get_num_connections() == 0:
        rospy.sleep(0.1)
    if not enable_base():
        return 1
    print(ROW.format(*HEADER), flush=True)
    return 0 if all(tour.go(goal_at(goal)) for goal in goals) else 1


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
