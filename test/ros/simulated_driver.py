"""Sends the simulated robot to goals and waits for what comes of it."""
import math
import threading
import time

import rosgraph
import rospy
from geometry_msgs.msg import PoseStamped
from map_msgs.msg import OccupancyGridUpdate

from fourwis_navigation.msg import ModeTrajectory, PlannerStatus, Tracking

PATIENCE = 60.0  # how long to wait for what must happen [s]


def wait_until(condition):
    """For conditions that have no notification."""
    end = time.monotonic() + PATIENCE
    while not condition():
        if time.monotonic() > end:
            raise AssertionError(f'{condition.__name__} did not come true')
        time.sleep(0.05)


def is_time_simulated():
    try:
        return rosgraph.Master('/driver').hasParam('/use_sim_time')
    except OSError:  # no master yet
        return False


class Inbox:
    """Keeps what arrives on a topic."""

    def __init__(self, topic, kind):
        self.messages = []
        self.changed = threading.Condition()
        rospy.Subscriber(topic, kind, self.receive)

    def receive(self, message):
        with self.changed:
            self.messages.append(message)
            self.changed.notify_all()

    def wait_for(self, condition):
        with self.changed:
            if not self.changed.wait_for(lambda: any(map(condition, self.messages)), PATIENCE):
                raise AssertionError(f'did not come; the last of {len(self.messages)} is {self.messages[-1:]}')
            return next(message for message in self.messages if condition(message))

    def wait_for_news(self, condition):
        with self.changed:
            self.messages.clear()
        return self.wait_for(condition)


class Driver:
    def __init__(self):
        wait_until(is_time_simulated)  # a node that is there before has another idea of time for ever
        rospy.init_node('driver')
        self.goals = rospy.Publisher('move_base_simple/goal', PoseStamped, queue_size=10)
        self.map_updates = rospy.Publisher('map_updates', OccupancyGridUpdate, queue_size=10)
        self.statuses = Inbox('move_base/planner_status', PlannerStatus)
        self.tracking = Inbox('mpc_controller/tracking', Tracking)
        self.trajectories = Inbox('trajectory', ModeTrajectory)
        begin = self.tracking.wait_for(lambda tracking: tracking.state == Tracking.IDLE).header.stamp
        # Until then all have heard of where the robot is, at the replay as well.
        self.tracking.wait_for(lambda tracking: tracking.header.stamp > begin + rospy.Duration(2.0))

    def go_to(self, x, y, yaw):
        goal = PoseStamped()
        goal.header.frame_id = 'map'
        goal.header.stamp = rospy.Time.now()
        goal.pose.position.x, goal.pose.position.y = x, y
        goal.pose.orientation.z, goal.pose.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)
        self.goals.publish(goal)

    def wait_until_fast(self):
        self.tracking.wait_for_news(lambda tracking: tracking.state == Tracking.DRIVING and abs(tracking.speed) > 0.5)

    def wait_until_arrived(self):
        self.statuses.wait_for_news(lambda status: status.state == PlannerStatus.ARRIVED)

    def block_the_way(self):
        """Occupies a place farther on, for a map that has its corner at the origin and cells of 0.05 m."""
        points = self.trajectories.messages[-1].points
        place = points[len(points) // 2]
        update = OccupancyGridUpdate(x=int(place.x / 0.05), y=int(place.y / 0.05), width=4, height=4, data=[100] * 16)
        update.header.frame_id = 'map'
        update.header.stamp = rospy.Time.now()
        self.map_updates.publish(update)
