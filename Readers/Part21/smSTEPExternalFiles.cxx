#include "smSTEPExternalFiles.h"

#include "smSTEPCensus.h"
#include "smTextEncoding.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

namespace sm
{
namespace
{
namespace fs = std::filesystem;

/// Largest number of files that are joined to one.
constexpr std::size_t MaxFiles = 10000;

/// Text in which names of other files may stand; without it there are none.
constexpr std::string_view FileEntity = "DOCUMENT_FILE";
/// Numbers of another file are increased by a multiple of this.
constexpr std::uint64_t RoundNumber = 1000;
constexpr std::string_view EndOfSection = "ENDSEC";

/// Returns the text of an entity with all numbers of entities increased, except in strings and comments.
std::string Renumber(std::string_view text, std::uint64_t by)
{
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    std::size_t end = i + 1;
    if (text[i] == '\'' || text.compare(i, 2, "/*") == 0)
    {
      const std::string_view close = text[i] == '\'' ? "'" : "*/";
      end = std::min(text.find(close, i + close.size()), text.size() - close.size()) + close.size();
    }
    while (text[i] == '#' && end < text.size() && text[end] >= '0' && text[end] <= '9')
    {
      ++end;
    }
    std::uint64_t number = 0;
    const bool isNumber = text[i] == '#' && end > i + 1 &&
      std::from_chars(text.data() + i + 1, text.data() + end, number).ec == std::errc();
    result += isNumber ? "#" + std::to_string(number + by) : std::string(text.substr(i, end - i));
    i = end - 1;
  }
  return result;
}

/// A product definition with a representation of its shape.
struct ShapedProduct
{
  std::uint64_t Id = 0;
  std::uint64_t Shape = 0;
  std::string Name;
};

/// A file whose entities are in the joined text from First on.
struct JoinedFile
{
  fs::path Path;
  std::uint64_t First = 0;
  /// The file that named it first; itself for the one that names all others.
  std::size_t Parent = 0;
  std::vector<ShapedProduct> Roots;
};

std::vector<ShapedProduct> FindRoots(const STEPCensus& census, std::uint64_t by)
{
  std::vector<ShapedProduct> roots;
  for (const CensusProduct& product : census.Products)
  {
    const bool hasShape =
      !product.Shapes.empty() && !census.Shapes[product.Shapes[0]].Representations.empty();
    if (!product.IsPart && product.Instances > 0 && hasShape)
    {
      roots.push_back(
        { product.Id + by, census.Shapes[product.Shapes[0]].Representations[0] + by, product.Name });
    }
  }
  return roots;
}

class FileJoiner
{
public:
  FileJoiner(std::string text, const std::string& path, const std::vector<std::string>& folders,
    std::vector<std::string>& messages)
    : Text(std::move(text))
    , Messages(messages)
  {
    std::error_code error;
    this->Files.push_back({ fs::weakly_canonical(path, error), 0, 0, {} });
    this->Folders.assign(folders.begin(), folders.end());
  }

  /// Returns true if anything was joined.
  bool Run()
  {
    bool isJoined = false;
    while (this->Files.size() < MaxFiles && this->JoinOnce())
    {
      isJoined = true;
    }
    return isJoined;
  }

  std::string Text;

private:
  /// Joins the files that products without a shape name now; returns false if there is none.
  bool JoinOnce()
  {
    Part21File file;
    if (!file.Parse(this->Text))
    {
      return false;
    }
    const STEPCensus census = TakeSTEPCensus(file);
    this->Largest = 0;
    for (Part21File::Index i = 0; i < file.GetNumberOfInstances(); ++i)
    {
      this->Largest = std::max(this->Largest, file.GetId(i));
    }
    std::string added;
    for (const CensusShapelessProduct& shapeless : census.ShapelessProducts)
    {
      if (!shapeless.File.empty() && this->Tried.insert({ shapeless.Id, shapeless.File }).second)
      {
        this->Complete(census, shapeless, added);
      }
    }
    const std::size_t end = this->Text.rfind(EndOfSection);
    if (added.empty() || end == std::string::npos)
    {
      return false;
    }
    this->Text.insert(end, added);
    return true;
  }

  /// Returns the index of the file that has an entity.
  std::size_t FindOwner(std::uint64_t id) const
  {
    std::size_t owner = 0;
    for (std::size_t k = 0; k < this->Files.size(); ++k)
    {
      owner = this->Files[k].First <= id && this->Files[k].First >= this->Files[owner].First ? k : owner;
    }
    return owner;
  }

  /// Adds the file of a product, if it is not there yet, and makes its roots parts of the product.
  void Complete(const STEPCensus& census, const CensusShapelessProduct& shapeless, std::string& added)
  {
    const std::size_t owner = this->FindOwner(shapeless.Id);
    const fs::path path = this->FindFile(shapeless.File, this->Files[owner].Path.parent_path());
    if (path.empty())
    {
      return;
    }
    std::size_t index = 0;
    while (index < this->Files.size() && this->Files[index].Path != path)
    {
      ++index;
    }
    for (std::size_t above = owner;; above = this->Files[above].Parent)
    {
      if (above == index)
      {
        this->Messages.push_back("Product #" + std::to_string(shapeless.Id) + " has its shape in " +
          shapeless.File + ", which contains it: it is left out.");
        return;
      }
      if (above == this->Files[above].Parent)
      {
        break;
      }
    }
    if (index == this->Files.size() && !this->AddFile(path, owner, shapeless, added))
    {
      return;
    }
    for (const ShapedProduct& root : this->Files[index].Roots)
    {
      this->Place(census, shapeless.Id, root, added);
    }
  }

