"""Launch files that start planner and controller make the one wait for the other, and say whose time it is."""
import pathlib
import unittest

import roslaunch

LAUNCH = pathlib.Path(__file__).resolve().parent.parent / 'launch'


def load(path):
    config = roslaunch.config.ROSLaunchConfig()
    roslaunch.xmlloader.XmlLoader(resolve_anon=False).load(str(path), config, argv=[], verbose=False)
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

    def test_nobody_inherits_the_time_of_the_launch_before(self):
        simulated = {name: params['/use_sim_time'].value for name, params in self.both.items()
                     if '/use_sim_time' in params}
        self.assertEqual(simulated, {'replay.launch': True, 'robot.launch': False, 'simulation.launch': True})


if __name__ == '__main__':
    unittest.main()
