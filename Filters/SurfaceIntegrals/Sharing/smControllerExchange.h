/**
 * @file smControllerExchange.h
 * @brief A FaceExchange over a vtkMultiProcessController
 */
#ifndef smControllerExchange_h
#define smControllerExchange_h

#include "smFaceExchange.h"
#include "smFiltersSurfaceIntegralsModule.h"

#include "vtkSmartPointer.h"

class vtkMultiProcessController;

namespace sm
{
/// Messages have tags of their own, so that they are not confused with other messages between collective
/// calls. They are sent in pieces, so that a rank without memory for a whole message can receive and drop it.
class SMFILTERSSURFACEINTEGRALS_EXPORT ControllerExchange : public FaceExchange
{
public:
  explicit ControllerExchange(vtkMultiProcessController* controller);
  ~ControllerExchange() override;

  vtkMultiProcessController* GetController() const { return this->Controller; }
  int GetNumberOfRanks() const override;
  int GetRank() const override;
  bool Sum(RankNumbers& numbers) override;
  bool Gather(int root, const Bytes& mine, std::vector<Bytes>& all) override;
  bool Scatter(int root, const std::vector<Bytes>& all, Bytes& mine) override;

private:
  bool Send(int to, const Bytes& message);
  /// Receives a message; drops it if `message` is null or there is no memory for it, and then sets
  /// `isDropped`.
  bool Receive(int from, Bytes* message, bool& isDropped);

  vtkSmartPointer<vtkMultiProcessController> Controller;
};
}

#endif
