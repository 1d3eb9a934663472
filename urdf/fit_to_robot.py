#!/usr/bin/python3
"""Prints fourwis.urdf, beside this file, with the body and the wheels of another robot.

  fit_to_robot.py ROBOT.yaml      a file like config/robot.yaml
"""
import pathlib
import sys
import xml.etree.ElementTree

import yaml

# Front or rear, left or right of the centre.
WHEELS = {'front_left': (1, 1), 'front_right': (1, -1), 'rear_left': (-1, 1), 'rear_right': (-1, -1)}
NOSE = 0.1  # its length, from the front edge back [m]


def fit_body(link, robot):
    body, nose = link.findall('visual')
    body.find('geometry/box').set('size', f"{robot['length']} {robot['width']} 0.1")
    nose.find('origin').set('xyz', f"{(robot['length'] - NOSE) / 2} 0 0.355")
    nose.find('geometry/box').set('size', f"{NOSE} {robot['width'] * 0.65} 0.01")


def fit_wheel(joint, robot, front, left):
    height = joint.find('origin').get('xyz').split()[2]
    joint.find('origin').set('xyz', f"{front * robot['wheelbase'] / 2} {left * robot['track_width'] / 2} {height}")
    joint.find('limit').set('lower', str(-robot['wheel_max_angle']))
    joint.find('limit').set('upper', str(robot['wheel_max_angle']))
    joint.find('limit').set('velocity', str(robot['wheel_max_rate']))


def fitted(robot):
    """The model as an XML element; `robot` as read from its YAML file."""
    model = xml.etree.ElementTree.parse(pathlib.Path(__file__).with_name('fourwis.urdf')).getroot()
    fit_body(model.find("link[@name='base_link']"), robot)
    for name, place in WHEELS.items():
        fit_wheel(model.find(f"joint[@name='{name}_steering_joint']"), robot, *place)
    return model


if __name__ == '__main__':
    with open(sys.argv[1], encoding='utf-8') as file:
        print(xml.etree.ElementTree.tostring(fitted(yaml.safe_load(file)), encoding='unicode'))
