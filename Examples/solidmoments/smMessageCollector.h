/**
 * @class   smMessageCollector
 * @brief   collects the errors and warnings that VTK would print, as sentences
 */
#ifndef smMessageCollector_h
#define smMessageCollector_h

#include "vtkOutputWindow.h"

#include <string>
#include <vector>

class smMessageCollector : public vtkOutputWindow
{
public:
  static smMessageCollector* New();
  vtkTypeMacro(smMessageCollector, vtkOutputWindow);

  void DisplayText(const char* text) override;
  void DisplayErrorText(const char* text) override;
  void DisplayWarningText(const char* text) override;
  void DisplayGenericWarningText(const char* text) override;
  void DisplayDebugText(const char*) override {}

  const std::vector<std::string>& GetMessages() const { return this->Messages; }

protected:
  smMessageCollector() = default;
  ~smMessageCollector() override = default;

private:
  smMessageCollector(const smMessageCollector&) = delete;
  void operator=(const smMessageCollector&) = delete;

  std::vector<std::string> Messages;
};

#endif
