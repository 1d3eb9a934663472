#!/usr/bin/env python3
"""Runs clang-tidy on the sources in some folders and prints what it finds; exit status 1 then. Wants a configured build/.
    tidy.py FOLDER... [-- ARGUMENT OF CLANG-TIDY...]
A source without findings is not checked again until it, a header of the project that it may include, its command,
.clang-tidy, the arguments or the version of clang-tidy changes. CACHE has an empty file for each that is clean, named after
a hash of all that. Headers of the system are not in the hash: delete CACHE to check again after they have changed."""
import concurrent.futures
import functools
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
CACHE = pathlib.Path(os.environ.get('XDG_CACHE_HOME', pathlib.Path.home() / '.cache'), 'fourwis_navigation', 'tidy')
KEPT = 30 * 86400  # [s] since the last use
INCLUDE = re.compile(rb'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


@functools.lru_cache(maxsize=None)
def read(path):
    """The bytes of a file, and the names that it includes."""
    content = path.read_bytes()
    return content, [name.decode() for name in INCLUDE.findall(content)]


def with_headers(source, folders):
    """A source and all it may include from its own folder or from `folders`, whatever #if says."""
    found, waiting = set(), [source]
    while waiting:
        path = waiting.pop()
        if path not in found:
            found.add(path)
            places = [folder / name for name in read(path)[1] for folder in (path.parent, *folders)]
            waiting += [pathlib.Path(os.path.normpath(place)) for place in places if place.is_file()]
    return sorted(found)


def mark_of(source, command, setup):
    """The file that says that a source is clean. Clones of the project share it, wherever they are."""
    folders = [pathlib.Path(f) for f in re.findall(r'-(?:I|isystem) ?(\S+)', command) if f.startswith(f'{ROOT}/')]
    digest = hashlib.sha256(f'{setup}\n{command}'.replace(str(ROOT), '.').replace(' -Werror', '').encode())
    for path in with_headers(pathlib.Path(source), folders):
        digest.update(f'\n{path.relative_to(ROOT)} {len(read(path)[0])}\n'.encode() + read(path)[0])
    return CACHE / digest.hexdigest()


def main(arguments):
    split = arguments.index('--') if '--' in arguments else len(arguments)
    folders, tidy = tuple(f'{ROOT / a}/' for a in arguments[:split]), ['clang-tidy', *arguments[split + 1:], '--quiet']
    setup = subprocess.check_output([*tidy, '--version'], text=True) + f'{tidy}\n{(ROOT / ".clang-tidy").read_text()}'
    commands = json.loads((ROOT / 'build/compile_commands.json').read_text())
    marks = {c['file']: mark_of(c['file'], c['command'], setup) for c in commands if c['file'].startswith(folders)}
    CACHE.mkdir(parents=True, exist_ok=True)

    def is_clean(source):
        if not marks[source].exists():
            run = subprocess.run([*tidy, '-p', ROOT / 'build', source], capture_output=True, text=True)
            if run.returncode != 0 or run.stdout:
                print(run.stdout or f'{source}: {run.stderr}', end='', flush=True)
                return False
        marks[source].touch()
        return True

    checked, begin = sum(not mark.exists() for mark in marks.values()), time.monotonic()
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        clean = sum(pool.map(is_clean, sorted(marks)))
    print(f'clang-tidy: {clean} of {len(marks)} sources clean, {checked} checked in {time.monotonic() - begin:.0f} s')
    for mark in CACHE.iterdir():
        if mark.stat().st_mtime < time.time() - KEPT:
            mark.unlink()
    return 0 if marks and clean == len(marks) else 1


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
