"""MeshPictures.py --program SweepMeshes --solids FOLDER --output FILE.png: ten faces of exact solids that are difficult to mesh, OpenCASCADE's
triangles on the left and ours on the right, all within 4e-3 of the diagonal of their solid. Prints a row for each."""
import argparse
import os
import subprocess

import matplotlib

matplotlib.use("Agg")
import numpy  # noqa: E402
from matplotlib import pyplot  # noqa: E402
from matplotlib.collections import PolyCollection  # noqa: E402
from PIL import Image  # noqa: E402

FACES = [
    ("bicylinder", 17, "a cylinder between two curves that meet in points"),
    ("slanted_hole", 456, "a hole with slanted ends and a seam"),
    ("sphere", None, "one face with a seam and two poles"),
    ("cone", 17, "a cone of one face, wide parameters at one end"),
    ("torus", None, "closed in both directions, two seams"),
    ("airfoil", 17, "160 spans of degree 3, most of them at the nose"),
    ("spline_ring", None, "a rational ring of 96 spans"),
    ("graph_20_2", 604, "degree 20"),
    ("moebius_1000", 377, "weights from 1 to 1000"),
    ("offset_strip", 371, "an offset surface that is fitted"),
]


COLUMNS = 4


def choose_axes(triangles):
    """Right, up and towards the eye: against the mean normal of the triangles, or askew where the face closes in itself."""
    normals = numpy.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    mean, area = normals.sum(axis=0), numpy.linalg.norm(normals, axis=1).sum()
    eye = mean if numpy.linalg.norm(mean) > 0.2 * area else numpy.array([1.0, 0.7, 0.5])
    eye = eye / numpy.linalg.norm(eye)
    right = numpy.array([-eye[1], eye[0], 0.0] if abs(eye[2]) < 0.9 else [eye[2], 0.0, -eye[0]])
    right /= numpy.linalg.norm(right)
    return numpy.array([right, numpy.cross(eye, right), eye])


def draw_tiles(tiles, meshes):
    """Draws meshes of one face, rows of inverted and corners, as seen against the last one; triangles that are inverted are red."""
    axes = choose_axes(meshes[-1][:, 1:].reshape(-1, 3, 3))
    seen = [mesh[:, 1:].reshape(-1, 3, 3) @ axes.T for mesh in meshes]
    points = numpy.concatenate([corners.reshape(-1, 3) for corners in seen])[:, :2]
    low, sizes = points.min(axis=0), numpy.ptp(points, axis=0)
    # Each direction has a scale of its own, except where the face is much longer than wide.
    margin = 0.03 * numpy.maximum(sizes, 0.1 * sizes[::-1])
    high = low + numpy.maximum(sizes, 0.1 * sizes[::-1])
    for tile, mesh, corners in zip(tiles, meshes, seen):
        order = numpy.argsort(corners[:, :, 2].sum(axis=1))  # from the farthest triangle to the nearest
        inverted = mesh[order, 0] > 0
        tile.add_collection(PolyCollection(corners[order, :, :2], linewidths=0.4,
                                           facecolors=numpy.where(inverted, "#f05a50", "#bed2e6"),
                                           edgecolors=numpy.where(inverted, "#c80000", "#1e283c")))
        tile.set_xlim(low[0] - margin[0], high[0] + margin[0])
        tile.set_ylim(low[1] - margin[1], high[1] + margin[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True)
    parser.add_argument("--solids", required=True)
    parser.add_argument("--output", required=True)
    options = parser.parse_args()
    figure, tiles = pyplot.subplots(2 * len(FACES) // COLUMNS, COLUMNS, figsize=(9.2, 11.5), layout="tight")
    table = options.output + ".csv"
    for i, (name, face, reason) in enumerate(FACES):
        subprocess.run([options.program, "--deflection", "4e-3", "--triangles", table, os.path.join(options.solids, name + "-plain.step")],
                       check=True, stdout=subprocess.DEVNULL)
        rows = numpy.genfromtxt(table, delimiter=",", skip_header=1)
        # Solids of one face: the file's numbers do not matter.
        face = face or int(rows[0, 0])
        theirs, ours = (rows[(rows[:, 0] == face) & (rows[:, 1] == is_ours), 2:] for is_ours in (0, 1))
        draw_tiles(tiles.flat[2 * i:2 * i + 2], [theirs, ours])
        print(f"{name} #{face}: {reason}: {len(theirs)} triangles of OpenCASCADE, {len(ours)} of ours")
    for tile in tiles.flat:
        tile.set_axis_off()
    figure.canvas.draw()
    # 32 colours: a quarter of the bytes.
    Image.fromarray(numpy.asarray(figure.canvas.buffer_rgba())[:, :, :3]).quantize(32).save(options.output, optimize=True)
    os.remove(table)


main()
