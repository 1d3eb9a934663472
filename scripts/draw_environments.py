#!/usr/bin/env python3
"""Draws the four environments of the paper's section V, after its descriptions, into config/: env1 to env4 as PGM and
YAML, and environments.csv with start and goal of each. The same files on each run.
    draw_environments.py [FOLDER]"""
import pathlib
import sys

RESOLUTION = 0.05  # [m]
FREE, OCCUPIED = 254, 0

# Obstacles are polygons: lists of corners (x, y) [m]. A cell is occupied where its centre is inside one.


def box(left, bottom, right, top):
    return [(left, bottom), (right, bottom), (right, top), (left, top)]


def frame(width, height, thickness=0.2):
    """The outer walls of a room."""
    return [box(0, 0, width, thickness), box(0, height - thickness, width, height),
            box(0, 0, thickness, height), box(width - thickness, 0, width, height)]


def contains(polygon, x, y):
    inside = False
    for (ax, ay), (bx, by) in zip(polygon, polygon[1:] + polygon[:1]):
        if (ay > y) != (by > y) and x < ax + (y - ay) / (by - ay) * (bx - ax):
            inside = not inside
    return inside


class Environment:
    def __init__(self, width, height, start, goal, obstacles):
        self.width, self.height = width, height
        self.start, self.goal = start, goal  # x,y,yaw [m, rad]
        self.obstacles = frame(width, height) + obstacles

    def rows(self):
        """The image's rows, the uppermost first."""
        columns, rows = round(self.width / RESOLUTION), round(self.height / RESOLUTION)
        image = [bytearray([FREE]) * columns for _ in range(rows)]
        for polygon in self.obstacles:
            for row in range(rows):
                y = (rows - row - 0.5) * RESOLUTION
                for column in range(columns):
                    if contains(polygon, (column + 0.5) * RESOLUTION, y):
                        image[row][column] = OCCUPIED
        return image


MAZE = """\
+--+--+--+--+--+--+--+
|  |           |     |
+  +  +  +--+  +--+  +
|     |     |     |  |
+  +--+--+  +--+  +  +
|        |  |     |  |
+--+--+--+  +  +--+  +
|           |     |  |
+  +--+--+--+--+  +  +
|  |     |        |  |
+  +--+  +  +--+--+  +
|  |     |  |        |
+  +  +--+  +--+--+  +
|  |                 |
+--+--+--+--+--+--+--+
""".splitlines()


def maze_walls(drawing, pitch, thickness):
    """Walls of a maze drawn with + - |, on a lattice of that pitch whose origin is the lower left corner."""
    walls = []
    for line, text in enumerate(reversed(drawing)):
        y = line // 2 * pitch
        for column in range(0, len(text), 3):
            x = column // 3 * pitch
            if line % 2 == 0 and text[column + 1:column + 2] == '-':
                walls.append(box(x, y, x + pitch + thickness, y + thickness))
            if line % 2 == 1 and text[column] == '|':
                walls.append(box(x, y, x + thickness, y + pitch + thickness))
    return walls


# A maze: narrow corridors, many turns, dead ends. The goal lies in a niche of the last corridor, alongside the wall.
def env1():
    pitch, thickness = 1.85, 0.2
    side = 7 * pitch + thickness
    corner = box(side - 0.9, side - 3.1, side - 0.2, side - 2.1)
    return Environment(side, side, '1.1,1.1,0', '12.5,12.0,1.5708', maze_walls(MAZE, pitch, thickness) + [corner])


# A car park: cars head to tail along the near wall with one gap, which is the goal; side by side along the far wall and
# on the island between, round which the only way leads.
def env2():
    gap_centre, gap = 7.5, 2.0
    far = [box(x - 0.35, 7.5, x + 0.35, 8.6) for x in (3.4, 4.6, 5.8, 8.2, 9.4, 11.8)]
    island = [box(x - 0.35, 3.95, x + 0.35, 5.05) for x in (1.0, 2.2, 3.4, 4.6, 5.8, 7.0, 8.2, 9.4, 10.6)]
    length, distance = 1.1, 1.4
    behind = [gap_centre - gap / 2 - length - k * distance for k in range(4)]
    ahead = [gap_centre + gap / 2 + k * distance for k in range(3)]
    near = [box(x, 0.3, x + length, 0.95) for x in behind + ahead]
    return Environment(14.0, 9.0, '2.0,7.4,0', '7.5,0.65,0', far + island + near)


# Lateral transfer: a bay and a passage hardly longer than the robot, which faces across it at both ends.
def env3():
    return Environment(9.75, 2.6, '0.85,0.95,1.5708', '8.05,1.7,1.5708', [box(1.5, 0, 9.75, 0.8)])


