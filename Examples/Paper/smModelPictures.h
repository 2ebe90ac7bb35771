/**
 * @file smModelPictures.h
 * @brief Figure 1 of the paper: translucent models with a green dot at the centre of mass
 */
#ifndef smModelPictures_h
#define smModelPictures_h

#include <string>
#include <vector>

class vtkRenderWindow;

namespace smfigure
{
/**
 * Reads the STEP files, integrates and draws them in `window`, off screen, three in a row, and writes
 * FOLDER/fig1.png and, with all digits, FOLDER/fig1.csv: a row per model with its faces, volume (mm^3),
 * centre of mass (mm), their bounds, and the status. The size of the window is changed. Returns an error
 * message, empty when it succeeds; a file without a volume and a flagged result are errors.
 */
std::string WriteFigure1(
  const std::vector<std::string>& files, const std::string& folder, vtkRenderWindow* window);
}

#endif
