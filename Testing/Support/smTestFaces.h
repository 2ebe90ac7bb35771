/**
 * @file smTestFaces.h
 * @brief Faces for tests that need no file
 */
#ifndef smTestFaces_h
#define smTestFaces_h

#include "smFace.h"

#include <memory>

namespace smtest
{
/// An untrimmed bilinear square of the given side, cut into cells x cells.
inline sm::FacePointer MakeSquare(double side, int cells)
{
  auto face = std::make_shared<sm::Face>();
  face->Id = sm::NewId();
  face->FileId = static_cast<int>(side);
  for (int d = 0; d < 2; ++d)
  {
    face->Surface.Degree[d] = 1;
    face->Surface.NumberOfControlPoints[d] = cells + 1;
    face->Surface.Knots[d].push_back(0.0);
    for (int i = 0; i <= cells; ++i)
    {
      face->Surface.Knots[d].push_back(i);
    }
    face->Surface.Knots[d].push_back(cells);
  }
  for (int j = 0; j <= cells; ++j)
  {
    for (int i = 0; i <= cells; ++i)
    {
      face->Surface.ControlPoints.push_back({ side * i / cells, side * j / cells, 0.0, 1.0 });
    }
  }
  return face;
}
}

#endif
