/**
 * @file smMessageList.h
 * @brief What reader and filter said about a file, each fact once
 *
 * The reader sums up a body in one message, its model has them all, the filter repeats the model's and the faces' for
 * every instance of the body, and VTK prints some of it as warnings. Here a fact is told once for each model, under
 * the name of the model's first instance.
 */
#ifndef smMessageList_h
#define smMessageList_h

#include "smJson.h"

#include <map>
#include <set>
#include <string>
#include <vector>

class vtkSurfaceIntegralBase;
class vtkSTEPReader;
class vtkTrimmedNURBSModel;

namespace sm
{
class MessageList
{
public:
  /// After the reader ran.
  void AddReader(vtkSTEPReader* reader);
  /// After the filter ran on that reader's output.
  void AddFilter(vtkSurfaceIntegralBase* filter);
  /// An error or warning of VTK's; those that repeat what was heard are left out.
  void AddEcho(const std::string& message);

  const Json& Get() const { return this->Messages; }

private:
  struct Body
  {
    vtkTrimmedNURBSModel* Model = nullptr;
    std::string Label;
    std::set<std::string> Said;
  };

  void CollectBodies(vtkSTEPReader* reader);
  void LabelBodies();
  void Add(const std::string& message);
  void AddFact(Body& body, const std::string& fact);

  std::vector<Body> Bodies;                                ///< one for each model
  std::map<std::string, std::vector<size_t>> BodiesByName; ///< of their instances
  std::vector<std::string> Heard;                          ///< everything, as it came
  Json Messages = Json::array();
};
}

#endif
