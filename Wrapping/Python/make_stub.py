# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the package's stub: the template, with the options' arguments as the package that is built has them.

python3 make_stub.py FOLDER_OF_PACKAGE TEMPLATE STUB
"""
import re
import sys


def main(folder, template, target):
    sys.path.insert(0, folder)
    import stipple
    from stipple._options import stub_parameters

    def parameters(match):
        types = dict(item.split(": ") for item in match[2].split("; "))
        return stub_parameters(getattr(stipple, match[1]), {**types, "progress": "_Progress | None"})

    with open(template, encoding="utf-8") as file:
        text = re.sub(r"^    @(\w+)\((.*)\)@$", parameters, file.read(), flags=re.M)
    with open(target, "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    main(*sys.argv[1:])
