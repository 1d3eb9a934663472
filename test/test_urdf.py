"""urdf/fourwis.urdf shows the robot that config/robot.yaml describes."""
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

import yaml

ROOT = pathlib.Path(__file__).resolve().parent.parent
WHEELS = {'front_left': (1, 1), 'front_right': (1, -1), 'rear_left': (-1, 1), 'rear_right': (-1, -1)}


def numbers(text):
    return [float(word) for word in text.split()]


class Urdf(unittest.TestCase):
    def setUp(self):
        self.robot = yaml.safe_load((ROOT / 'config' / 'robot.yaml').read_text())
        self.urdf = xml.etree.ElementTree.parse(ROOT / 'urdf' / 'fourwis.urdf').getroot()

    def joint(self, name):
        found = self.urdf.findall(f"joint[@name='{name}']")
        self.assertEqual(len(found), 1, name)
        return found[0]

    def link(self, name):
        found = self.urdf.findall(f"link[@name='{name}']")
        self.assertEqual(len(found), 1, name)
        return found[0]

    def test_the_body_is_the_rectangle(self):
        size = numbers(self.link('base_link').find('visual/geometry/box').get('size'))
        self.assertEqual(size[:2], [self.robot['length'], self.robot['width']])

    def test_the_steering_axes_are_where_the_robot_has_them(self):
        for name, (front, left) in WHEELS.items():
            joint = self.joint(name + '_steering_joint')
            self.assertEqual(joint.find('parent').get('link'), 'base_link')
            x, y, _ = numbers(joint.find('origin').get('xyz'))
            self.assertAlmostEqual(x, front * self.robot['wheelbase'] / 2)
            self.assertAlmostEqual(y, left * self.robot['track_width'] / 2)
            self.assertEqual(numbers(joint.find('axis').get('xyz')), [0, 0, 1])

    def test_the_steering_joints_have_the_travel_and_rate_of_the_wheels(self):
        for name in WHEELS:
            joint = self.joint(name + '_steering_joint')
            self.assertEqual(joint.get('type'), 'revolute')
            limit = joint.find('limit')
            self.assertAlmostEqual(float(limit.get('lower')), -self.robot['wheel_max_angle'])
            self.assertAlmostEqual(float(limit.get('upper')), self.robot['wheel_max_angle'])
            self.assertAlmostEqual(float(limit.get('velocity')), self.robot['wheel_max_rate'])

    def test_the_wheels_roll_forward_below_their_steering_joints_and_stand_on_the_ground(self):
        for name in WHEELS:
            steering, rolling = self.joint(name + '_steering_joint'), self.joint(name + '_wheel_joint')
            self.assertEqual(rolling.get('type'), 'continuous')
            self.assertEqual(rolling.find('parent').get('link'), steering.find('child').get('link'))
            self.assertEqual(numbers(rolling.find('axis').get('xyz')), [0, 1, 0])
            tyre = self.link(rolling.find('child').get('link')).find('visual/geometry/cylinder')
            height = numbers(steering.find('origin').get('xyz'))[2]
            self.assertAlmostEqual(float(tyre.get('radius')), height)

    def test_it_is_one_tree_of_nothing_but_these_joints(self):
        joints = {joint.get('name') for joint in self.urdf.findall('joint')}
        self.assertEqual(joints, {f'{name}_{kind}_joint' for name in WHEELS for kind in ('steering', 'wheel')})
        links = {link.get('name') for link in self.urdf.findall('link')}
        children = [joint.find('child').get('link') for joint in self.urdf.findall('joint')]
        self.assertEqual(len(children), len(set(children)))
        self.assertEqual(links - set(children), {'base_link'})


class FittedUrdf(Urdf):
    """fit_to_robot.py makes it show another robot."""

    def setUp(self):
        robot = ROOT / 'config' / 'robot_compact.yaml'
        self.robot = yaml.safe_load(robot.read_text())
        model = subprocess.run([sys.executable, ROOT / 'urdf' / 'fit_to_robot.py', robot], check=True,
                               capture_output=True, text=True).stdout
        self.urdf = xml.etree.ElementTree.fromstring(model)


class UrdfOfAFootprint(unittest.TestCase):
    """The polygon's extent, and the wheels where they are in base_link."""

    ROBOT = """
base_offset: [0.34, -0.1]
footprint: "[[1.0, 0.3], [-0.2, 0.3], [-0.2, -0.5], [0.9, -5e-1]]"
"""

    def test_it_is_shown_around_base_link(self):
        with tempfile.NamedTemporaryFile('w', suffix='.yaml') as robot:
            robot.write(self.ROBOT)
            robot.flush()
            model = subprocess.run([sys.executable, ROOT / 'urdf' / 'fit_to_robot.py', robot.name], check=True,
                                   capture_output=True, text=True).stdout
        urdf = xml.etree.ElementTree.fromstring(model)
        body = urdf.find("link[@name='base_link']/visual")
        for seen, expected in zip(numbers(body.find('origin').get('xyz')), (0.4, -0.1, 0.3)):
            self.assertAlmostEqual(seen, expected)
        for seen, expected in zip(numbers(body.find('geometry/box').get('size')), (1.2, 0.8, 0.1)):
            self.assertAlmostEqual(seen, expected)
        front_left = numbers(urdf.find("joint[@name='front_left_steering_joint']/origin").get('xyz'))
        self.assertAlmostEqual(front_left[0], 0.68)
        self.assertAlmostEqual(front_left[1], 0.16)

    def test_what_is_no_polygon_is_refused_by_name(self):
        for text in ('footprint: 3', 'footprint: [[1, 2, 3]]', 'footprint: [[a, 1]]', 'base_offset: [1]'):
            with tempfile.NamedTemporaryFile('w', suffix='.yaml') as robot:
                robot.write(text)
                robot.flush()
                done = subprocess.run([sys.executable, ROOT / 'urdf' / 'fit_to_robot.py', robot.name],
                                      capture_output=True, text=True)
            self.assertEqual(done.returncode, 1, text)
            self.assertIn(f"parameter '{text.split(':')[0]}'", done.stderr)


if __name__ == '__main__':
    unittest.main()
