/**
 * @file smFilterSetUp.h
 * @brief The settings that all filters of a job share
 */
#ifndef smFilterSetUp_h
#define smFilterSetUp_h

#include <string>

class vtkMassPropertiesBase;
class vtkOpenGLRenderWindow;
class vtkSurfaceIntegralBase;

namespace sm
{
class MessageList;
struct FileResult;
struct JobOptions;

/// Sets the limits and the backend of a filter.
void SetUpFilter(vtkSurfaceIntegralBase* filter, const JobOptions& options);

/// Sets the densities and materials of a filter.
void SetUpMass(vtkMassPropertiesBase* filter, const JobOptions& options);

/// Limits the next run of a filter to the seconds that the job has left.
void SetTimeLimit(vtkSurfaceIntegralBase* filter, const JobOptions& options);

/// Starts the OpenGL context of a filter, and returns its window; null with the reason in `problem`.
vtkOpenGLRenderWindow* StartWindow(vtkSurfaceIntegralBase* filter, std::string& problem);

/// Adds the status of an analysis, or of an output, to that of a file: it replaces "ok", and "suspect" also
/// replaces "tolerance-not-met".
void AddStatus(const std::string& status, FileResult& file);
/// Adds status, evaluations, dispatches and messages of a filter's last run to the file's.
void AddEffort(vtkSurfaceIntegralBase* filter, FileResult& file, MessageList& messages);
}

#endif
