/**
 * @file smScheme.h
 * @brief The scheme by which mass properties are integrated: the adaptive one, or one of the paper
 */
#ifndef smScheme_h
#define smScheme_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>

class vtkFieldData;
class vtkMassPropertiesBase;

namespace CLI
{
class App;
}

namespace sm
{
struct BodyResult;
struct FileResult;
struct TotalResult;

class Scheme
{
public:
  void Declare(CLI::App& app);
  /// Returns an error message if an option does not belong to the scheme, or this build is without the
  /// scheme; empty otherwise.
  std::string FindProblem(const CLI::App& app) const;
  bool IsAdaptive() const { return this->Name == "adaptive"; }
  const std::string& GetName() const { return this->Name; }
  /// Returns the folder for trim textures; empty: none.
  const std::string& GetTextureFolder() const { return this->TextureFolder; }

  /// Returns the option of CMake that this build was made without; null if it has the schemes of the paper.
  static const char* GetMissingModule();
  /// Makes a filter for a scheme of the paper.
  vtkSmartPointer<vtkMassPropertiesBase> MakeFilter() const;
  /// Adds the options of such a filter; does nothing for any other filter.
  static void ReadOptions(vtkMassPropertiesBase* filter, FileResult& file);
  /// Adds the paper's estimates of the error and the number of sub-patches in a row of field data or of a
  /// table.
  static void ReadBody(vtkFieldData* data, vtkIdType row, BodyResult& body);
  /// Writes the textures that the last run kept, v upwards, white inside the face, as PREFIX-NAME.png. NAME
  /// is the texture's name with a dash for all but letters, digits and points; equal names get -2, -3, ...
  /// Returns an error message, empty when all are written.
  static std::string WriteTrimPictures(vtkMassPropertiesBase* filter, const std::string& prefix);

private:
  std::string Name = "adaptive"; ///< or "midpoint", "gauss2", "gauss3", which the other options are for
  int SubPatches = 2;
  int TrimTexture = 4;
  double ChordTolerance = 1e-8;
  std::string Deviation = "bounded";
  std::string TextureFolder;
};

/// Returns the rows of the table: scheme, sub-patches and error estimate of a run with one of the paper's
/// schemes.
std::string FormatSchemeRows(const FileResult& file);
}

#endif
