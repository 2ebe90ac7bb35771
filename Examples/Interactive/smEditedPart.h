/**
 * @file smEditedPart.h
 * @brief A part whose control points are moved: its bodies as they are now, and what they were
 *
 * Every change gives new bodies that share all faces that did not change; nothing that was handed out changes. An undo
 * takes the bodies from before, so that it has their bits. World coordinates outside, those of the stored faces inside.
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
/// A control point of a face of a body, all counted from 0.
struct Grip
{
  int Body = -1;
  int Face = -1;
  ControlPointIndex Index;
};

class EditedPart
{
public:
  /// Shares the bodies with exact geometry of a reader's output. Their cells get colours (smBodyScene.h).
  explicit EditedPart(vtkPartitionedDataSetCollection* source);
  ~EditedPart();
  EditedPart(const EditedPart&) = delete;
  EditedPart& operator=(const EditedPart&) = delete;

  /// The bodies as they are now, a partition each; always the same object.
  vtkPartitionedDataSetCollection* GetBodies() const;
  int GetNumberOfBodies() const;
  vtkNURBSDataSet* GetBody(int body) const;
  const FacePointer& GetFace(int body, int face) const;

  /// Edges of the body that are open and were not in the file, the widest first, and how far. Their curves are those of the model
  /// as it is now.
  const std::vector<OpenedEdge>& GetOpened(int body) const;

  /// False, and nothing, when the control point does not exist.
  bool GetPosition(const Grip& grip, std::array<double, 3>& world) const;
  bool GetWeight(const Grip& grip, double& weight) const;
  /// Outward unit normal of the face where the control point pulls most, in world coordinates; zero where there is none.
  std::array<double, 3> GetNormal(const Grip& grip) const;

  ///@{
  /// Moves a control point by a displacement from where it was at the last Commit(), or sets its weight: calls do not add up. False
  /// when that is no edit; GetMessage() says why, and the bodies stay.
  bool Move(const Grip& grip, const std::array<double, 3>& displacement, EditRule rule);
  bool SetWeight(const Grip& grip, double weight, EditRule rule);
  ///@}
  const std::string& GetMessage() const { return this->Message; }

  /// Makes what was moved since the last one a step that Undo() takes back. False when nothing was moved.
  bool Commit();
  /// Forgets what was moved since the last Commit().
  void Cancel();
  ///@{
  /// False when there is nothing to undo, or to do again. What was not committed is forgotten.
  bool Undo();
  bool Redo();
  ///@}
  /// Back to the file, as a step that can be undone. False when nothing differs.
  bool Reset();

  ///@{
  /// Seconds of the last Move() or SetWeight(): the new faces and opened edges; their display points. 0 after an undo.
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
  bool Change(const Grip& grip, const EditFunction& edit);
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

/// World position of a homogeneous control point of a body's model.
std::array<double, 3> ToWorld(vtkNURBSDataSet* body, const std::array<double, 4>& point);
/// World to model, for vectors: no origin, no translation.
std::array<double, 3> ToModelVector(vtkNURBSDataSet* body, const std::array<double, 3>& world);
std::array<double, 3> ToWorldVector(vtkNURBSDataSet* body, const std::array<double, 3>& model);
}

#endif
