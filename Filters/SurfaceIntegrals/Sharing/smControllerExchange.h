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
/// Messages have tags of their own, so that they are not confused with other messages between collective calls.
class SMFILTERSSURFACEINTEGRALS_EXPORT ControllerExchange : public FaceExchange
{
public:
  explicit ControllerExchange(vtkMultiProcessController* controller);
  ~ControllerExchange() override;

  int GetNumberOfRanks() const override;
  int GetRank() const override;
  bool Share(const std::vector<double>& mine, std::vector<double>& all) override;
  bool Gather(int root, const Bytes& mine, std::vector<Bytes>& all) override;
  bool Scatter(int root, const std::vector<Bytes>& all, Bytes& mine) override;

private:
  bool Send(int to, const Bytes& message);
  bool Receive(int from, Bytes& message);

  vtkSmartPointer<vtkMultiProcessController> Controller;
};
}

#endif
