/**
 * @file smPictureTesting.h
 * @brief A picture against its baseline
 *
 * vtkImageDifference sums up what is left of a difference above a threshold, so that a large faint one counts
 * for nothing: with an opacity of 0.4 in place of 0.7 its error is 0. Here pixels are counted.
 */
#ifndef smPictureTesting_h
#define smPictureTesting_h

#include "smTesting.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cstdlib>
#include <string>

namespace smtest
{
/// Colours that differ by no more are the same, of 255: drivers round differently.
constexpr int ColorTolerance = 24;
/// Maximum share of the pixels that may differ. The same driver gives 0.
constexpr double PictureLimit = 3e-4;

/// Returns true when `picture` has the colour that `other` has at (x, y), there or in one of the eight pixels
/// around it.
inline bool HasColorNear(vtkImageData* picture, vtkImageData* other, int x, int y)
{
  const int* size = picture->GetDimensions();
  const auto* wanted = static_cast<unsigned char*>(other->GetScalarPointer(x, y, 0));
  for (int j = std::max(0, y - 1); j <= std::min(size[1] - 1, y + 1); ++j)
  {
    for (int i = std::max(0, x - 1); i <= std::min(size[0] - 1, x + 1); ++i)
    {
      const auto* found = static_cast<unsigned char*>(picture->GetScalarPointer(i, j, 0));
      if (std::abs(found[0] - wanted[0]) <= ColorTolerance &&
        std::abs(found[1] - wanted[1]) <= ColorTolerance && std::abs(found[2] - wanted[2]) <= ColorTolerance)
      {
        return true;
      }
    }
  }
  return false;
}

/// Returns the part, 0 to 1, of the pixels whose colour the other picture has neither there nor at one of the
/// eight neighbours. 1 where the sizes or the types differ: both need unsigned char, red, green and blue
/// first.
inline double ShareOfOtherPixels(vtkImageData* one, vtkImageData* other)
{
  const int* size = one->GetDimensions();
  if (!std::equal(size, size + 3, other->GetDimensions()) || one->GetNumberOfPoints() == 0 ||
    one->GetScalarType() != VTK_UNSIGNED_CHAR || other->GetScalarType() != VTK_UNSIGNED_CHAR ||
    one->GetNumberOfScalarComponents() < 3 || other->GetNumberOfScalarComponents() < 3)
  {
    return 1.0;
  }
  long long count = 0;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      count += !HasColorNear(one, other, x, y) || !HasColorNear(other, one, x, y);
    }
  }
  return static_cast<double>(count) / static_cast<double>(one->GetNumberOfPoints());
}

/// Returns the picture in a PNG file, or an image without points when there is no such file.
inline vtkSmartPointer<vtkImageData> ReadPicture(const std::string& path)
{
  vtkNew<vtkPNGReader> reader;
  if (!reader->CanReadFile(path.c_str()))
  {
    return vtkSmartPointer<vtkImageData>::New();
  }
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

inline void WritePicture(vtkImageData* picture, const std::string& path)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->SetFileName(path.c_str());
  writer->Write();
}
}

#endif
