"""What the values of test/parameters/yaml_values.txt mean to roslaunch, and so to the nodes, and to urdf/fit_to_robot.py."""
import importlib.util
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree
import xmlrpc.client

import roslaunch

ROOT = pathlib.Path(__file__).resolve().parent.parent
KEY = 'wheel_max_rate'

spec = importlib.util.spec_from_file_location('fit_to_robot', ROOT / 'urdf' / 'fit_to_robot.py')
fit_to_robot = importlib.util.module_from_spec(spec)
spec.loader.exec_module(fit_to_robot)


def table():
    lines = (ROOT / 'test' / 'parameters' / 'yaml_values.txt').read_text().splitlines()
    return [line.rsplit(' | ', 2) for line in lines if not line.startswith('#')]


def sent(path):
    """What a node gets from <rosparam file="..."/>, as the table writes it."""
    config = roslaunch.config.ROSLaunchConfig()
    try:
        roslaunch.loader.Loader().load_rosparam(roslaunch.loader.LoaderContext('/', ''), config, 'load', None, path, None,
                                                verbose=False)
        if any(param.key != '/' + KEY for param in config.params.values()):
            return 'map'
        value = xmlrpc.client.loads(xmlrpc.client.dumps((config.params['/' + KEY].value,)))[0][0]
    except (ValueError, TypeError, OverflowError):
        return 'nothing'
    for types, word in ((bool, 'flag'), ((int, float), 'number'), (str, 'text'), (list, 'list')):
        if isinstance(value, types):
            return word, value
    return value


def fitted(path):
    """What the robot's model shows; None where it is refused."""
    try:
        joint = fit_to_robot.fitted(fit_to_robot.Robot(path)).find("joint[@name='front_left_steering_joint']")
    except Exception:
        return None
    return float(joint.find('limit').get('velocity'))


class YamlValues(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix='a folder with spaces ')
        self.addCleanup(self.folder.cleanup)

    def file_with(self, written):
        path = pathlib.Path(self.folder.name) / 'robot.yaml'
        path.write_text(f'{KEY}: {written}\n')
        return str(path)

    def test_roslaunch_sends_what_the_table_says(self):
        for written, expected, _ in table():
            word, _, text = expected.partition(' ')
            value = {'number': float, 'flag': lambda flag: flag == 'true', 'text': str}.get(word, lambda _: None)(text)
            found = sent(self.file_with(written))
            if word == 'number' and math.isnan(value):
                self.assertTrue(math.isnan(found[1]), written)
            elif word in ('number', 'flag', 'text'):
                self.assertEqual(found, (word, value), written)
            else:
                self.assertEqual(found[0] if isinstance(found, tuple) else found, word, written)

    def test_the_model_has_the_same_number_or_none(self):
        beyond_the_range = ('2147483647', '4294967296.0')  # of the key, which the model does not know
        for written, _, meaning in table():
            if written not in beyond_the_range:
                expected = None if meaning == '-' else float(meaning)
                self.assertEqual(fitted(self.file_with(written)), expected, written)

    def test_the_model_is_refused_in_one_line_with_file_and_key(self):
        for written in ('2 m', '4294967296', 'rad(x)', '{'):
            path = self.file_with(written)
            run = subprocess.run([sys.executable, ROOT / 'urdf' / 'fit_to_robot.py', path], capture_output=True, text=True)
            self.assertEqual(run.returncode, 1, written)
            self.assertEqual(run.stderr.count('\n'), 1, run.stderr)
            self.assertIn(path, run.stderr)
            self.assertTrue(KEY in run.stderr or written in ('rad(x)', '{'), run.stderr)


if __name__ == '__main__':
    unittest.main()
