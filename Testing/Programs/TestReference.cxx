// TestReference FILE.md [write]: below its head, the page is the reference of JSON and CSV that the program's
// results give. `write` puts it there.
#include "smReference.h"
#include "smTesting.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>

int main(int argc, char* argv[])
{
  if (argc < 2)
  {
    return 1;
  }
  const std::string reference = sm::FormatReference();
  const std::string begin = reference.substr(0, reference.find('\n') + 1);
  std::ifstream file(argv[1], std::ios::binary);
  const std::string page{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  const std::size_t at = std::min(page.find(begin), page.size());
  if (argc == 3 && std::strcmp(argv[2], "write") == 0)
  {
    std::ofstream written(argv[1], std::ios::binary);
    written << page.substr(0, at) << reference;
    return written ? 0 : 1;
  }
  smtest::CheckTrue(
    "keys and columns have a meaning or a unit", reference.find("` | object |  |  |") == std::string::npos);
  smtest::CheckEqual("the page; TestReference FILE write writes it", reference, page.substr(at));
  return smtest::Finish();
}
