/**
 * @file smFigure.h
 * @brief A figure as data, and its drawing by VTK's charts: PNG, SVG and the numbers as CSV
 */
#ifndef smFigure_h
#define smFigure_h

#include <array>
#include <string>
#include <utility>
#include <vector>

class vtkRenderWindow;

namespace smfigure
{
using Color = std::array<unsigned char, 3>;

/// The palette of Okabe and Ito, which colour-blind readers can distinguish; in grey, lightness and markers
/// differ.
namespace colors
{
constexpr Color Black{ 0, 0, 0 };
constexpr Color Grey{ 150, 150, 150 };
constexpr Color LightGrey{ 205, 205, 205 };
constexpr Color Orange{ 230, 159, 0 };
constexpr Color Blue{ 0, 114, 178 };
constexpr Color Green{ 0, 158, 115 };
constexpr Color Vermillion{ 213, 94, 0 };
constexpr Color SkyBlue{ 86, 180, 233 };
}

enum class Marker
{
  None,
  Circle,
  Square,
  Diamond,
  Plus,
  Cross
};

struct Series
{
  /// The entry in the legend; empty: none.
  std::string Label;
  std::vector<double> X;
  std::vector<double> Y;
  Color Hue = colors::Black;
  Marker Symbol = Marker::None;
  float MarkerSize = 9.0f;
  /// Width of the line in pixels; 0: no line.
  float LineWidth = 0.0f;
  bool Dashed = false;
};

struct FigureAxis
{
  std::string Title;
  double Minimum = 0.0;
  double Maximum = 1.0;
  /// Positions and labels, with a grid line at each when Grid is on.
  std::vector<std::pair<double, std::string>> Ticks;
  bool Log = false;
  bool Grid = false;
  unsigned char GridGrey = 228;
  /// Labels on the opposite side, without ticks.
  std::vector<std::pair<double, std::string>> OppositeTicks;
};

/// Columns and rows of the CSV file of a figure.
struct FigureTable
{
  std::vector<std::string> Columns;
  std::vector<std::vector<std::string>> Rows;
};

struct Figure
{
  /// The name of the files, without an extension.
  std::string Name;
  int Width = 800;
  int Height = 600;
  /// Distances from the plot to the borders, in pixels. They are equal above and below, because
  /// vtkSVGExporter (9.1, 9.2) clips plots upside down.
  float Left = 105.0f;
  float Right = 30.0f;
  float AboveAndBelow = 78.0f;
  /// Distance from the plot to the middle of the vertical axis' title; the labels are between them.
  float TitleLeft = 75.0f;
  FigureAxis X;
  FigureAxis Y;
  std::vector<Series> Content;
  /// Entries in a row of the legend, which is above the plot; 0: no legend.
  int LegendColumns = 0;
  FigureTable Table;

  /// Returns the left and bottom border, width and height of the plot, in pixels.
  std::array<float, 4> GetPlot() const
  {
    return { this->Left, this->AboveAndBelow, this->Width - this->Left - this->Right,
      this->Height - 2.0f * this->AboveAndBelow };
  }
};

/// Returns a number with 17 digits, which identify a double.
std::string FormatNumber(double value);

/// Makes ticks at every `step`-th power of ten from 10^low to 10^high.
std::vector<std::pair<double, std::string>> MakeDecadeTicks(int low, int high, int step);

/// Writes CSV. Returns an error message, empty when it is written.
std::string WriteTable(const FigureTable& table, const std::string& path);

/// Draws into `window`, off screen, and writes FOLDER/NAME.png, .svg and .csv. Returns an error message,
/// empty when all are written.
std::string WriteFigure(const Figure& figure, const std::string& folder, vtkRenderWindow* window);
}

#endif
