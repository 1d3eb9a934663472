"""An installation of this build is a package that other projects find and use: the examples are such a project.

    test_examples.py BUILD PACKAGE      PACKAGE: where find_package() looks for the package in the folder BUILD
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
NUMBER = r'(\d+\.\d+)'


def run(*command):
    """What the command prints; raises, with what it prints, where it fails."""
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        raise AssertionError(f'{command} exits with {done.returncode}:\n{done.stdout}')
    return done.stdout


def configure(build, *options):
    run('cmake', '-S', ROOT / 'examples', '-B', build, *options)


class Examples(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.prefix, cls.build = pathlib.Path(folder.name, 'installed'), pathlib.Path(folder.name, 'build')
        run('cmake', '--install', BUILD, '--prefix', cls.prefix)
        configure(cls.build, f'-DCMAKE_PREFIX_PATH={cls.prefix}')
        run('cmake', '--build', cls.build)

    def numbers(self, pattern, example, *arguments):
        """The numbers in the example's last line, which the pattern matches."""
        last = run(self.build / example, *arguments).splitlines()[-1]
        found = re.fullmatch(pattern, last)
        self.assertTrue(found, last)
        return [float(number) for number in found.groups()]

    def test_the_package_found_is_the_one_installed(self):
        cache = (self.build / 'CMakeCache.txt').read_text()
        self.assertRegex(cache, f'fourwis_navigation_DIR:PATH={re.escape(str(self.prefix))}/')

    def test_the_package_is_found_in_the_build_as_well(self):
        with tempfile.TemporaryDirectory() as folder:
            configure(folder, f'-Dfourwis_navigation_DIR={PACKAGE}')

    def test_each_stage_but_ros_is_a_target(self):
        targets = next(self.prefix.rglob('fourwis_navigationTargets.cmake')).read_text()
        stages = re.findall(r'^([a-z/_]+) *\|', (ROOT / 'src' / 'stages.txt').read_text(), re.MULTILINE)
        self.assertIn('planner', stages)
        self.assertEqual(set(re.findall(r'^add_library\(fourwis::(\w+) ', targets, re.MULTILINE)),
                         {stage.replace('/', '_') for stage in stages} - {'ros'})

    def test_the_targets_hold_no_path_of_this_machine(self):
        targets = next(self.prefix.rglob('fourwis_navigationTargets.cmake')).read_text()
        linked = re.findall(r'INTERFACE_LINK_LIBRARIES "(.*)"', targets)
        self.assertTrue(any('octomap' in libraries for libraries in linked))
        self.assertEqual([path for libraries in linked for path in libraries.split(';') if '/' in path], [])

    def test_the_licence_is_installed(self):
        licence = self.prefix / 'share' / 'fourwis_navigation' / 'LICENSE'
        self.assertEqual(licence.read_text(), (ROOT / 'LICENSE').read_text())

    def test_plan_in_grid(self):
        length, time, clearance = self.numbers(
            rf'succeeded: {NUMBER} m in {NUMBER} s, \d+ mode switches, at least {NUMBER} m from all obstacles',
            'plan_in_grid')
        self.assertGreater(length, 3.5)
        self.assertGreater(time, length)
        self.assertGreater(clearance, 0.0)

    def test_plan_from_map(self):
        length, time, _ = self.numbers(rf'succeeded: {NUMBER} m in {NUMBER} s, planned in {NUMBER} ms',
                                       'plan_from_map', ROOT / 'config' / 'env4.yaml', '1.1,1.1,1.57', '10.65,8.75,3.14')
        self.assertGreater(length, 12.2)
        self.assertGreater(time, length)

    def test_drive_without_ros(self):
        driven, planned, miss = self.numbers(rf'arrived: after {NUMBER} s, planned {NUMBER} s, {NUMBER} mm from the goal',
                                             'drive_without_ros')
        self.assertGreater(planned, 6.1)
        self.assertGreater(driven, planned)
        self.assertLess(miss, 10.0)


if __name__ == '__main__':
    PACKAGE, BUILD = sys.argv.pop(), sys.argv.pop()
    unittest.main()
