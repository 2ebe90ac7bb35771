/**
 * @file smFigureText.h
 * @brief The text around a plot: a legend in rows above it, and the titles of its axes at fixed distances
 *
 * vtkChartLegend has columns only, and vtkAxis puts its title as near to the labels as it can.
 */
#ifndef smFigureText_h
#define smFigureText_h

#include "smFigure.h"

#include <vtkContextItem.h>
#include <vtkWeakPointer.h>

class vtkChart;

namespace smfigure
{
/// Sizes of letters in pixels of the figure.
constexpr int TitleSize = 19;
constexpr int LabelSize = 16;

class FigureText : public vtkContextItem
{
public:
  static FigureText* New();
  vtkTypeMacro(FigureText, vtkContextItem);

  /// `scale`: pixels of the window per pixel of the figure.
  void Set(vtkChart* chart, const Figure& figure, float scale);

  bool Paint(vtkContext2D* painter) override;

private:
  void PaintTitles(vtkContext2D* painter) const;
  void PaintLegend(vtkContext2D* painter) const;

  vtkWeakPointer<vtkChart> Chart;
  std::array<float, 4> Plot{};
  std::string Titles[2];
  float TitleLeft = 0.0f;
  float Gap = 0.0f;
  int Columns = 0;
  float Scale = 1.0f;
};
}

#endif
