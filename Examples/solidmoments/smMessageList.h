/**
 * @file smMessageList.h
 * @brief The messages of reader and filters about a file, each fact once
 *
 * The reader has one summary message for a body, the body's model has all of its messages, the filter repeats
 * those of the model and of its faces for every instance of the body, and VTK prints some of them as
 * warnings. The list has every message once for each model, with the name of the model's first instance.
 */
#ifndef smMessageList_h
#define smMessageList_h

#include <map>
#include <set>
#include <string>
#include <vector>

class vtkSurfaceIntegralBase;
class vtkCADReader;
class vtkTrimmedNURBSModel;

namespace sm
{
class MessageList
{
public:
  /// Adds the messages of the reader, after its run.
  void AddReader(vtkCADReader* reader);
  /// Adds the messages of a filter, after its run on that reader's output.
  void AddFilter(vtkSurfaceIntegralBase* filter);
  /// Adds an error or warning of VTK unless it repeats a message that was added before.
  void AddEcho(const std::string& message);

  const std::vector<std::string>& Get() const { return this->Messages; }

private:
  struct Body
  {
    vtkTrimmedNURBSModel* Model = nullptr;
    std::string Label;
    std::set<std::string> Said;
  };

  void CollectBodies(vtkCADReader* reader);
  void LabelBodies();
  void Add(const std::string& message);
  void AddFact(Body& body, const std::string& fact);

  std::vector<Body> Bodies;                                ///< one for each model
  std::map<std::string, std::vector<size_t>> BodiesByName; ///< by the names of their instances
  std::vector<std::string> Heard;                          ///< all messages as they were given
  std::vector<std::string> Messages;
};
}

#endif
