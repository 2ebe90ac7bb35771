#include "smBREPDocument.h"

#include "smMemoryBuffer.h"
#include "smOCCTFailure.h"
#include "smOCCTFile.h"
#include "smOCCTProducts.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <TDF_Label.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shape.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <cctype>
#include <istream>
#include <map>
#include <utility>

namespace sm
{
namespace
{
constexpr std::string_view TextMagic = "CASCADE Topology V";
constexpr std::string_view BinaryMagic = "Open CASCADE Topology V";
/// A file that OpenCASCADE's test harness wrote begins with it.
constexpr std::string_view HarnessMagic = "DBRep_DrawableShape";

std::string_view SkipBlanks(std::string_view text)
{
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())))
  {
    text.remove_prefix(1);
  }
  return text;
}

bool StartsWith(std::string_view text, std::string_view start)
{
  return text.compare(0, start.size(), start) == 0;
}

bool IsText(std::string_view bytes)
{
  std::string_view text = SkipBlanks(bytes);
  if (StartsWith(text, HarnessMagic))
  {
    text = SkipBlanks(text.substr(HarnessMagic.size()));
  }
  return StartsWith(text, TextMagic);
}

/// A text ends with the reference to its last shape, "+1 0", behind the asterisk that ends the table of shapes.
bool IsWhole(std::string_view text)
{
  const std::size_t end = text.find_last_not_of(" \t\r\n");
  const std::size_t asterisk = text.find_last_of('*', end);
  if (end == std::string_view::npos || asterisk == std::string_view::npos || asterisk == end)
  {
    return false;
  }
  const std::string_view reference = SkipBlanks(text.substr(asterisk + 1, end - asterisk));
  return reference.size() > 3 && std::string_view("+-ie").find(reference.front()) != std::string_view::npos &&
    reference.find(' ') != std::string_view::npos && text.size() > end + 1;
}

/// Makes the products of a shape as an XCAF document has them.
class ProductMaker
{
public:
  explicit ProductMaker(const Handle(TDocStd_Document) & xde)
    : Shapes(XCAFDoc_DocumentTool::ShapeTool(xde->Main()))
  {
  }

  void Add(const TopoDS_Shape& shape)
  {
    if (shape.Location().IsIdentity())
    {
      this->GetProduct(shape);
    }
    else
    {
      const TDF_Label root = this->Shapes->NewShape();
      this->Shapes->AddComponent(root, this->GetProduct(shape.Located(TopLoc_Location())), shape.Location());
    }
    this->Shapes->UpdateAssemblies();
  }

private:
  /// Every member is a solid, or a compound that has some; a group of faces is one part.
  static bool IsAssembly(const TopoDS_Shape& shape)
  {
    if (shape.ShapeType() > TopAbs_COMPSOLID)
    {
      return false;
    }
    int members = 0;
    for (TopoDS_Iterator it(shape, Standard_False, Standard_False); it.More(); it.Next(), ++members)
    {
      if (!TopExp_Explorer(it.Value(), TopAbs_SOLID).More())
      {
        return false;
      }
    }
    return members > 0;
  }

  /// `shape` has no location.
  TDF_Label GetProduct(const TopoDS_Shape& shape)
  {
    const auto key =
      std::make_pair(static_cast<const void*>(shape.TShape().get()), static_cast<int>(shape.Orientation()));
    const auto known = this->Products.find(key);
    if (known != this->Products.end())
    {
      return known->second;
    }
    const TDF_Label product = this->Shapes->NewShape();
    this->Products.emplace(key, product);
    if (!IsAssembly(shape))
    {
      this->Shapes->SetShape(product, shape);
      return product;
    }
    // The members' orientations include that of the assembly, whose label has none.
    for (TopoDS_Iterator it(shape, Standard_True, Standard_False); it.More(); it.Next())
    {
      const TopoDS_Shape& member = it.Value();
      this->Shapes->AddComponent(
        product, this->GetProduct(member.Located(TopLoc_Location())), member.Location());
    }
    return product;
  }

  Handle(XCAFDoc_ShapeTool) Shapes;
  std::map<std::pair<const void*, int>, TDF_Label> Products;
};

void Read(std::string_view bytes, const ProgressCallback& progress, Document& document)
{
  TopoDS_Shape shape;
  MemoryBuffer buffer(bytes);
  std::istream stream(&buffer);
  const Handle(KernelProgress) indicator = new KernelProgress(progress);
  if (IsText(bytes))
  {
    BRepTools::Read(shape, stream, BRep_Builder(), indicator->Start());
  }
  else
  {
    BinTools::Read(shape, stream, indicator->Start());
  }
  indicator->Rethrow();
  if (!progress(1.0))
  {
    document.Status = ReadStatus::Aborted;
    return;
  }
  if (shape.IsNull() || stream.fail())
  {
    document.Problem = "OpenCASCADE cannot parse it: it is damaged, or of a newer version; save it again";
    return;
  }
  const Handle(TDocStd_Document) xde = new TDocStd_Document("BinXCAF");
  SetMillimetres(xde);
  ProductMaker(xde).Add(shape);
  AddProducts(xde, document);
  document.Status = document.Bodies.empty() ? ReadStatus::Empty : ReadStatus::Ok;
  if (document.Bodies.empty())
  {
    document.Problem = "it has no solid, shell or face";
  }
}
}

bool LooksLikeBREP(std::string_view bytes)
{
  return IsText(bytes) || StartsWith(SkipBlanks(bytes), BinaryMagic);
}

Document ReadBREP(std::string_view bytes, const ProgressCallback& progress)
{
  Document document;
  if (!LooksLikeBREP(bytes))
  {
    document.Problem = "it is not a BREP file of OpenCASCADE: \"CASCADE Topology\" is missing at its start";
    return document;
  }
  if (IsText(bytes) && !IsWhole(bytes))
  {
    document.Problem = "it ends in the middle: copy or save it again";
    return document;
  }
  const std::string failure = CatchFailure([&]() { Read(bytes, progress, document); });
  if (!failure.empty())
  {
    document.Status = ReadStatus::Unreadable;
    document.Problem = "it could not be read (" + failure + "); save it again";
  }
  return document;
}
}
