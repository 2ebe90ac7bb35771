// VTK registers the classes that override those of RenderingCore where this header is included.
#include <vtkRenderingCoreModule.h>
