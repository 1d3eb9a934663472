"""The stages depend on each other only as the table of doc/design.md says, and only `ros` knows ROS."""
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
PACKAGE = 'fourwis_navigation'

# Stage -> the stages it may include besides itself.
MAY_INCLUDE = {
    'model': set(),
    'vehicle': {'model'},
    'map': {'model', 'vehicle'},
    'search': {'model', 'vehicle', 'map'},
    'segment': {'model', 'vehicle'},
    'corridor': {'model', 'vehicle', 'map'},
    'ocp': set(),
    'optimize': {'model', 'vehicle', 'ocp'},
    'planner': {'model', 'vehicle', 'map', 'search', 'segment', 'corridor', 'ocp', 'optimize'},
    'track': {'model', 'vehicle', 'ocp'},
    'can': {'model', 'vehicle'},
    'sim': {'model', 'vehicle', 'can'},
    'parameters': {'model', 'map', 'search', 'planner', 'track', 'can', 'sim'},
}
MAY_INCLUDE['cli'] = set(MAY_INCLUDE)
MAY_INCLUDE['ros'] = set(MAY_INCLUDE) - {'cli'}

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)
ROS_HEADER = re.compile(
    r'(\w+_(msgs|srvs)|actionlib|catkin|diagnostic_updater|dynamic_reconfigure|message_filters|nodelet|pluginlib'
    r'|ros|rosbag|rosgraph|roslib|rviz|tf|tf2|tf2_\w+|topic_tools|xmlrpcpp)/|XmlRpc')
# Messages and services become headers directly in the package's folder: fourwis_navigation/ModeTrajectory.h
GENERATED_HEADER = re.compile(PACKAGE + r'/\w+\.h')


def sources(*folders):
    return [path for folder in folders for path in sorted((ROOT / folder).rglob('*'))
            if path.suffix in ('.h', '.hpp', '.cpp')]


def stage_of(path):
    """The stage a file belongs to: the folder below include/fourwis_navigation, src or test."""
    parts = path.relative_to(ROOT).parts
    return parts[2] if parts[0] == 'include' else parts[1]


def includes(path):
    return INCLUDE.findall(path.read_text())


def is_ros_header(header):
    return bool(ROS_HEADER.match(header) or GENERATED_HEADER.fullmatch(header))


def included_stage(path, header):
    """The stage that `header`, included by the file `path`, belongs to; None for a header that is not ours."""
    if header.startswith(PACKAGE + '/'):
        return None if GENERATED_HEADER.fullmatch(header) else header.split('/')[1]
    beside = (path.parent / header).resolve()
    return stage_of(beside) if beside.is_file() else None


def forbidden(path, header):
    stage = stage_of(path)
    target = included_stage(path, header)
    if target is not None and target != stage and target not in MAY_INCLUDE[stage]:
        return True
    return stage != 'ros' and is_ros_header(header)


class Layering(unittest.TestCase):
    def test_every_folder_of_sources_is_a_stage_of_the_table(self):
        stages = {stage_of(path) for path in sources('include', 'src')}
        self.assertGreaterEqual(stages, {'model', 'vehicle', 'map', 'search', 'planner', 'ros'})
        self.assertLessEqual(stages, set(MAY_INCLUDE))

    def test_stages_include_only_what_the_table_allows(self):
        found = [f'{path.relative_to(ROOT)}: {header}' for path in sources('include', 'src')
                 for header in includes(path) if forbidden(path, header)]
        self.assertEqual(found, [])

    def test_tests_of_stages_other_than_ros_do_without_ros(self):
        found = [f'{path.relative_to(ROOT)}: {header}' for path in sources('test') if stage_of(path) != 'ros'
                 for header in includes(path) if is_ros_header(header)]
        self.assertEqual(found, [])

    def test_the_table_has_no_cycle(self):
        for stage, allowed in MAY_INCLUDE.items():
            self.assertNotIn(stage, allowed)
            for other in allowed:
                self.assertNotIn(stage, MAY_INCLUDE[other], f'{stage} and {other} include each other')

    def test_violations_are_recognised(self):
        model = ROOT / 'include' / PACKAGE / 'model' / 'pose.h'
        search = ROOT / 'src' / 'search' / 'search.cpp'
        node = ROOT / 'src' / 'ros' / 'node.cpp'
        for path, header in [(model, PACKAGE + '/map/obstacle_map.h'), (model, '../map/obstacle_map.h'),
                             (search, PACKAGE + '/planner/planner.h'), (search, 'ros/ros.h'),
                             (search, 'nav_msgs/OccupancyGrid.h'), (search, PACKAGE + '/PlanTrajectory.h')]:
            self.assertTrue(forbidden(path, header), f'{path}: {header}')
        for path, header in [(search, PACKAGE + '/map/obstacle_map.h'), (search, 'octomap/OcTree.h'),
                             (search, 'vector'), (node, 'ros/ros.h'), (node, PACKAGE + '/PlanTrajectory.h'),
                             (node, PACKAGE + '/planner/planner.h')]:
            self.assertFalse(forbidden(path, header), f'{path}: {header}')


if __name__ == '__main__':
    unittest.main()
