"""Volume, area, first and second moments of a solid as intervals; centre of mass and inertia that follow from them."""
from fractions import Fraction

from intervals import Interval, as_interval
from part21 import Frame

AXES = range(3)


class Moments:
    """first[i] and second[i][j] are the integrals of x_i and x_i x_j over the volume."""

    def __init__(self, volume, area, first, second):
        self.volume, self.area = as_interval(volume), as_interval(area)
        self.first = [as_interval(x) for x in first]
        self.second = [[as_interval(x) for x in row] for row in second]

    def combine(self, other, sign=1):
        """Adds a separate solid or, with the sign -1, a hole of that shape. Areas are added in either case."""
        return Moments(self.volume + sign * other.volume, self.area + other.area,
                       [a + sign * b for a, b in zip(self.first, other.first)],
                       [[a + sign * b for a, b in zip(*rows)] for rows in zip(self.second, other.second)])

    def place(self, frame):
        """Returns the moments of the solid after the scale, rotation and translation of a frame."""
        s, turn, shift = frame.size, frame.turn, frame.shift
        first = [s ** 4 * sum(turn[i][k] * self.first[k] for k in AXES) for i in AXES]
        second = [[s ** 5 * sum(turn[i][k] * turn[j][l] * self.second[k][l] for k in AXES for l in AXES)
                   for j in AXES] for i in AXES]
        volume = s ** 3 * self.volume
        return Moments(volume, s ** 2 * self.area, [first[i] + shift[i] * volume for i in AXES],
                       [[second[i][j] + shift[i] * first[j] + shift[j] * first[i] + shift[i] * shift[j] * volume
                         for j in AXES] for i in AXES])

    def shift(self, by):
        return self.place(Frame(1, shift=by))

    def get_center(self):
        return [x / self.volume for x in self.first]

    def get_inertia(self):
        """Returns the inertia about the centre of mass, for density 1, along the axes of the file, with negative products off the
        diagonal."""
        center = self.get_center()
        central = [[self.second[i][j] - center[i] * self.first[j] for j in AXES] for i in AXES]
        trace = sum(central[i][i] for i in AXES)
        return [[(trace if i == j else Interval(0)) - central[i][j] for j in AXES] for i in AXES]

    def widened(self, relative):
        """Widens the intervals by a fraction of each quantity's scale, for files with rounded numbers."""
        v, a = relative * self.volume.hi, relative * self.area.hi
        size = max(abs(x.hi) + abs(x.lo) for x in self.first) / self.volume.lo + self.area.sqrt().hi
        square = max(self.second[i][i].hi for i in AXES)
        return Moments(self.volume.widened(v), self.area.widened(a), [x.widened(v * size) for x in self.first],
                       [[x.widened(relative * square) for x in row] for row in self.second])


def make_prism_moments(plane, height, area):
    """Moments of a prism along z, from 0 to `height`, over a region. plane(a, b): the integral of x^a y^b over the region."""
    h, m = Fraction(height), plane
    xx, yy, xy, zz = h * m(2, 0), h * m(0, 2), h * m(1, 1), h ** 3 / 3 * m(0, 0)
    xz, yz = h ** 2 / 2 * m(1, 0), h ** 2 / 2 * m(0, 1)
    return Moments(h * m(0, 0), area, [h * m(1, 0), h * m(0, 1), h ** 2 / 2 * m(0, 0)],
                   [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
