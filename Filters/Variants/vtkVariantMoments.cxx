#include "vtkVariantMoments.h"

#include "smFailureReason.h"
#include "smVariantIntegrator.h"

#include "vtkCommand.h"
#include "vtkComputeContext.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkTrimmedNURBSModel.h"

#include <exception>
#include <vector>

vtkStandardNewMacro(vtkVariantMoments);

struct vtkVariantMoments::Internals
{
  vtkSmartPointer<vtkTrimmedNURBSModel> Base;
  std::vector<sm::MovedModel> Directions;
  std::vector<double> Ranges;
  std::shared_ptr<const sm::VariantIntegrator> Integrator;
  /// Is kept when the base changes.
  vtkSmartPointer<vtkComputeContext> Context;
};

vtkVariantMoments::vtkVariantMoments()
  : Implementation(std::make_unique<Internals>())
{
}

vtkVariantMoments::~vtkVariantMoments() = default;

void vtkVariantMoments::SetComputeContext(vtkComputeContext* context)
{
  this->Implementation->Context = context;
  this->Modified();
}

bool vtkVariantMoments::Fail(const std::string& reason)
{
  this->Message = reason;
  return reason.empty();
}

void vtkVariantMoments::SetBase(vtkTrimmedNURBSModel* model)
{
  Internals& self = *this->Implementation;
  self.Base = model;
  self.Directions.clear();
  self.Ranges.clear();
  self.Integrator = nullptr;
  this->Modified();
}

int vtkVariantMoments::AddDirection(vtkTrimmedNURBSModel* moved, double amount, double range)
{
  this->Implementation->Directions.push_back({ moved, amount });
  this->Implementation->Ranges.push_back(range);
  this->Implementation->Integrator = nullptr;
  this->Modified();
  return this->GetNumberOfDirections() - 1;
}

int vtkVariantMoments::AddEmptyDirection(double range)
{
  auto copy = vtkSmartPointer<vtkTrimmedNURBSModel>::New();
  if (this->Implementation->Base)
  {
    copy->ShallowCopy(this->Implementation->Base);
  }
  return this->AddDirection(copy, 1.0, range);
}

int vtkVariantMoments::AddNormalOffset(int face, double range)
{
  std::string error;
  const auto moved = sm::MakeNormalOffset(this->Implementation->Base, face, error);
  return this->Fail(error) ? this->AddDirection(moved, 1.0, range) : -1;
}

bool vtkVariantMoments::AddDisplacement(int direction, int face, vtkDataArray* displacements)
{
  if (direction < 0 || direction >= this->GetNumberOfDirections())
  {
    return this->Fail("direction " + std::to_string(direction) + " does not exist: add it first");
  }
  vtkTrimmedNURBSModel* model = this->Implementation->Directions[direction].Model;
  if (!model || face < 0 || face >= model->GetNumberOfFaces())
  {
    return this->Fail("face " + std::to_string(face) + " does not exist: faces are counted from 0");
  }
  auto moved = std::make_shared<sm::Face>(*model->GetFaces()[face]);
  std::vector<std::array<double, 4>>& points = moved->Surface.ControlPoints;
  if (!displacements || displacements->GetNumberOfComponents() != 3 ||
    displacements->GetNumberOfTuples() != static_cast<vtkIdType>(points.size()))
  {
    return this->Fail("face " + std::to_string(face) +
      " needs a displacement of 3 components for each of its " + std::to_string(points.size()) +
      " control points");
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      points[i][c] += points[i][3] * displacements->GetComponent(static_cast<vtkIdType>(i), c);
    }
  }
  moved->Id = sm::NewId();
  model->SetFace(face, moved);
  this->Implementation->Integrator = nullptr;
  return this->Fail({});
}

int vtkVariantMoments::GetNumberOfDirections() const
{
  return static_cast<int>(this->Implementation->Directions.size());
}

