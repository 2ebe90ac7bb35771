// Rigid moves: placement, points and normals together, models shared; what is not rigid is refused.
#include "smDecimalCommas.h"
#include "smFilterTesting.h"

#include <vtkNURBSTransform.h>
#include <vtkObjectFactory.h>
#include <vtkTransform.h>

#include <new>

namespace
{
using namespace smtest;

void CheckMoved(vtkNURBSTransform* filter, vtkPartitionedDataSetCollection* product, bool mirrored)
{
  filter->Update();
  vtkDataObject* output = filter->GetOutputDataObject(0);
  CheckStructure(output);
  vtkNew<vtkMatrix4x4> matrix;
  filter->GetMatrix(matrix);
  for (unsigned int i = 0; i < 2; ++i)
  {
    vtkNURBSDataSet* before = GetLeaf(product, i);
    vtkNURBSDataSet* after = GetLeaf(output, i);
    if (!CheckTrue(
          "the model is shared", after && after->GetModel() && after->GetModel() == before->GetModel()))
    {
      continue;
    }
    double worst = 0.0;
    for (vtkIdType p = 0; p < before->GetNumberOfPoints(); ++p)
    {
      const double* from = before->GetPoint(p);
      const double in[4] = { from[0], from[1], from[2], 1.0 };
      double to[4];
      matrix->MultiplyPoint(in, to);
      for (int c = 0; c < 3; ++c)
      {
        worst = std::fmax(worst, std::fabs(to[c] - after->GetPoint(p)[c]));
      }
    }
    Check("points", 0.0, worst, 1e-13, "rounding of about 50");
    Check("points on the placed faces", 0.0, GetDistanceFromFaces(after), 1e-13, "rounding of about 50");
    Check("cells and normals point the same way", 1.0, GetMinimumCosine(after), 1e-6, "float normals");
    vtkNew<vtkMatrix4x4> placement;
    after->GetPlacement(placement);
    Check("the placement's determinant", mirrored ? -1.0 : 1.0, placement->Determinant(), 1e-14);
    CheckTrue("the input stays", before->GetModel() && GetDistanceFromFaces(before) < 1e-13);
  }
  auto* plain =
    vtkPolyData::SafeDownCast(vtkPartitionedDataSetCollection::SafeDownCast(output)->GetPartition(2, 0));
  const double in[4] = { 1.0, 2.0, 3.0, 1.0 };
  double to[4];
  matrix->MultiplyPoint(in, to);
  Check("a plain mesh moves along", to[0], plain ? plain->GetPoint(0)[0] : 0.0, 1e-5, "a float");
}

class ThrowingTransform : public vtkTransform
{
public:
  static ThrowingTransform* New() { VTK_STANDARD_NEW_BODY(ThrowingTransform); }
  vtkTypeMacro(ThrowingTransform, vtkTransform);
  bool ThrowsNumber = false;

protected:
  void InternalUpdate() override
  {
    if (this->ThrowsNumber)
    {
      throw 1;
    }
    throw std::bad_alloc();
  }
};

/// An exception is an error of the filter with an empty output; it does not leave Update().
void CheckException(vtkDataObject* input, bool throwsNumber, const char* reason)
{
  // One for each: vtkAbstractTransform::Update() leaves its mutex locked when it throws.
  vtkNew<ThrowingTransform> transform;
  transform->ThrowsNumber = throwsNumber;
  vtkNew<vtkNURBSTransform> filter;
  filter->SetInputData(input);
  filter->SetTransform(transform);
  CheckFails(filter, reason);
}
}

int TestNURBSTransform(int, char*[])
{
  LatticeBody body;
  body.Origin = { 0.5, -0.25, 2.0 };
  const auto product = MakeProduct(body);
  vtkNew<vtkNURBSTransform> filter;
  filter->SetInputData(product);
  CheckMoved(filter, product, false);
  std::printf("--- rotated and moved\n");
  filter->SetTranslation(3.0, -4.0, 5.0);
  filter->SetRotation(30.0, 45.0, -70.0);
  CheckMoved(filter, product, false);
  std::printf("--- mirrored\n");
  filter->SetMirror(vtkNURBSTransform::Y);
  CheckMoved(filter, product, true);
  filter->SetMirror(9);
  CheckEqual("the mirror is clamped", 3, filter->GetMirror());
  std::printf("--- a transform\n");
  vtkNew<vtkTransform> transform;
  transform->RotateWXYZ(33.0, 1.0, 2.0, 3.0);
  transform->Translate(1.0, 2.0, 3.0);
  filter->SetTransform(transform);
  CheckMoved(filter, product, false);
  const double before = GetLeaf(filter->GetOutputDataObject(0), 0)->GetPoint(0)[0];
  transform->Translate(1.0, 0.0, 0.0);
  filter->Update();
  CheckTrue("a changed transform runs the filter",
    GetLeaf(filter->GetOutputDataObject(0), 0)->GetPoint(0)[0] != before);
  std::printf("--- a single leaf\n");
  const auto leaf = body.Make();
  vtkNew<vtkNURBSTransform> single;
  single->SetInputData(leaf);
  single->SetTranslation(1.0, 0.0, 0.0);
  single->Update();
  auto* moved = vtkNURBSDataSet::SafeDownCast(single->GetOutputDataObject(0));
  CheckTrue("a leaf stays a leaf", moved && moved->GetModel() == leaf->GetModel());
  Check("and moves", 1.0, moved ? moved->GetPlacementData()[3] : 0.0, 0.0);
  std::printf("--- not rigid\n");
  transform->Identity();
  transform->Scale(1.0, 1.0, 1.5);
  {
    const DecimalCommas commas;
    CheckFails(filter, "off by 1.25)");
  }
  transform->Identity();
  transform->Scale(1.0, 1.0, 1.0 + 1e-9);
  CheckFails(filter, "not rigid");
  transform->Identity();
  const double shear[16] = { 1, 0.1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  transform->Concatenate(shear);
  CheckFails(filter, "deform the part with NURBS Deform");
  filter->SetTransform(nullptr);
  filter->SetTranslation(std::nan(""), 0.0, 0.0);
  CheckFails(filter, "not rigid");
  filter->SetTranslation(0.0, 0.0, 0.0);
  CheckMoved(filter, product, true);
  CheckAbort(filter);
  CheckException(product, false, "there is not enough memory");
  CheckException(product, true, "an exception of an unknown type was thrown");
  return Finish();
}
