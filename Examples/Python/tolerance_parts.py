"""tolerance_parts.py FILE.step [--parts N] [--sigma S] [--png FILE]: a million parts whose faces are off by chance.

Every one of the largest faces moves along its normal by a random offset (normal distribution, sigma in the file's unit). Prints mean and standard
deviation of the volume, and of the centre's x, by Monte Carlo and by the linear prediction, and draws the histogram of the volumes.
"""
import argparse
import sys
import time

import numpy
import solidmoments
from solidmoments.smReadersSTEP import vtkSTEPReader

MAXIMUM_DIRECTIONS = 10


def read_model(path):
    """The vtkTrimmedNURBSModel of the only solid of a file."""
    reader = vtkSTEPReader()
    reader.SetFileName(path)
    reader.Update()
    parts = reader.GetOutputDataObject(0)
    if not parts or parts.GetNumberOfPartitionedDataSets() == 0:
        sys.exit(f"{path} holds no solid")
    if parts.GetNumberOfPartitionedDataSets() > 1:
        sys.exit(f"{path} holds {parts.GetNumberOfPartitionedDataSets()} solids: export one of them")
    return parts.GetPartition(0, 0).GetModel()


def choose_faces(model, sigma):
    """The faces whose offset changes the volume most, and the Variants of all of them."""
    usable, slopes = [], []
    for face in range(model.GetNumberOfFaces()):
        try:
            alone = solidmoments.Variants(model, [face], [5.0 * sigma], method="polynomial")
        except ValueError as error:
            print(f"left out: {error}")
            continue
        usable.append(face)
        slopes.append(abs(alone.evaluate([0.0], bounds=False, gradients=True).gradients[0, 0, 0]))
    order = numpy.argsort(slopes)[::-1][:MAXIMUM_DIRECTIONS]
    return [usable[i] for i in sorted(order)]


def draw(path, volumes, mean, deviation):
    """Histogram as bars, and the linear prediction as a line."""
    import picture
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkChartsCore import vtkChart, vtkChartXY
    from vtkmodules.vtkCommonDataModel import vtkTable
    from vtkmodules.vtkViewsContext2D import vtkContextView
    import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401
    import vtkmodules.vtkRenderingFreeType  # noqa: F401

    counts, edges = numpy.histogram(volumes, 60, (mean - 4.5 * deviation, mean + 4.5 * deviation))
    middles = 0.5 * (edges[1:] + edges[:-1])
    density = numpy.exp(-0.5 * ((middles - mean) / deviation) ** 2) / (deviation * numpy.sqrt(2.0 * numpy.pi))
    table = vtkTable()
    for name, column in (("volume", middles), ("parts", counts.astype(float)), ("linear prediction", density * len(volumes) * (edges[1] - edges[0]))):
        array = numpy_to_vtk(column, deep=True)
        array.SetName(name)
        table.AddColumn(array)
    chart = vtkChartXY()
    chart.SetTitle(f"Volume of {len(volumes)} parts")
    chart.SetShowLegend(True)
    for kind, column, color in ((vtkChart.BAR, 1, (120, 160, 210)), (vtkChart.LINE, 2, (200, 60, 40))):
        plot = chart.AddPlot(kind)
        plot.SetInputData(table, 0, column)
        plot.SetColor(*color, 255)
        plot.SetWidth(2.0)
    chart.GetAxis(1).SetTitle("volume, mm^3")
    chart.GetAxis(0).SetTitle("parts")
    context, window = picture.open_window(path, (640, 420))
    view = vtkContextView()
    view.SetRenderWindow(window)
    view.GetRenderer().SetBackground(1.0, 1.0, 1.0)
    view.GetScene().AddItem(chart)
    picture.save_window(window, path)
    del context


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", metavar="FILE.step")
    parser.add_argument("--parts", type=int, default=1000000, help="number of parts (default: 1000000)")
    parser.add_argument("--sigma", type=float, default=0.02, help="standard deviation of each offset (default: 0.02)")
    parser.add_argument("--png", metavar="FILE", help="draw the histogram")
    options = parser.parse_args()
    if options.parts < 1 or not options.sigma > 0.0:
        parser.error("--parts and --sigma have to be positive")
    model = read_model(options.file)
    faces = choose_faces(model, options.sigma)
    if not faces:
        sys.exit(f"{options.file}: no face can be moved")
    variants = solidmoments.Variants(model, faces, [5.0 * options.sigma] * len(faces), method="polynomial", expected=options.parts)
    print(f"{len(faces)} of {model.GetNumberOfFaces()} faces; {variants.reason}")
    base, bounds, slopes = (part[0] for part in variants.evaluate(numpy.zeros(len(faces)), gradients=True))
    random = numpy.random.default_rng(1)
    volumes, centers, widest, seconds = [], [], 0.0, 0.0
    for begin in range(0, options.parts, 50000):
        c = random.normal(0.0, options.sigma, (min(50000, options.parts - begin), len(faces)))
        start = time.perf_counter()
        some = variants.evaluate(c)
        seconds += time.perf_counter() - start
        volumes.append(some.values[:, 0])
        centers.append(variants.reference[0] + some.values[:, 1] / some.values[:, 0])
        widest = max(widest, some.bounds[:, 0].max())
    volumes, centers = numpy.concatenate(volumes), numpy.concatenate(centers)
    center = base[1] / base[0]
    predicted = ((base[0], slopes[0]), (variants.reference[0] + center, (slopes[1] - center * slopes[0]) / base[0]))
    print(f"{options.parts} parts, {options.parts / seconds:.0f} a second with bounds; widest bound of a volume {widest:.2g} mm^3")
    for name, sample, (mean, slope) in (("volume", volumes, predicted[0]), ("centre x", centers, predicted[1])):
        deviation = options.sigma * numpy.sqrt((slope ** 2).sum())
        print(f"{name}: mean {sample.mean():.12g}, deviation {sample.std():.6g}; linear prediction: {mean:.12g}, {deviation:.6g}")
    if options.png:
        draw(options.png, volumes, base[0], options.sigma * numpy.sqrt((slopes[0] ** 2).sum()))


if __name__ == "__main__":
    main()
