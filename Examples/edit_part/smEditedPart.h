/**
 * @file smEditedPart.h
 * @brief A part with movable control points: its current bodies and those of earlier steps
 *
 * Every change gives new bodies that share all unchanged faces; bodies that were returned do not change. An
 * undo takes the earlier bodies, so that it has their bits. Positions are world coordinates; the stored faces
 * have coordinates of their own.
 */
#ifndef smEditedPart_h
#define smEditedPart_h

#include <smModelEdit.h>
#include <vtkNURBSPointEvaluator.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

class vtkNURBSDataSet;
class vtkPartitionedDataSetCollection;

namespace sm
{
/// A control point of a face of a body; all indices start at 0.
struct Grip
{
  int Body = -1;
  int Face = -1;
  ControlPointIndex Index;
};

class EditedPart
{
public:
  /// Shares those bodies of a reader's output that have exact geometry, and gives their cells colours
  /// (smBodyScene.h).
  explicit EditedPart(vtkPartitionedDataSetCollection* source);
  ~EditedPart();
  EditedPart(const EditedPart&) = delete;
  EditedPart& operator=(const EditedPart&) = delete;

  /// Returns the current bodies, a partition each; always the same object.
  vtkPartitionedDataSetCollection* GetBodies() const;
  int GetNumberOfBodies() const;
  vtkNURBSDataSet* GetBody(int body) const;
  const FacePointer& GetFace(int body, int face) const;

  /// Returns the edges of the body that edits have opened, the widest first, with their gaps. Their curves
  /// are those of the current model.
  const std::vector<OpenedEdge>& GetOpened(int body) const;

  /// Gets the position of a control point. Returns false, without a change of `world`, if it does not exist.
  bool GetPosition(const Grip& grip, std::array<double, 3>& world) const;
  bool GetWeight(const Grip& grip, double& weight) const;
  /// Returns the outward unit normal of the face where the control point has the largest influence, in world
  /// coordinates; zero if there is none.
  std::array<double, 3> GetNormal(const Grip& grip) const;

  ///@{
  /// Move a control point by a displacement from its position at the last Commit(), set its weight, or
  /// replace the model of a body by one that was moved; several calls do not add up. Return false, with
  /// GetMessage() and unchanged bodies, if the edit is refused.
  bool Move(const Grip& grip, const std::array<double, 3>& displacement, EditRule rule);
  bool Replace(int body, vtkTrimmedNURBSModel* moved);
  bool SetWeight(const Grip& grip, double weight, EditRule rule);
  ///@}
  const std::string& GetMessage() const { return this->Message; }

  /// Makes the changes since the last Commit() a step that Undo() reverts. Returns false if there are none.
  bool Commit();
  /// Discards the changes since the last Commit().
  void Cancel();
  ///@{
  /// Return false if there is nothing to undo or redo. Changes that were not committed are discarded.
  bool Undo();
  bool Redo();
  ///@}
  /// Resets the part to the file, as a step that can be undone. Returns false if nothing differs.
  bool Reset();

  ///@{
  /// Seconds of the last Move() or SetWeight(): for new faces and opened edges, and for display points. 0
  /// after an undo.
  double GetEditSeconds() const { return this->EditSeconds; }
  double GetDisplaySeconds() const { return this->DisplaySeconds; }
  ///@}

private:
  struct Body
  {
    vtkSmartPointer<vtkNURBSDataSet> Leaf;
    std::vector<OpenedEdge> Opened;
  };
  using State = std::vector<Body>;

  template <typename EditFunction>
  bool Change(int index, const EditFunction& edit);
  void Show(State state);
  bool GoTo(std::size_t step);

  vtkSmartPointer<vtkPartitionedDataSetCollection> Bodies;
  vtkNew<vtkNURBSPointEvaluator> Points;
  State Now;
  std::vector<State> Steps;
  std::size_t Step = 0;
  std::string Message;
  double EditSeconds = 0.0;
  double DisplaySeconds = 0.0;
};

/// Returns the world position of a homogeneous control point of a body's model.
std::array<double, 3> ToWorld(vtkNURBSDataSet* body, const std::array<double, 4>& point);
/// Transform vectors from world to model and back: without origin and translation.
std::array<double, 3> ToModelVector(vtkNURBSDataSet* body, const std::array<double, 3>& world);
std::array<double, 3> ToWorldVector(vtkNURBSDataSet* body, const std::array<double, 3>& model);
}

#endif
