#!/usr/bin/python3
"""Prints fourwis.urdf, beside this file, with the body and the wheels of another robot. A footprint is shown as the rectangle that
it fills.

  fit_to_robot.py ROBOT.yaml      a file like config/robot.yaml; missing keys take their defaults
"""
import math
import pathlib
import re
import sys
import xml.etree.ElementTree

import rosparam  # teaches yaml deg(..) and rad(..), as it does for roslaunch
import yaml

ROOT = pathlib.Path(__file__).resolve().parent.parent
# PyYAML takes 2e-2 for a text. The nodes read it as a number, and a number in quotes as well.
NUMBER = re.compile(r'[-+]?(?!0[0-9])([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][-+]?[0-9]+)?')
# Front or rear, left or right of the centre.
WHEELS = {'front_left': (1, 1), 'front_right': (1, -1), 'rear_left': (-1, 1), 'rear_right': (-1, -1)}
NOSE = 0.1  # its length, from the front edge back [m]


def body_box(robot):
    """Rear, front, right and left of the rectangle that the body fills, in base_link."""
    corners = robot.points('footprint')
    if corners:
        xs, ys = zip(*corners)
        return min(xs), max(xs), min(ys), max(ys)
    (x, y), (dx, dy) = robot.point('base_offset'), robot.point('body_offset')
    length, width = robot['length'] / 2, robot['width'] / 2
    return x + dx - length, x + dx + length, y + dy - width, y + dy + width


def fit_body(link, robot):
    body, nose = link.findall('visual')
    rear, front, right, left = body_box(robot)
    middle = (right + left) / 2
    body.find('origin').set('xyz', f'{(rear + front) / 2} {middle} 0.3')
    body.find('geometry/box').set('size', f'{front - rear} {left - right} 0.1')
    nose.find('origin').set('xyz', f'{front - NOSE / 2} {middle} 0.355')
    nose.find('geometry/box').set('size', f'{NOSE} {(left - right) * 0.65} 0.01')


def fit_wheel(joint, robot, front, left):
    height = joint.find('origin').get('xyz').split()[2]
    x, y = robot.point('base_offset')
    joint.find('origin').set(
        'xyz', f"{x + front * robot['wheelbase'] / 2} {y + left * robot['track_width'] / 2} {height}")
    joint.find('limit').set('lower', str(-robot['wheel_max_angle']))
    joint.find('limit').set('upper', str(robot['wheel_max_angle']))
    joint.find('limit').set('velocity', str(robot['wheel_max_rate']))


class Robot(dict):
    """The keys of a file as roslaunch gives them to the nodes."""

    def __init__(self, path):
        super().__init__(yaml.safe_load((ROOT / 'config' / 'robot.yaml').read_text(encoding='utf-8')))
        self.update(yaml.safe_load(pathlib.Path(path).read_text(encoding='utf-8')) or {})

    def __getitem__(self, key):
        return self.number(key, super().__getitem__(key))

    def points(self, key):
        """The corners of a polygon: a list, or a text of one, as the nodes take both."""
        value = super().__getitem__(key)
        value = yaml.safe_load(value) if isinstance(value, str) else value
        if not isinstance(value, list) or any(not isinstance(point, list) or len(point) != 2 for point in value):
            raise ValueError(f"parameter '{key}' is {value!r}, expected corners [[x, y], [x, y], ...] or []")
        return [tuple(self.number(key, number) for number in point) for point in value]

    def point(self, key):
        value = super().__getitem__(key)
        value = yaml.safe_load(value) if isinstance(value, str) else value
        if not isinstance(value, list) or len(value) != 2:
            raise ValueError(f"parameter '{key}' is {value!r}, expected two numbers [x, y]")
        return tuple(self.number(key, number) for number in value)

    @staticmethod
    def number(key, value):
        if isinstance(value, str) and NUMBER.fullmatch(value):
            value = float(value)
        if type(value) not in (int, float) or not math.isfinite(value):
            raise ValueError(f"parameter '{key}' is {value!r}, expected a number")
        if type(value) is int and not -2**31 <= value < 2**31:
            raise ValueError(f"parameter '{key}' is {value}, expected a whole number of at most 31 bits, "
                             'or one with a decimal point')
        return value


def fitted(robot):
    """The model as an XML element."""
    model = xml.etree.ElementTree.parse(pathlib.Path(__file__).with_name('fourwis.urdf')).getroot()
    fit_body(model.find("link[@name='base_link']"), robot)
    for name, place in WHEELS.items():
        fit_wheel(model.find(f"joint[@name='{name}_steering_joint']"), robot, *place)
    return model


if __name__ == '__main__':
    try:
        print(xml.etree.ElementTree.tostring(fitted(Robot(sys.argv[1])), encoding='unicode'))
    except Exception as error:  # of yaml and rosparam, too, which evaluates what stands in rad(..)
        sys.exit(f'fit_to_robot.py: {sys.argv[1]}: {" ".join(str(error).split())}')
