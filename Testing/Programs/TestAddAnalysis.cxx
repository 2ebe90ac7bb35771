// TestAddAnalysis FILE.step: the analysis that the developer guide shows, added to the list of the program:
// its option and help, its values in all documents, and its way through the pipe between two processes. The
// file is a box with the edges 2, 3 and 5.
#include "smArguments.h"
#include "smByteFields.h"
#include "smCompactnessAnalysis.h"
#include "smIsolatedJob.h"
#include "smReport.h"
#include "smTesting.h"

#include <cmath>

namespace
{
using namespace smtest;

sm::FileResult RunJob(const sm::JobOptions& options)
{
  sm::FileResult result(options);
  sm::RunFileJob(options,
    [&result](const sm::JobMessage& message)
    {
      if (message.File)
      {
        result = *message.File;
      }
    });
  return result;
}

void CheckDocuments(const sm::FileResult& file, const sm::ScalarQuantity& found)
{
  const std::string value = sm::FormatExact(found.Get());
  const std::string json = sm::FormatJson({}, { file });
  CheckTrue("JSON", json.find("\"compactness\": {\n        \"value\": " + value) != std::string::npos, json);
  CheckTrue(
    "table", sm::FormatTable(file).find("\n  compactness ") != std::string::npos, sm::FormatTable(file));
  CheckEqual("--print", value + "\n", sm::FormatFields(file, { "compactness" }));
  const std::string head = "row,compactness\n";
  CheckEqual("CSV", head + "total," + value + "\nsolid," + value + "\n",
    sm::FormatCsv({ file }, { "row", "compactness" }));
}

/// The bytes of the result give the same document, and all that is cut off from them is noticed.
void CheckPipe(const sm::JobOptions& options, sm::FileResult& file)
{
  sm::ByteFieldWriter writer;
  file.Visit(writer);
  sm::ByteFieldReader reader(writer.Get());
  sm::FileResult copy(options);
  copy.Visit(reader);
  CheckTrue("all bytes are read", reader.IsWhole());
  CheckEqual("the same document", sm::FormatJson({}, { file }), sm::FormatJson({}, { copy }));
  int whole = 0;
  for (std::size_t size = 0; size < writer.Get().size(); size += 7)
  {
    sm::ByteFieldReader cut(
      { writer.Get().begin(), writer.Get().begin() + static_cast<std::ptrdiff_t>(size) });
    sm::FileResult part(options);
    part.Visit(cut);
    whole += cut.IsWhole() ? 1 : 0;
  }
  Check("cut messages that count as whole", 0, whole, 0);
}

/// What became of the outputs of two analyses comes through the pipe apart.
void CheckOutputs(const sm::JobOptions& options)
{
  sm::JobMessages said;
  const std::pair<const char*, const char*> reports[] = { { "budget", "the disk is full" }, { "chart", "" },
    { "report", "two\nlines" } };
  for (const auto& [key, problem] : reports)
  {
    sm::JobMessage message = sm::JobMessage::OfAnalysis(key, problem);
    sm::ByteFieldWriter writer;
    writer.Text(nullptr, message.Text);
    writer.Number(nullptr, message.Fraction);
    said.Take(sm::JobMessage::Analysis, writer.Get(), options, [](const std::string&, double) {});
  }
  CheckEqual("reports", 3, static_cast<long long>(said.Analyses.size()));
  for (const auto& [key, problem] : reports)
  {
    CheckEqual(std::string("of ") + key, problem, said.Analyses[key]);
  }
}
}

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    return 1;
  }
  sm::Arguments arguments;
  arguments.Job.Analyses.push_back(std::make_shared<CompactnessAnalysis>());
  std::vector<std::string> texts = { "solidmoments", "--backend", "cpu", "--compactness", "--moments", "1",
    argv[1] };
  std::vector<char*> pointers;
  for (std::string& text : texts)
  {
    pointers.push_back(text.data());
  }
  CheckTrue("arguments",
    !sm::ParseArguments(static_cast<int>(pointers.size()), pointers.data(), arguments).has_value());
  arguments.Job.FileName = argv[1];

  const std::vector<std::string> columns = sm::ListColumns(sm::UnreadableFile(arguments.Job, ""));
  CheckEqual("last column", "compactness_bound", columns.back());
  sm::FileResult file = RunJob(arguments.Job);
  CheckEqual("status", "ok", file.Status);
  const auto* total = file.Analyses.Find<CompactnessResult>();
  CheckTrue("result", total != nullptr && file.Solids.size() == 1);
  if (total)
  {
    Check("compactness", 36.0 * std::acos(-1.0) * 900.0 / (62.0 * 62.0 * 62.0), total->Compactness.Get(),
      total->Compactness.Bound);
    CheckTrue(
      "bound is not vacuous", total->Compactness.Bound < 1e-8, std::to_string(total->Compactness.Bound));
    CheckDocuments(file, total->Compactness);
  }
  CheckPipe(arguments.Job, file);
  CheckOutputs(arguments.Job);
  return Finish();
}
