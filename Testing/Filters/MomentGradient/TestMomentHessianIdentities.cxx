// TestMomentHessianIdentities FILE.step...: identities of the Hessian times a direction on exact solids, each
// entry within the bounds:
//
//     H P = (2 + degree of g) grad M_g, as the gradient is homogeneous in P; for a translation e: H e = 0 for
//     V, e_x grad V for M_x, 2 e_x grad M_x for S_xx; and u . H v = v . H u for tied directions where all
//     faces have tied borders.
// Each entry at a loose tolerance is compared with that at a tight one, too.
#include "smComputeMassProperties.h"
#include "smHessianSums.h"
#include "smTestPipeline.h"

#include <cstdlib>
#include <random>

namespace
{
using namespace smtest;
using NetDirections = std::vector<sm::NetDirection>;
using Vector = std::array<double, 3>;

constexpr int Degrees[10] = { 0, 1, 1, 1, 2, 2, 2, 2, 2, 2 };
int symmetricSolids = 0;
int otherSolids = 0;

sm::MomentHessianResult ApplyHessian(
  vtkDataObject* model, const NetDirections& v, bool tied, double tolerance = 1e-9)
{
  sm::MomentHessianOptions options;
  options.Tied = tied;
  options.RelativeTolerance = tolerance;
  return sm::ComputeMomentHessianProduct(model, v, options);
}

/// The largest ratio of a difference to its bound.
struct WorstEntry
{
  double Ratio = 0.0;
  double Bound = 0.0;
  std::size_t Entries = 0;
  bool IsNumber = true;

  void Add(double difference, double bound)
  {
    this->IsNumber = this->IsNumber && std::isfinite(difference) && std::isfinite(bound);
    this->Ratio = std::max(this->Ratio, difference == 0.0 ? 0.0 : std::abs(difference) / bound);
    this->Bound = std::max(this->Bound, bound);
    ++this->Entries;
  }
  bool Holds() const { return this->IsNumber && this->Ratio <= 1.0 && this->Entries > 0; }
};

/// Compares each entry with factor(q) times the gradient of quantity of(q); none: with 0.
template <class Compared>
WorstEntry Compare(
  const sm::MomentHessianResult& product, const sm::MomentGradientResult& gradient, const Compared& compared)
{
  WorstEntry worst;
  for (std::size_t f = 0; f < product.Faces.size(); ++f)
  {
    const sm::FaceHessianProduct& face = product.Faces[f];
    const sm::FaceMomentGradient& first = gradient.Faces[f];
    for (int i = 0; i < face.Count[0]; ++i)
    {
      for (int j = 0; j < face.Count[1]; ++j)
      {
        for (int k = 0; k < 30; ++k)
        {
          const std::size_t at = face.GetIndex(i, j, k / 10, k % 10);
          double value = 0.0;
          double bound = face.Bounds[at] + 4e-16 * std::abs(face.Values[at]);
          for (const auto& [factor, quantity] : compared(k % 10))
          {
            const std::size_t place = first.GetIndex(i, j, k / 10, quantity);
            value += factor * first.Values[place];
            // The points of the direction are rounded.
            bound += std::abs(factor) * (first.Bounds[place] + 1e-15 * std::abs(first.Values[place]));
          }
          worst.Add(face.Values[at] - value, bound);
        }
      }
    }
  }
  return worst;
}

using Terms = std::vector<std::pair<double, int>>;

/// What a translation adds to the gradient of moment q.
Terms GetTranslated(const Vector& e, int q)
{
  const int pairs[6][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 0, 1 }, { 1, 2 }, { 0, 2 } };
  if (q == 0)
  {
    return {};
  }
  if (q < 4)
  {
    return { { e[q - 1], 0 } };
  }
  const int a = pairs[q - 4][0];
  const int b = pairs[q - 4][1];
  return { { e[a], 1 + b }, { e[b], 1 + a } };
}

