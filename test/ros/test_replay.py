"""A recorded drive replays: the same trajectories and the same wheel commands, bit for bit."""
import io
import os
import pathlib
import signal
import socket
import subprocess
import tempfile
import unittest

import rosbag

from simulated_driver import Driver

HERE = pathlib.Path(__file__).resolve().parent
PATIENCE = 120.0  # how long a replay may take [s]


def free_port():
    with socket.socket() as probe:
        probe.bind(('localhost', 0))
        return probe.getsockname()[1]


class Launch:
    """A launch file with a master of its own."""

    def __init__(self, name, folder, **arguments):
        port = free_port()
        os.environ.update(ROS_MASTER_URI=f'http://localhost:{port}', ROS_HOSTNAME='localhost', ROS_HOME=str(folder))
        words = [f'{key}:={value}' for key, value in arguments.items()]
        self.process = subprocess.Popen(['roslaunch', '-p', str(port), str(HERE / name)] + words)

    def __enter__(self):
        return self.process

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
        self.process.wait(PATIENCE)


def write_map(folder):
    """An empty room of 10 x 10 m."""
    (folder / 'room.pgm').write_bytes(b'P5 200 200 255\n' + bytes([254]) * 200 * 200)
    (folder / 'room.yaml').write_text('image: room.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n'
                                      'occupied_thresh: 0.65\nfree_thresh: 0.196\n')
    return folder / 'room.yaml'


def drive():
    """The second goal comes while the robot drives to the first, and something comes into the way to the third."""
    driver = Driver()
    driver.go_to(5.0, 1.5, 0.0)
    driver.wait_until_fast()
    driver.go_to(3.0, 4.0, 1.0)
    driver.wait_until_arrived()
    driver.go_to(6.5, 6.0, 0.0)
    driver.wait_until_fast()
    driver.block_the_way()
    driver.wait_until_arrived()


def read(bag, topic):
    with rosbag.Bag(str(bag)) as file:
        return [message for _, message, _ in file.read_messages([topic])]


def bits(message):
    """The message as bytes, but for the publisher's own count of messages."""
    message.header.seq = 0
    buffer = io.BytesIO()
    message.serialize(buffer)
    return buffer.getvalue()


class Replay(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.folder.name)
        cls.recorded, cls.replayed = folder / 'recorded.bag', folder / 'replayed.bag'
        with Launch('recorded_drive.launch', folder, map=write_map(folder), bag=cls.recorded):
            drive()
        with Launch('replayed_drive.launch', folder, bag=cls.recorded, replayed=cls.replayed) as replay:
            replay.wait(PATIENCE)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_the_trajectories_are_the_same(self):
        recorded, replayed = read(self.recorded, '/trajectory'), read(self.replayed, '/trajectory')
        kinds = [bool(trajectory.points) for trajectory in recorded]
        self.assertEqual(kinds, [True, False, True, True, False, True])
        self.assertEqual([str(t.header.stamp) for t in recorded], [str(t.header.stamp) for t in replayed])
        self.assertEqual([bits(t) for t in recorded], [bits(t) for t in replayed])

    def test_the_wheel_commands_are_the_same(self):
        """From the first trajectory to the end."""
        begin = read(self.recorded, '/trajectory')[0].header.stamp
        recorded, replayed = ([command for command in read(bag, '/wheel_commands') if command.header.stamp >= begin]
                              for bag in (self.recorded, self.replayed))
        self.assertGreater(len(recorded), 300)
        replayed = {command.header.stamp: command for command in replayed}
        missing = [command for command in recorded if command.header.stamp not in replayed]
        # The last ones may have been on their way when the bag ended.
        self.assertLess(len(missing), 10)
        for command in recorded:
            again = replayed.get(command.header.stamp, command)
            self.assertEqual(bits(command), bits(again), f'recorded\n{command}\nreplayed\n{again}')


if __name__ == '__main__':
    unittest.main()
