"""Launch files that start planner and controller make the one wait for the other, and say whose time it is."""
import pathlib
import shlex
import tempfile
import unittest
import xml.etree.ElementTree

import roslaunch

LAUNCH = pathlib.Path(__file__).resolve().parent.parent / 'launch'


def load(path, *arguments):
    config = roslaunch.config.ROSLaunchConfig()
    roslaunch.xmlloader.XmlLoader(resolve_anon=False).load(str(path), config, argv=list(arguments), verbose=False)
    return config


class LaunchFiles(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        configs = {path.name: load(path) for path in sorted(LAUNCH.glob('*.launch'))}
        cls.both = {name: config.params for name, config in configs.items()
                    if {'global_planner_node', 'mpc_controller_node'} <= {node.type for node in config.nodes}}

    def test_the_robot_the_simulation_and_the_replay_start_both(self):
        self.assertEqual(sorted(self.both), ['replay.launch', 'robot.launch', 'simulation.launch'])

    def test_the_planner_waits_for_the_controller(self):
        for name, params in self.both.items():
            self.assertIs(params['/move_base/wait_for_controller'].value, True, name)

    def test_plans_start_from_where_the_robot_is(self):
        for name, params in self.both.items():
            self.assertEqual(params['/move_base/start_from'].value, 'tf', name)

    def test_no_launch_inherits_the_time_of_the_one_before(self):
        simulated = {name: params['/use_sim_time'].value for name, params in self.both.items()
                     if '/use_sim_time' in params}
        self.assertEqual(simulated, {'replay.launch': True, 'robot.launch': False, 'simulation.launch': True})

    def test_files_may_lie_in_a_folder_with_a_space_or_a_quote(self):
        with tempfile.TemporaryDirectory() as temporary:
            folder = pathlib.Path(temporary, "Ada's maps")
            folder.mkdir()
            robot, bag = folder / 'my robot.yaml', folder / 'my drive.bag'
            text = (LAUNCH.parent / 'config' / 'robot.yaml').read_text(encoding='utf-8')
            robot.write_text(text.replace('\nlength: 1.0', '\nlength: 0.875'), encoding='utf-8')
            for name in ('simulation.launch', 'robot.launch'):
                params = load(LAUNCH / name, f'robot:={robot}', f'map:={folder}/my map.yaml').params
                self.assertEqual(params['/map_publisher/map_file'].value, f'{folder}/my map.yaml')
                for node in ('move_base', 'mpc_controller'):
                    self.assertEqual(params[f'/{node}/robot/length'].value, 0.875)
                model = xml.etree.ElementTree.fromstring(params['/robot_description'].value)
                self.assertEqual(model.find("link[@name='base_link']/visual/geometry/box").get('size').split()[0], '0.875')
            for name in ('record.launch', 'replay.launch'):
                arguments = [node.args for node in load(LAUNCH / name, f'bag:={bag}').nodes if node.package == 'rosbag']
                self.assertEqual([word for word in shlex.split(arguments[0]) if word.endswith('.bag')], [str(bag)])


if __name__ == '__main__':
    unittest.main()
