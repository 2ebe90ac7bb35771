/**
 * @file smSTEPLedger.h
 * @brief What became of the entities of a STEP file on which bodies depend: converted, or listed with a
 * reason
 */
#ifndef smSTEPLedger_h
#define smSTEPLedger_h

#include "smPart21File.h"

#include <cstdint>
#include <string>
#include <vector>

namespace sm
{
/// An entity that was not converted.
struct LedgerRow
{
  std::uint64_t Id = 0;
  /// Name of its type, in capitals.
  std::string Type;
  /// Why it was not converted, as the end of the sentence "It is left out: ...".
  std::string Reason;
  /// What is missing for that, as a clause: "faces on it are missing".
  std::string Consequence;
};

/// One account of a file: every entity that a reader asks for is either converted or has a row.
struct STEPLedger
{
  std::vector<LedgerRow> Rows;
};

/// Describes why an entity is not made: the first damaged one that it depends on or, of those with a row, the
/// one that is farthest below it.
std::string DescribeCause(const Part21File& file, const STEPLedger& ledger, Part21File::Index entity);
}

#endif
