"""TestFlaggedPicture.py --program SOLIDMOMENTS --solids FOLDER --baselines FOLDER --output DIR: the picture of an open solid marks and names
its open edges in red, and that of a sound one has no red."""
import argparse
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import Manifest, check_equal, check_true, finish  # noqa: E402
from smpicture import check_noticed, check_picture, read_picture  # noqa: E402

parser = argparse.ArgumentParser()
for option in ("program", "solids", "baselines", "output"):
    parser.add_argument("--" + option)
options = parser.parse_args()
manifest = Manifest(options.solids)
NAME = "TestFlaggedPicture.png"


def draw(path, name, status):
    picture = os.path.join(options.output, name)
    done = subprocess.run([options.program, "--quiet", "--backend", "cpu", "--png", picture, path], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, universal_newlines=True, check=False)
    check_equal(f"{name}: exit status", status, done.returncode)
    return read_picture(picture)


def find_red(picture):
    red, green, blue = picture[:, :, 0], picture[:, :, 1], picture[:, :, 2]
    return (red > green + 110) & (red > blue + 90)


opened = draw(manifest.special("open_solid")["path"], NAME, 3)
red = find_red(opened)
height = red.shape[0]
# The text is in the uppermost sixth; rows begin at the bottom.
check_true("red pixels of the text", red[5 * height // 6:].sum() > 500, str(red[5 * height // 6:].sum()))
check_true("red pixels of edges", red[:5 * height // 6].sum() > 1000, str(red[:5 * height // 6].sum()))
check_equal("red pixels of a sound box", 0, int(find_red(draw(manifest.solid("box", "plain")["path"], "sound_picture.png", 0)).sum()))
baseline = read_picture(os.path.join(options.baselines, NAME))
check_picture("open solid", baseline, opened)
unmarked = opened.copy()
unmarked[red] = (200, 210, 220)
check_noticed("without the marks", baseline, unmarked)
finish()