bool vtkVariantMoments::Build()
try
{
  Internals& self = *this->Implementation;
  std::string error;
  const auto shape = sm::VariantShape::Make(self.Base, self.Directions, error);
  if (!shape)
  {
    return this->Fail(error);
  }
  sm::VariantOptions options;
  options.Ranges = self.Ranges;
  sm::VariantSettings settings;
  settings.Method = this->Method == POLYNOMIAL ? sm::VariantMethod::Polynomial
    : this->Method == POINTS                   ? sm::VariantMethod::Points
                                               : sm::VariantMethod::Automatic;
  settings.Backend = static_cast<sm::BackendChoice>(this->Backend);
  settings.Expected = this->ExpectedVariants;
  settings.Context = self.Context;
  this->AbortBuild = false;
  settings.Progress = [this](double fraction)
  {
    this->InvokeEvent(vtkCommand::ProgressEvent, &fraction);
    return !this->AbortBuild;
  };
  self.Integrator = sm::VariantIntegrator::Make(shape, options, error, settings);
  return this->Fail(error);
}
catch (...)
{
  this->Implementation->Integrator = nullptr;
  return this->Fail(std::string("the variants could not be prepared: ") +
    sm::GetReason(std::current_exception()) + "; use fewer directions or faces");
}

bool vtkVariantMoments::Run(
  vtkDataArray* c, vtkDoubleArray* values, vtkDoubleArray* bounds, vtkDoubleArray* gradients)
try
{
  const auto& integrator = this->Implementation->Integrator;
  if (!integrator)
  {
    return this->Fail("there is nothing to evaluate: call Build() first");
  }
  const int k = integrator->GetNumberOfDirections();
  if (!c || !values || c->GetNumberOfComponents() != k)
  {
    return this->Fail("variants need " + std::to_string(k) + " components, one for each direction");
  }
  if (gradients && !integrator->GetPolynomial())
  {
    return this->Fail("frozen points have no gradients: choose the method POLYNOMIAL");
  }
  const vtkIdType n = c->GetNumberOfTuples();
  std::vector<double> numbers(static_cast<std::size_t>(n) * k);
  for (vtkIdType i = 0; i < n; ++i)
  {
    c->GetTuple(i, numbers.data() + i * k);
  }
  const auto prepare = [n](vtkDoubleArray* array, int components) -> double*
  {
    if (!array)
    {
      return nullptr;
    }
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(n);
    return n > 0 ? array->GetPointer(0) : nullptr;
  };
  double* const toValues = prepare(values, 10);
  double* const toBounds = prepare(bounds, 10);
  double* const toGradients = prepare(gradients, 10 * k);
  if (n > 0)
  {
    integrator->Evaluate(numbers.data(), static_cast<std::size_t>(n), toValues, toBounds, toGradients);
  }
  return this->Fail({});
}
catch (...)
{
  return this->Fail(std::string("nothing was evaluated: ") + sm::GetReason(std::current_exception()) +
    "; evaluate fewer variants at a time");
}

bool vtkVariantMoments::Evaluate(vtkDataArray* c, vtkDoubleArray* values, vtkDoubleArray* bounds)
{
  return this->Run(c, values, bounds, nullptr);
}

bool vtkVariantMoments::EvaluateGradients(
  vtkDataArray* c, vtkDoubleArray* values, vtkDoubleArray* bounds, vtkDoubleArray* gradients)
{
  if (!gradients)
  {
    return this->Fail("there is no array for the gradients: give one");
  }
  return this->Run(c, values, bounds, gradients);
}

int vtkVariantMoments::GetUsedMethod() const
{
  const auto& integrator = this->Implementation->Integrator;
  return integrator && integrator->GetMethod() == sm::VariantMethod::Polynomial ? POLYNOMIAL : POINTS;
}

int vtkVariantMoments::GetUsedBackend() const
{
  const auto& integrator = this->Implementation->Integrator;
  return integrator && integrator->GetBackend() == sm::BackendChoice::OpenGL ? OPENGL : CPU;
}

std::string vtkVariantMoments::GetReason() const
{
  const auto& integrator = this->Implementation->Integrator;
  return integrator ? integrator->GetReason() : std::string();
}

void vtkVariantMoments::GetReference(double point[3]) const
{
  const auto& integrator = this->Implementation->Integrator;
  for (int c = 0; c < 3; ++c)
  {
    point[c] = integrator ? integrator->GetReference()[c] : vtkMath::Nan();
  }
}

double vtkVariantMoments::GetGap(int direction) const
{
  const auto& integrator = this->Implementation->Integrator;
  return integrator && direction >= 0 && direction < this->GetNumberOfDirections()
    ? integrator->GetGaps()[direction].Distance
    : vtkMath::Nan();
}

void vtkVariantMoments::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "Backend: " << this->Backend << "\n";
  os << indent << "ExpectedVariants: " << this->ExpectedVariants << "\n";
  os << indent << "Directions: " << this->GetNumberOfDirections() << "\n";
  os << indent << "Message: " << this->Message << "\n";
}
