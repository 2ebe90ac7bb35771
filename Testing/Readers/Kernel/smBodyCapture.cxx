#include "smBodyCapture.h"

#include "smDocument.h"
#include "smTesting.h"

#include <vtkObjectFactory.h>
#include <vtkSTEPReader.h>
#include <vtkSmartPointer.h>

namespace
{
class BodyReader : public vtkSTEPReader
{
public:
  static BodyReader* New();
  vtkTypeMacro(BodyReader, vtkSTEPReader);

  std::vector<sm::BodyShape> Bodies;

protected:
  void InspectDocument(const sm::Document& document) override
  {
    for (const sm::PartBody& body : document.Bodies)
    {
      this->Bodies.push_back(body.Shape);
    }
  }
};
vtkStandardNewMacro(BodyReader);
}

namespace smtest
{
std::vector<sm::BodyShape> CaptureBodies(const std::string& path)
{
  const auto reader = vtkSmartPointer<BodyReader>::New();
  reader->SetFileName(path.c_str());
  reader->Update();
  CheckEqual(path, "ok", reader->GetStatusAsString());
  return reader->Bodies;
}
}
