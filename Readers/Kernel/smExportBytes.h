/**
 * @file smExportBytes.h
 * @brief Trees of parts that are to be written, and the result, as bytes (smKernelMessages.h)
 */
#ifndef smExportBytes_h
#define smExportBytes_h

#include "smBytes.h"
#include "smExport.h"
#include "smReadersKernelModule.h"

namespace sm
{
SMREADERSKERNEL_EXPORT void PutExport(const ExportTree& tree, const ExportOptions& options, ByteWriter& to);
/// Returns false if the bytes are not valid.
SMREADERSKERNEL_EXPORT bool GetExport(ByteReader& from, ExportTree& tree, ExportOptions& options);

SMREADERSKERNEL_EXPORT void PutExportResult(const ExportResult& result, ByteWriter& to);
/// Returns false if the bytes are not valid.
SMREADERSKERNEL_EXPORT bool GetExportResult(ByteReader& from, ExportResult& result);
}

#endif
