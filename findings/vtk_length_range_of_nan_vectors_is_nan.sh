#!/bin/sh
# VTK 9.1.0 (Debian 12): the range of the lengths of vectors that are all NaN is not the empty range (VTK_DOUBLE_MAX, VTK_DOUBLE_MIN) that their
# components have, but (3.2e149, NaN): the roots of these two. vtkDataWriter then warns of the range that is cached in the array.
# Guess: where no value is known the range is empty, for lengths as for components.
# Seen: components (1e+299, -1e+299), lengths (3.16228e+149, NaN), in GetRange() and GetFiniteRange().
# Needs: apt-get of Debian 12, g++, the C++ library. Installs nothing; fails if the behaviour or the version changes.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=9.1.0+really9.1.0+dfsg2-5+deb12u1
apt-get download -qq "libvtk9-dev=$version" "libvtk9.1=$version" libtbb12=2021.8.0-2+deb12u1 2>/dev/null
for package in *.deb; do
  dpkg -x "$package" root
done
cat >range.cxx <<'END'
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkVersion.h>

#include <cmath>
#include <cstdio>

int main()
{
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(2);
  vectors->Fill(std::nan(""));
  double component[2];
  double length[2];
  double finite[2];
  vectors->GetRange(component, 0);
  vectors->GetRange(length, -1);
  vectors->GetFiniteRange(finite, -1);
  std::printf("VTK %s: two vectors of NaN: range of components (%g, %g), of lengths (%g, %g), of finite lengths (%g, %g)\n",
    vtkVersion::GetVTKVersion(), component[0], component[1], length[0], length[1], finite[0], finite[1]);
  const bool isEmpty = component[0] == VTK_DOUBLE_MAX && component[1] == VTK_DOUBLE_MIN;
  return isEmpty && length[0] < VTK_DOUBLE_MAX && std::isnan(length[1]) && std::isnan(finite[1]) ? 0 : 1;
}
END
libraries=root/usr/lib/x86_64-linux-gnu
g++ -std=c++17 -O1 -I root/usr/include/vtk-9.1 range.cxx -o range -L "$libraries" -lvtkCommonCore-9.1 -lvtksys-9.1 -l:libtbb.so.12 -w -pthread \
  -Wl,-rpath-link,"$libraries"
LD_LIBRARY_PATH=$libraries ./range
