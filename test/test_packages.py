"""scripts/packages_debian.txt installs what package.xml asks for, neither less nor more."""
import collections
import pathlib
import unittest
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parent.parent
WHEN = {'depend': 'build', 'build_depend': 'build', 'buildtool_depend': 'build', 'exec_depend': 'exec',
        'test_depend': 'test'}


def rows():
    lines = (ROOT / 'scripts' / 'packages_debian.txt').read_text().splitlines()
    return [line.split() for line in lines if line.strip() and not line.startswith('#')]


class Packages(unittest.TestCase):
    def test_the_table_has_the_keys_of_the_manifest(self):
        manifest = xml.etree.ElementTree.parse(ROOT / 'package.xml').getroot()
        asked = {(WHEN[element.tag], element.text) for element in manifest if element.tag in WHEN}
        self.assertIn(('build', 'roscpp'), asked)
        self.assertEqual(asked, {(when, key) for when, key, *_ in rows() if key != '-'})

    def test_each_row_names_packages_and_each_key_comes_once(self):
        for row in rows():
            self.assertGreaterEqual(len(row), 3, row)
        keys = collections.Counter((when, key) for when, key, *_ in rows())
        self.assertEqual([key for key, count in keys.items() if count > 1], [])


if __name__ == '__main__':
    unittest.main()
