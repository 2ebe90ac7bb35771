#include "smMeshPicture.h"

#include "smMeshMeasures.h"

#include <vtkNew.h>
#include <vtkPNGWriter.h>

#include <numeric>

namespace smtest
{
namespace
{
using sm::Vector3;

/// Part of a tile that is left free on every side.
constexpr double Margin = 0.03;
constexpr std::size_t FacesInRow = 2;
/// A mean normal shorter than this part of the area has no face to look at.
constexpr double MinMean = 0.2;

/// Axes of the picture: right, up, towards the eye.
struct View
{
  Vector3 Axes[3];
  double Low[2] = { 1e300, 1e300 };
  double High[2] = { -1e300, -1e300 };

  explicit View(const sm::FaceMesh& mesh)
  {
    Vector3 mean{ 0.0, 0.0, 0.0 };
    double area = 0.0;
    for (const auto& t : mesh.Triangles)
    {
      const Vector3 n = sm::Cross(sm::Subtract(mesh.Points[t[1]], mesh.Points[t[0]]),
        sm::Subtract(mesh.Points[t[2]], mesh.Points[t[0]]));
      area += sm::Norm(n);
      for (int d = 0; d < 3; ++d)
      {
        mean[d] += n[d];
      }
    }
    this->Axes[2] =
      sm::Normalized(area > 0.0 && sm::Norm(mean) > MinMean * area ? mean : Vector3{ 1.0, 0.7, 0.5 });
    const Vector3& eye = this->Axes[2];
    this->Axes[0] = sm::Normalized(
      std::abs(eye[2]) < 0.9 ? Vector3{ -eye[1], eye[0], 0.0 } : Vector3{ eye[2], 0.0, -eye[0] });
    this->Axes[1] = sm::Cross(eye, this->Axes[0]);
  }
  void Include(const sm::FaceMesh& mesh)
  {
    for (const Vector3& p : mesh.Points)
    {
      for (int d = 0; d < 2; ++d)
      {
        this->Low[d] = std::min(this->Low[d], sm::Dot(p, this->Axes[d]));
        this->High[d] = std::max(this->High[d], sm::Dot(p, this->Axes[d]));
      }
    }
  }
  /// Returns the pixel of p in direction d, in a tile of `tile` pixels. Each direction has a scale of its own
  /// where the face is much longer than wide.
  int GetPixel(const Vector3& p, int d, int tile) const
  {
    const double sizes[2] = { this->High[0] - this->Low[0], this->High[1] - this->Low[1] };
    const double size = std::max(sizes[d], 0.1 * sizes[1 - d]);
    const double x = sm::Dot(p, this->Axes[d]) - this->Low[d];
    return static_cast<int>(std::lround(tile * (Margin + (1.0 - 2.0 * Margin) * x / std::max(size, 1e-300))));
  }
};

using Color = std::array<unsigned char, 3>;
using Pixel = std::array<int, 2>;

void SetPixel(vtkImageData* image, const Pixel& p, const Color& color)
{
  std::copy(color.begin(), color.end(), static_cast<unsigned char*>(image->GetScalarPointer(p[0], p[1], 0)));
}

void FillTriangle(vtkImageData* image, const Pixel (&t)[3], const Color& color)
{
  const auto side = [](const Pixel& a, const Pixel& b, const Pixel& p)
  { return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]); };
  for (int y = std::min({ t[0][1], t[1][1], t[2][1] }); y <= std::max({ t[0][1], t[1][1], t[2][1] }); ++y)
  {
    for (int x = std::min({ t[0][0], t[1][0], t[2][0] }); x <= std::max({ t[0][0], t[1][0], t[2][0] }); ++x)
    {
      const int a = side(t[0], t[1], { x, y });
      const int b = side(t[1], t[2], { x, y });
      const int c = side(t[2], t[0], { x, y });
      if (std::min({ a, b, c }) >= 0 || std::max({ a, b, c }) <= 0)
      {
        SetPixel(image, { x, y }, color);
      }
    }
  }
}

void DrawLine(vtkImageData* image, const Pixel& a, const Pixel& b, const Color& color)
{
  const int steps = std::max({ std::abs(b[0] - a[0]), std::abs(b[1] - a[1]), 1 });
  for (int i = 0; i <= steps; ++i)
  {
    SetPixel(image, { a[0] + (b[0] - a[0]) * i / steps, a[1] + (b[1] - a[1]) * i / steps }, color);
  }
}

void Draw(
  const sm::Face& face, const sm::FaceMesh& mesh, const View& view, int left, int tile, vtkImageData* image)
{
  // From the farthest triangle to the nearest.
  std::vector<double> depth;
  for (const auto& t : mesh.Triangles)
  {
    depth.push_back(sm::Dot(mesh.Points[t[0]], view.Axes[2]) + sm::Dot(mesh.Points[t[1]], view.Axes[2]) +
      sm::Dot(mesh.Points[t[2]], view.Axes[2]));
  }
  std::vector<std::size_t> order(depth.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return depth[a] < depth[b]; });
  sm::NURBSSurface::Walker walker(face.Surface);
  for (const std::size_t i : order)
  {
    const auto& t = mesh.Triangles[i];
    Pixel corners[3];
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = { left + view.GetPixel(mesh.Points[t[k]], 0, tile),
        view.GetPixel(mesh.Points[t[k]], 1, tile) };
    }
    const bool inverted = IsInverted(face, walker, mesh, t);
    FillTriangle(image, corners, inverted ? Color{ 240, 90, 80 } : Color{ 190, 210, 230 });
    for (int k = 0; k < 3; ++k)
    {
      DrawLine(image, corners[k], corners[(k + 1) % 3], inverted ? Color{ 200, 0, 0 } : Color{ 30, 40, 60 });
    }
  }
}

vtkSmartPointer<vtkImageData> MakeImage(int width, int height)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 3 * width * height, 255);
  return image;
}
}

void MeshSheet::Add(const sm::Face& face, const std::vector<const sm::FaceMesh*>& meshes)
{
  View view(*meshes.back());
  for (const sm::FaceMesh* mesh : meshes)
  {
    view.Include(*mesh);
  }
  this->Faces.push_back(MakeImage(this->Tile * static_cast<int>(meshes.size()), this->Tile));
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    Draw(face, *meshes[i], view, this->Tile * static_cast<int>(i), this->Tile, this->Faces.back());
  }
}

bool MeshSheet::Write(const std::string& fileName) const
{
  if (this->Faces.empty())
  {
    return false;
  }
  const std::size_t columns = std::min(FacesInRow, this->Faces.size());
  const std::size_t rows = (this->Faces.size() + columns - 1) / columns;
  const int width = this->Faces[0]->GetDimensions()[0];
  const auto sheet = MakeImage(width * static_cast<int>(columns), this->Tile * static_cast<int>(rows));
  for (std::size_t i = 0; i < this->Faces.size(); ++i)
  {
    // Rows of an image run from the bottom.
    const int left = width * static_cast<int>(i % columns);
    const int bottom = this->Tile * static_cast<int>(rows - 1 - i / columns);
    for (int y = 0; y < this->Tile; ++y)
    {
      const auto* from = static_cast<const unsigned char*>(this->Faces[i]->GetScalarPointer(0, y, 0));
      std::copy(
        from, from + 3 * width, static_cast<unsigned char*>(sheet->GetScalarPointer(left, bottom + y, 0)));
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(fileName.c_str());
  writer->SetInputData(sheet);
  writer->SetCompressionLevel(9);
  writer->Write();
  return writer->GetErrorCode() == 0;
}
}
