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


# A maze: narrow corridors and multiple turns. The way that a car can take is the longer one; the two doors of a short
# cut face each other so closely that only a robot that moves sideways gets through.
def env1():
    t = 0.2  # thickness of a wall
    walls = [
        box(0, 2.0, 12.2, 2.0 + t),
        box(2.0, 4.0, 14, 4.0 + t),
        box(0, 6.0, 12.2, 6.0 + t),
        box(2.0, 8.0, 14, 8.0 + t),
    ]
    return Environment(14.0, 10.0, '1.1,1.1,0', '12.5,9.1,0', walls)


# A car park: stalls along the walls and an island of parked cars; the goal is a stall, to be entered backward.
def env2():
    def stall(x, y):
        """A parked car that fills its stall, head or tail to the wall."""
        return box(x - 0.35, y - 0.55, x + 0.35, y + 0.55)

    taken_below = [1.0, 2.2, 3.4, 4.6, 5.8, 7.0, 9.4, 10.6, 11.8, 13.0]
    taken_above = [3.4, 4.6, 5.8, 8.2, 9.4, 11.8]
    island = [3.4, 4.6, 5.8, 7.0, 8.2, 9.4, 10.6]
    cars = [stall(x, 0.95) for x in taken_below] + [stall(x, 8.05) for x in taken_above]
    cars += [stall(x, 4.5) for x in island]
    return Environment(14.0, 9.0, '1.2,7.6,0', '8.2,1.0,1.5708', cars)


# Lateral transfer: two bays and between them a passage hardly longer than the robot, which arrives and leaves facing
# across it.
def env3():
    below = [(2.2, 0), (6.2, 0), (6.2, 2.2), (5.2, 2.2), (4.2, 1.4), (2.2, 1.4)]
    above = [(2.2, 2.9), (4.2, 2.9), (5.2, 3.7), (6.2, 3.7), (6.2, 5.0), (2.2, 5.0)]
    return Environment(8.4, 5.0, '1.2,1.0,1.5708', '7.2,3.6,1.5708', [below, above])


# Irregular dense obstacles.
def env4():
    rubble = [
        [(2.2, 1.6), (2.9, 1.3), (3.2, 1.9), (2.6, 2.5)],
        [(4.4, 0.7), (5.0, 0.5), (5.3, 1.2), (4.7, 1.5)],
        [(0.9, 3.1), (1.5, 2.9), (1.8, 3.6), (1.2, 3.9)],
        [(3.7, 2.9), (4.5, 2.6), (4.9, 3.3), (4.1, 3.8)],
        [(6.2, 2.0), (7.1, 1.8), (7.0, 2.6), (6.4, 2.9)],
        [(8.2, 0.9), (8.9, 0.7), (9.2, 1.4), (8.5, 1.6)],
        [(2.4, 4.7), (3.1, 4.4), (3.3, 5.3), (2.5, 5.5)],
        [(5.3, 4.5), (6.2, 4.2), (6.4, 4.9), (5.7, 5.3)],
        [(7.9, 3.6), (8.6, 3.3), (9.0, 4.1), (8.2, 4.5)],
        [(10.0, 2.4), (10.6, 2.2), (10.9, 3.0), (10.2, 3.2)],
        [(1.0, 6.0), (1.7, 5.9), (1.6, 6.8), (1.0, 6.7)],
        [(4.0, 6.2), (4.8, 6.0), (5.0, 6.9), (4.2, 7.1)],
        [(6.8, 6.0), (7.6, 5.7), (7.8, 6.4), (7.0, 6.8)],
        [(9.4, 5.1), (10.2, 4.9), (10.4, 5.7), (9.6, 6.0)],
        [(2.4, 7.9), (3.2, 7.7), (3.3, 8.4), (2.6, 8.6)],
        [(5.6, 8.0), (6.4, 7.8), (6.6, 8.6), (5.8, 8.7)],
        [(8.4, 7.4), (9.2, 7.2), (9.3, 8.0), (8.6, 8.2)],
        [(10.5, 6.9), (11.1, 6.8), (11.0, 7.5), (10.6, 7.6)],
    ]
    return Environment(12.0, 9.6, '1.0,1.0,0', '10.9,8.7,1.5708', rubble)


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