void CheckSymmetry(vtkDataObject* model, const sm::MomentGradientResult& tied)
{
  std::mt19937 random(5);
  std::map<std::int64_t, Vector> moves[2];
  NetDirections directions[2];
  for (int k = 0; k < 2; ++k)
  {
    for (const sm::FaceMomentGradient& face : tied.Faces)
    {
      sm::NetDirection net;
      net.Solid = face.Solid;
      net.Face = face.Face;
      for (const std::int64_t variable : face.PointVariables)
      {
        Vector& by = moves[k][variable];
        for (double& c : by)
        {
          c = c == 0.0 ? static_cast<double>(random() % 2000) / 1000.0 - 1.0003 : c;
        }
        net.Displacements.push_back(by);
      }
      directions[k].push_back(net);
    }
  }
  const sm::MomentHessianResult products[2] = { ApplyHessian(model, directions[0], true),
    ApplyHessian(model, directions[1], true) };
  if (products[0].Faces.empty() || products[1].Faces.empty())
  {
    CheckTrue("products", false, products[0].Reason);
    return;
  }
  bool isHessian = true;
  for (const sm::FaceHessianProduct& face : products[0].Faces)
  {
    isHessian = isHessian && face.HasTiedBorder;
  }
  double worst = 0.0;
  double asymmetry = 0.0;
  for (int q = 0; q < 10; ++q)
  {
    const GradientSum a = smtest::Multiply(tied, directions[1], products[0], q);
    const GradientSum b = smtest::Multiply(tied, directions[0], products[1], q);
    const double difference = std::abs(static_cast<double>(a.Value - b.Value));
    worst = std::max(worst, difference / (a.Bound + b.Bound));
    asymmetry = std::max(asymmetry, difference / std::max(std::abs(static_cast<double>(a.Value)), a.Bound));
  }
  std::printf("     borders %s: u . H v and v . H u differ by up to %.1e of the value, %.1e of the bounds\n",
    isHessian ? "are tied" : "are not all tied", asymmetry, worst);
  if (isHessian)
  {
    CheckTrue("symmetric", worst <= 1.0);
    ++symmetricSolids;
  }
  else
  {
    ++otherSolids;
  }
}

void CheckHessianFile(const std::string& path)
{
  std::printf("--- %s\n", path.c_str());
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(path.c_str());
  UseCoarseMesh(reader);
  reader->Update();
  vtkDataObject* model = reader->GetOutputDataObject(0);
  sm::MomentGradientOptions options;
  options.Tied = false;
  const sm::MomentGradientResult gradient = sm::ComputeMomentGradient(model, options);
  options.Tied = true;
  const sm::MomentGradientResult tied = sm::ComputeMomentGradient(model, options);
  if (gradient.Status != "ok")
  {
    std::printf("     %s, left out: %s\n", gradient.Status.c_str(), gradient.Reason.c_str());
    return;
  }
  const NetDirections grow = MakeDirection(gradient,
    [](const auto&, const auto& p) {
      return Vector{ p[0], p[1], p[2] };
    });
  const sm::MomentHessianResult grown = ApplyHessian(model, grow, false);
  const WorstEntry euler = Compare(grown, gradient, [](int q) { return Terms{ { 2.0 + Degrees[q], q } }; });
  const Vector e{ 0.7, -1.3, 0.4 };
  const sm::MomentHessianResult moved =
    ApplyHessian(model, MakeDirection(gradient, [&](const auto&, const auto&) { return e; }), false);
  const WorstEntry translation = Compare(moved, gradient, [&](int q) { return GetTranslated(e, q); });
  std::printf("     %zu entries: H P to %.1e of the bounds, largest %.1e; H e to %.1e, largest %.1e\n",
    euler.Entries, euler.Ratio, euler.Bound, translation.Ratio, translation.Bound);
  CheckTrue("H P = (2 + degree) grad", euler.Holds(), grown.Reason);
  CheckTrue("translation", translation.Holds(), moved.Reason);
  CheckSymmetry(model, tied);

  // At a loose tolerance the error of the quadrature is most of it.
  const sm::MomentHessianResult tight = ApplyHessian(model, grow, false, 1e-13);
  for (const double tolerance : { 1e-1, 1e-4 })
  {
    const sm::MomentHessianResult loose = ApplyHessian(model, grow, false, tolerance);
    WorstEntry worst;
    for (std::size_t f = 0; f < loose.Faces.size(); ++f)
    {
      for (std::size_t k = 0; k < loose.Faces[f].Values.size(); ++k)
      {
        worst.Add(loose.Faces[f].Values[k] - tight.Faces[f].Values[k],
          loose.Faces[f].Bounds[k] + tight.Faces[f].Bounds[k]);
      }
    }
    std::printf("     tolerance %.0e: entries differ by up to %.1e of the bounds\n", tolerance, worst.Ratio);
    CheckTrue("entries within their bounds", worst.Holds());
  }
}
}

int TestMomentHessianIdentities(int argc, char* argv[])
{
  RequireUsage(argc > 1, "TestMomentHessianIdentities FILE.step...");
  for (int k = 1; k < argc; ++k)
  {
    CheckHessianFile(argv[k]);
  }
  std::printf("     %d solids with tied borders, %d others\n", symmetricSolids, otherSolids);
  CheckRange("symmetric solids", 1, symmetricSolids, 1e9);
  return Finish();
}
