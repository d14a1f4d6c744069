# SPDX-License-Identifier: GPL-3.0-or-later
"""A home of its own for a test program: what it and the programs that it starts keep goes with it, and what its user keeps stays untouched."""
import os
import tempfile

FOLDERS = ("XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME")


def folders(home):
    """Where programs with this home keep what they keep: environment variables and their folders, which need not exist."""
    return {name: os.path.join(home, name) for name in FOLDERS}


def move_in():
    """From now on, for this process and its children. The folder to be kept as long as the home is wanted."""
    home = tempfile.TemporaryDirectory(prefix="motorbench-home-")
    os.environ.update(folders(home.name))
    return home
