"""The range of an option is written once: in the table beside its member, describe() (model/option_check.h)."""
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
NUMBER = r'-?\d[\w.]*(?:e[+-]?\d+)?(?: ?[*/] ?[\w.]+)*|-?M_PI[\w.*/ ]*'
ROW = re.compile(r'\brow(?:\.fixed|\.group)?\(\s*([^;]*?)\);', re.DOTALL)
MEMBER = re.compile(r'\bo\.([\w.\[\]]+)')
DESCRIBE = re.compile(r'static void describe\w*\(Self& o, Row& row\)\n( *)\{\n.*?\n\1\}\n', re.DOTALL)
STRUCT = re.compile(r'\nstruct (\w+)[^;{]*\n\{')
# "name", value, least, greatest: how a range was written where it was checked, before the tables.
CHECKED = re.compile(rf'"[\w/]+",[^;"]*?,\s*(?:{NUMBER}),\s*(?:{NUMBER})\s*[,)}}]')
PAIR = re.compile(rf'(?<![\w.])(?:{NUMBER}),\s*(?:{NUMBER})(?![\w.])')


def sources(*folders):
    return [path for folder in folders for path in sorted((ROOT / folder).rglob('*')) if path.suffix in ('.h', '.cpp')]


def without_tables(text):
    return DESCRIBE.sub('', text)


def without_comments(text):
    return re.sub(r'//[^\n]*', '', text)


def members_described(text):
    """(struct, member) of each row of each table in a header."""
    found = []
    for table in DESCRIBE.finditer(text):
        struct = [match.group(1) for match in STRUCT.finditer(text, 0, table.start())][-1]
        for row in ROW.finditer(table.group()):
            found += [(struct, member) for member in MEMBER.findall(row.group(1))]
    return found


class OptionRanges(unittest.TestCase):
    def test_no_range_is_written_outside_a_table(self):
        found = [f'{path.relative_to(ROOT)}: {match.group()}' for path in sources('include', 'src')
                 if 'ocp' not in path.parts  # includes nothing of ours
                 for match in CHECKED.finditer(without_comments(without_tables(path.read_text())))]
        self.assertEqual(found, [])

    def test_the_parameter_layer_knows_no_numbers(self):
        files = sources('src/parameters', 'include/fourwis_navigation/parameters')
        found = [f'{path.relative_to(ROOT)}: {match.group()}' for path in files
                 for match in PAIR.finditer(without_comments(without_tables(path.read_text())))]
        self.assertEqual(found, [])

    def test_each_member_is_described_once(self):
        described = [(path, *row) for path in sources('include', 'src') for row in members_described(path.read_text())]
        self.assertGreater(len(described), 150)
        twice = [row for row in described if described.count(row) > 1]
        self.assertEqual(twice, [])

    def test_ranges_are_recognised(self):
        for text in ('{"length", robot(&Robot::length), 0.05, 20.0, "m"},', 'require_between("lag", options.lag, 0.0, 1.0);',
                     '{"max_steering_angle", robot(&Robot::max_steering_angle), 0.01, M_PI * 80 / 180, "rad"},',
                     'reader.number("initial_yaw", -2.0 * M_PI, 2.0 * M_PI, "rad")',
                     'table.push_back({prefix + "gear_ratio", axis(a, b, &AxisOptions::gear_ratio), 1e-3, 1e4});'):
            self.assertTrue(CHECKED.search(text) or PAIR.search(text), text)
        for text in ('reject("length", value, "a number")', 'find("length", 0)', 'sentence("%g", a, b)'):
            self.assertFalse(CHECKED.search(text) or PAIR.search(text), text)
        table = '''
struct Options
{
  double a = 1.0;
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("a", o.a, 0.0, 1.0, "m");
    row.group("", o.b);
  }
};
'''
        self.assertEqual(members_described(table), [('Options', 'a'), ('Options', 'b')])
        self.assertNotIn('0.0, 1.0', without_tables(table))


if __name__ == '__main__':
    unittest.main()