  /// Returns the canonical path of a file; empty if it is in none of the folders.
  fs::path FindFile(const std::string& name, const fs::path& own) const
  {
    std::string slashed = DecodePart21Text(name);
    std::replace(slashed.begin(), slashed.end(), '\\', '/');
    const fs::path written(slashed);
    const bool isPlain = written.is_relative() && slashed.find(':') == std::string::npos &&
      std::find(written.begin(), written.end(), fs::path("..")) == written.end();
    std::vector<fs::path> folders{ own };
    folders.insert(folders.end(), this->Folders.begin(), this->Folders.end());
    for (const fs::path& folder : folders)
    {
      for (const fs::path& tried : { isPlain ? written : written.filename(), written.filename() })
      {
        std::error_code error;
        const fs::path base = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
        const fs::path found = error || tried.empty() ? fs::path() : fs::canonical(base / tried, error);
        const fs::path inside = error ? fs::path() : found.lexically_relative(base);
        if (!inside.empty() && *inside.begin() != fs::path("..") && fs::is_regular_file(found, error))
        {
          return found;
        }
      }
    }
    return {};
  }

  bool AddFile(
    const fs::path& path, std::size_t owner, const CensusShapelessProduct& shapeless, std::string& added)
  {
    Part21File file;
    const bool isRead = file.Read(path.string());
    const std::vector<ShapedProduct> none;
    const std::uint64_t by = (this->Largest / RoundNumber + 1) * RoundNumber;
    std::vector<ShapedProduct> roots = isRead ? FindRoots(TakeSTEPCensus(file), by) : none;
    if (roots.empty())
    {
      this->Messages.push_back("The file " + shapeless.File + " of product #" + std::to_string(shapeless.Id) +
        (isRead ? " has no product with a shape" : " is not a STEP file that can be read") +
        ": it is left out.");
      return false;
    }
    for (Part21File::Index i = 0; i < file.GetNumberOfInstances(); ++i)
    {
      added += Renumber(file.GetText(i), by) + "\n";
      this->Largest = std::max(this->Largest, file.GetId(i) + by);
    }
    this->Messages.push_back("The file " + shapeless.File +
      " was read with this one; its entity #1 has the "
      "number " +
      std::to_string(by + 1) + " here.");
    this->Files.push_back({ path, by, owner, std::move(roots) });
    return true;
  }

  std::string Add(const std::string& entity, std::string& added)
  {
    const std::string name = "#" + std::to_string(++this->Largest);
    added += name + "=" + entity + ";\n";
    return name;
  }

  /// Makes a product a part of another one, with its frame at the other one's.
  void Place(const STEPCensus& census, std::uint64_t parent, const ShapedProduct& root, std::string& added)
  {
    const auto number = [](std::uint64_t id) { return "#" + std::to_string(id); };
    const auto product = std::find_if(census.Products.begin(), census.Products.end(),
      [parent](const CensusProduct& p) { return p.Id == parent; });
    std::string shape;
    if (product != census.Products.end() && !product->Shapes.empty())
    {
      shape = number(census.Shapes[product->Shapes[0]].Representations[0]);
    }
    const std::string point = this->Add("CARTESIAN_POINT('',(0.,0.,0.))", added);
    const std::string frame = this->Add("AXIS2_PLACEMENT_3D(''," + point + ",$,$)", added);
    if (shape.empty())
    {
      const std::string context =
        this->Add("(GEOMETRIC_REPRESENTATION_CONTEXT(3)REPRESENTATION_CONTEXT('',''))", added);
      shape = this->Add("SHAPE_REPRESENTATION('',(" + frame + ")," + context + ")", added);
      const std::string property = this->Add("PRODUCT_DEFINITION_SHAPE('',''," + number(parent) + ")", added);
      this->Add("SHAPE_DEFINITION_REPRESENTATION(" + property + "," + shape + ")", added);
    }
    const std::string usage = this->Add("NEXT_ASSEMBLY_USAGE_OCCURRENCE('','" + root.Name + "',''," +
        number(parent) + "," + number(root.Id) + ",$)",
      added);
    const std::string property = this->Add("PRODUCT_DEFINITION_SHAPE('',''," + usage + ")", added);
    const std::string motion =
      this->Add("ITEM_DEFINED_TRANSFORMATION('',''," + frame + "," + frame + ")", added);
    const std::string relation = this->Add("(REPRESENTATION_RELATIONSHIP('',''," + number(root.Shape) + "," +
        shape + ")REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(" + motion +
        ")SHAPE_REPRESENTATION_RELATIONSHIP())",
      added);
    this->Add("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(" + relation + "," + property + ")", added);
  }

  std::vector<std::string>& Messages;
  std::vector<JoinedFile> Files;
  std::vector<fs::path> Folders;
  std::uint64_t Largest = 0;
  /// Products and the names of their files that were looked for.
  std::set<std::pair<std::uint64_t, std::string>> Tried;
};
}

std::string JoinSTEPFiles(const std::string& content, const std::string& path,
  const std::vector<std::string>& folders, std::vector<std::string>& messages)
{
  if (content.find(FileEntity) == std::string::npos)
  {
    return {};
  }
  FileJoiner joiner(content, path, folders, messages);
  return joiner.Run() ? std::move(joiner.Text) : std::string();
}
}
