# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""clang-tidy over the modules' sources, each of them or, in a unity build, each of its units, as a build compiles them.

    clang_tidy.py CLANG_TIDY BUILD_FOLDER SOURCE_FOLDER

What has passed is not checked again before it, a header beside it or one of the core changes."""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys


def sources_of(unit):
    """The sources of a unit of a unity build; a source is its own."""
    if unit.parent.name != "Unity":
        return [unit]
    return [pathlib.Path(name) for name in re.findall(r'#include "([^"]+\.cxx)"', unit.read_text())]


def command_without_precompiled(entry):
    """GCC's precompiled headers are not Clang's."""
    return dict(entry, command=re.sub(r" -Winvalid-pch -include \S*cmake_pch\.hxx", "", entry["command"]))


def key_of(sources, folder, common):
    """Near enough to what they include: the headers beside them, and those of the core."""
    digest = hashlib.sha256(common)
    beside = sorted({header for source in sources for header in source.parent.glob("*.h")})
    for file in [*sources, *beside, *sorted((folder / "Filters/Core").glob("*.h"))]:
        digest.update(str(file.relative_to(folder)).encode() + file.read_bytes())
    return digest.hexdigest()


def main(program, build, folder):
    build, folder = pathlib.Path(build), pathlib.Path(folder).resolve()
    own = build / "Testing/Style"
    stamps = own / "stamps"
    stamps.mkdir(parents=True, exist_ok=True)
    commands = [command_without_precompiled(entry) for entry in json.loads((build / "compile_commands.json").read_text())]
    (own / "compile_commands.json").write_text(json.dumps(commands))
    common = (folder / ".clang-tidy").read_bytes()

    def check(unit):
        sources = sources_of(unit)
        stamp = stamps / key_of(sources, folder, common)
        if stamp.exists():
            return True
        # A unit has its sources by #include; these are headers to clang-tidy.
        result = subprocess.run(
            [program, "-p", own, "--quiet", "--checks=-bugprone-suspicious-include",
             r"--header-filter=/(Filters|Rendering)/.*\.(h|cxx)$",
             "--extra-arg=-Wno-unknown-warning-option", unit],  # the options are GCC's
            capture_output=True, text=True, timeout=1200)
        print(result.stdout, end="", flush=True)
        if result.returncode != 0:
            print(f"clang-tidy: {', '.join(source.name for source in sources)}\n{result.stderr}", flush=True)
            return False
        stamp.touch()
        return True

    def is_module(source):
        return source.is_relative_to(folder) and source.relative_to(folder).parts[0] in ("Filters", "Rendering")

    units = {pathlib.Path(entry["directory"], entry["file"]).resolve() for entry in commands}
    units = sorted(unit for unit in units if any(map(is_module, sources_of(unit))))
    assert units, "no source of a module is built here"
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        passed = list(pool.map(check, units))
    print(f"clang-tidy: {passed.count(True)} of {len(units)} passed")
    return 0 if all(passed) else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
