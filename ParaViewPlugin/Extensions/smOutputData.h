/**
 * @file smOutputData.h
 * @brief The data on an output port of a server's object, for classes that gather information
 */
#ifndef smOutputData_h
#define smOutputData_h

class vtkDataObject;
class vtkObject;

namespace sm
{
/// `object` is a data object, an algorithm, or an output of one, which has its own port. Returns null without
/// data. Runs no pipeline.
vtkDataObject* GetOutputData(vtkObject* object, int port);
}

#endif