# Irregular dense obstacles.
def env4():
    rubble = [
        [(9.3, 3.7), (9.4, 3.4), (9.7, 3.3), (9.9, 3.6), (9.8, 3.9), (9.5, 3.9)],
        [(1.8, 7.3), (2.8, 7.0), (3.0, 7.9), (2.2, 8.1)],
        [(6.0, 4.8), (6.0, 5.2), (5.9, 5.5), (5.5, 5.4), (5.2, 5.2), (5.4, 4.8), (5.7, 4.7)],
        [(4.9, 1.3), (5.3, 0.8), (5.9, 0.6), (6.2, 1.2), (6.0, 1.9), (5.4, 1.8)],
        [(6.4, 6.9), (6.6, 6.4), (7.0, 6.2), (7.4, 6.6), (7.4, 6.9), (7.2, 7.3), (6.7, 7.3)],
        [(3.3, 3.1), (4.3, 3.2), (4.4, 4.1), (3.7, 4.5), (3.1, 3.9)],
        [(9.9, 1.6), (9.7, 1.9), (9.3, 1.8), (9.1, 1.4), (9.4, 1.1), (9.9, 1.1)],
        [(1.8, 4.7), (1.4, 5.1), (0.7, 5.1), (0.3, 4.6), (0.5, 4.0), (1.2, 3.7), (1.8, 4.0)],
        [(7.4, 3.5), (7.7, 3.8), (7.4, 4.2), (7.1, 4.0), (7.1, 3.7)],
        [(9.3, 9.0), (8.8, 9.4), (8.2, 9.1), (8.4, 8.5), (9.1, 8.3)],
        [(4.5, 9.3), (4.2, 9.4), (3.9, 9.3), (3.8, 9.0), (4.0, 8.8), (4.3, 8.8), (4.5, 9.0)],
        [(11.2, 4.0), (11.0, 4.4), (10.7, 4.1), (10.9, 3.7)],
        [(7.6, 2.0), (8.2, 1.8), (8.5, 2.5), (7.9, 2.6)],
        [(8.9, 5.4), (9.3, 5.5), (9.5, 5.9), (9.2, 6.2), (8.8, 6.2), (8.6, 5.7)],
        [(0.0, 8.4), (0.0, 7.9), (0.5, 7.8), (0.9, 7.9), (1.1, 8.4), (0.8, 8.8), (0.2, 8.8)],
        [(2.0, 2.0), (1.9, 1.4), (2.3, 1.2), (2.8, 1.3), (3.0, 1.7), (2.6, 2.1)],
        [(11.9, 1.0), (11.9, 1.8), (11.1, 1.7), (11.1, 0.9)],
        [(6.6, 8.2), (6.9, 9.0), (6.2, 9.2), (5.9, 8.6)],
        [(10.2, 7.3), (10.6, 7.6), (10.3, 7.9), (10.0, 7.7)],
        [(11.6, 7.1), (11.3, 7.0), (11.3, 6.7), (11.4, 6.4), (11.7, 6.5), (11.9, 6.7), (11.9, 7.0)],
        [(3.1, 6.1), (3.1, 5.8), (3.3, 5.6), (3.5, 5.8), (3.7, 6.0), (3.5, 6.2), (3.3, 6.2)],
        [(4.7, 7.4), (5.1, 7.4), (5.2, 7.7), (5.0, 7.9), (4.7, 8.0), (4.5, 7.6)],
        [(7.9, 0.5), (8.0, 0.7), (7.9, 0.9), (7.7, 1.0), (7.5, 0.8), (7.5, 0.5), (7.7, 0.4)],
        [(1.4, 6.5), (1.2, 6.8), (0.9, 6.8), (0.8, 6.6), (0.8, 6.3), (1.0, 6.2), (1.2, 6.3)],
        [(0.1, 0.6), (0.0, 0.3), (0.0, 0.0), (0.3, 0.0), (0.6, 0.2), (0.5, 0.6)],
        [(0.8, 2.3), (1.2, 2.1), (1.3, 2.6), (0.9, 2.6)],
        [(4.0, 0.1), (4.2, 0.4), (4.0, 0.7), (3.7, 0.6), (3.6, 0.2)],
        [(11.3, 8.2), (11.7, 7.8), (12.0, 8.2), (11.7, 8.6)],
        [(5.8, 3.1), (5.7, 3.3), (5.5, 3.5), (5.3, 3.4), (5.3, 3.1), (5.5, 3.0)],
    ]
    return Environment(12.0, 9.6, '1.1,1.1,1.5708', '10.65,8.75,3.1416', rubble)


ENVIRONMENTS = {'env1': env1, 'env2': env2, 'env3': env3, 'env4': env4}


def write(folder, name, environment):
    rows = environment.rows()
    header = f'P5\n{len(rows[0])} {len(rows)}\n255\n'.encode()
    (folder / f'{name}.pgm').write_bytes(header + b''.join(bytes(row) for row in rows))
    (folder / f'{name}.yaml').write_text(
        f'image: {name}.pgm\nresolution: {RESOLUTION}\norigin: [0.0, 0.0, 0.0]\nnegate: 0\n'
        'occupied_thresh: 0.65\nfree_thresh: 0.196\n')


def main():
    here = pathlib.Path(__file__).resolve().parent
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else here.parent / 'config'
    lines = ['id;map;start;goal']
    for name, draw in ENVIRONMENTS.items():
        environment = draw()
        write(folder, name, environment)
        lines.append(f'{name};{name}.yaml;{environment.start};{environment.goal}')
    (folder / 'environments.csv').write_text('\n'.join(lines) + '\n')


if __name__ == '__main__':
    main()
