"""The stages depend on each other only as src/stages.txt says, and only `ros` knows ROS."""
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
PACKAGE = 'fourwis_navigation'



def read_stages(path=ROOT / 'src' / 'stages.txt'):
    """The rows (stage, what it does, the stages it may include besides itself) of the table, in order."""
    rows = []
    for line in path.read_text().splitlines():
        if line and not line.startswith('#'):
            stage, task, allowed = (cell.strip() for cell in line.split('|'))
            rows.append((stage, task, allowed.split()))
    return rows


STAGES = read_stages()
MAY_INCLUDE = {stage: set(allowed) for stage, _, allowed in STAGES}

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)
ROS_HEADER = re.compile(
    r'(\w+_(msgs|srvs)|actionlib|catkin|diagnostic_updater|dynamic_reconfigure|message_filters|nodelet|pluginlib'
    r'|ros|rosbag|rosgraph|roslib|rviz|tf|tf2|tf2_\w+|topic_tools|xmlrpcpp)/|XmlRpc')
# Messages and services become headers directly in the package's folder: fourwis_navigation/ModeTrajectory.h
GENERATED_HEADER = re.compile(PACKAGE + r'/\w+\.h')


def sources(*folders):
    return [path for folder in folders for path in sorted((ROOT / folder).rglob('*'))
            if path.suffix in ('.h', '.hpp', '.cpp')]


def stage_of_folder(parts):
    """The stage of the file whose path below include/fourwis_navigation, src or test has these parts."""
    two = '/'.join(parts[:2])
    return two if two in MAY_INCLUDE else parts[0]


def stage_of(path):
    parts = path.relative_to(ROOT).parts
    return stage_of_folder(parts[2:] if parts[0] == 'include' else parts[1:])


def includes(path):
    return INCLUDE.findall(path.read_text())


def is_ros_header(header):
    return bool(ROS_HEADER.match(header) or GENERATED_HEADER.fullmatch(header))


def included_file(path, header):
    """The file of ours that `header`, included by the file `path`, means; None for a header that is not ours."""
    if header.startswith(PACKAGE + '/'):
        return None if GENERATED_HEADER.fullmatch(header) else ROOT / 'include' / header
    beside = (path.parent / header).resolve()
    return beside if beside.is_file() else None


def find_cycle(allowed):
    """A list of stages, each of which may include the next and the last the first; None where there is none."""
    done = set()

    def visit(stage, way):
        if stage in way:
            return way[way.index(stage):]
        if stage not in done:
            for other in sorted(allowed[stage]):
                cycle = visit(other, way + [stage])
                if cycle:
                    return cycle
            done.add(stage)
        return None

    for stage in allowed:
        cycle = visit(stage, [])
        if cycle:
            return cycle
    return None


def lonely_headers(included_by):
    """Of the public headers those that neither another stage nor a lasting public header of their own stage includes.
    `included_by` gives the files of ours below include/ and src/ that include a header."""
    public = {path for path in included_by if path.is_relative_to(ROOT / 'include')}
    needed = {path for path in public if any(stage_of(user) != stage_of(path) for user in included_by[path])}
    while True:
        more = {path for path in public - needed if included_by[path] & needed}
        if not more:
            return sorted(public - needed)
        needed |= more


def forbidden(path, header):
    stage = stage_of(path)
    target = included_file(path, header)
    if target is not None:
        other = stage_of(target)
        if other != stage and (other not in MAY_INCLUDE[stage] or target.is_relative_to(ROOT / 'src')):
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
        self.assertIsNone(find_cycle(MAY_INCLUDE))

    def test_cycles_of_any_length_are_found(self):
        self.assertEqual(find_cycle({'a': {'a'}}), ['a'])
        self.assertEqual(find_cycle({'a': {'b'}, 'b': {'c'}, 'c': {'b'}}), ['b', 'c'])
        self.assertEqual(len(find_cycle({'a': {'b'}, 'b': {'c'}, 'c': {'d'}, 'd': {'a'}})), 4)
        self.assertIsNone(find_cycle({'a': {'b', 'c'}, 'b': {'c'}, 'c': set()}))

    def test_each_stage_stands_below_those_it_may_include(self):
        seen = set()
        for stage, _, allowed in STAGES:
            self.assertLessEqual(set(allowed), seen, stage)
            seen.add(stage)

    def test_public_headers_are_those_that_other_stages_include(self):
        included_by = {path: set() for path in sources('include')}
        for path in sources('include', 'src'):
            for header in includes(path):
                target = included_file(path, header)
                if target is not None:
                    included_by.setdefault(target, set()).add(path)
        self.assertEqual([str(path.relative_to(ROOT)) for path in lonely_headers(included_by)], [])

    def test_lonely_headers_are_recognised(self):
        include, source = ROOT / 'include' / PACKAGE, ROOT / 'src'
        pose, path, plan, secret = (include / 'model' / name for name in ('pose.h', 'path.h', 'plan.h', 'secret.h'))
        users = {pose: {path}, path: {source / 'search' / 'search.cpp'}, plan: {source / 'model' / 'plan.cpp'},
                 secret: {plan}}
        self.assertEqual(lonely_headers(users), [plan, secret])

    def test_the_documentation_shows_the_table(self):
        rows = [f'| `{stage}` | {task} | {", ".join(allowed) or "nothing of ours"} |' for stage, task, allowed in STAGES]
        self.assertIn('\n'.join(rows), (ROOT / 'doc' / 'design.md').read_text())

    def test_violations_are_recognised(self):
        model = ROOT / 'include' / PACKAGE / 'model' / 'pose.h'
        search = ROOT / 'src' / 'search' / 'search.cpp'
        node = ROOT / 'src' / 'ros' / 'node.cpp'
        bus = ROOT / 'src' / 'can' / 'bus' / 'bus.cpp'
        for path, header in [(model, PACKAGE + '/map/obstacle_map.h'), (model, '../map/obstacle_map.h'),
                             (search, '../map/image.h'), (bus, PACKAGE + '/can/bridge/bridge.h'),
                             (search, PACKAGE + '/planner/planner.h'), (search, 'ros/ros.h'),
                             (search, 'nav_msgs/OccupancyGrid.h'), (search, PACKAGE + '/PlanTrajectory.h')]:
            self.assertTrue(forbidden(path, header), f'{path}: {header}')
        for path, header in [(search, PACKAGE + '/map/obstacle_map.h'), (search, 'octomap/OcTree.h'),
                             (search, 'vector'), (bus, PACKAGE + '/can/protocol/frame.h'), (node, 'ros/ros.h'), (node, PACKAGE + '/PlanTrajectory.h'),
                             (node, PACKAGE + '/planner/planner.h')]:
            self.assertFalse(forbidden(path, header), f'{path}: {header}')


if __name__ == '__main__':
    unittest.main()
