/**
 * @file smReportJson.h
 * @brief The results of a file as JSON
 */
#ifndef smReportJson_h
#define smReportJson_h

#include "smJson.h"

namespace sm
{
struct FileResult;

/// Returns the entry of "files" in the JSON document.
Json MakeJson(const FileResult& file);
}

#endif
