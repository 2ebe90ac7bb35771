/**
 * @file TestSTEPReaderErrors.cxx
 * @brief vtkSTEPReader at its edge: unreadable and damaged files, settings, nested and stopped runs,
 * exceptions, little memory
 *
 * Usage: TestSTEPReaderErrors FOLDER [memory], a folder for the files it writes; with little memory.
 */
#include "smCensusSamples.h"
#include "smFileState.h"
#include "smReaderTesting.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkSTEPWriter.h"
#include "vtkTrimmedNURBSModel.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{
using namespace smtest;

void CheckFails(const std::string& path, const char* status, const char* word)
{
  vtkNew<vtkSTEPReader> reader;
  ErrorLog log;
  ErrorLog executive;
  log.Watch(reader);
  executive.Watch(reader->GetExecutive());
  reader->SetFileName(path.c_str());
  reader->Update();
  CheckEqual("errors for " + path, 1, log.Count);
  CheckTrue("  names the file", log.Text.find(path) != std::string::npos, log.Text);
  CheckTrue(std::string("  says ") + word, log.Text.find(word) != std::string::npos);
  CheckEqual("  status", status, reader->GetStatusAsString());
  CheckEqual("  output is empty", 0, reader->GetOutput()->GetNumberOfPartitionedDataSets());
  CheckTrue("  has a message", reader->GetNumberOfMessages() > 0);
}

void CheckUnreadable(const std::string& text)
{
  CheckFails(Folder + "/does_not_exist.step", "unreadable", "opened");
  CheckFails(Make("reader_nothing.step", ""), "unreadable", "empty");
  CheckFails(Make("reader_text.step", "solid cube\nfacet normal 0 0 1\n"), "unreadable", "not a STEP file");
  CheckFails(Make("reader_gzip.step", "\x1f\x8b\x08 and so on"), "unreadable", "gzip");
  CheckFails(
    Make("reader_header.step", text.substr(0, text.find("DATA;")) + "DATA;\nENDSEC;\nEND-ISO-10303-21;\n"),
    "empty", "no solid");
  CheckFails(Make("reader_cut.step", text.substr(0, text.size() / 8)), "unreadable", "export it again");
  CheckFails(Folder, "unreadable", "it is a folder");
}

void CheckSettings(const std::string& good)
{
  vtkNew<vtkSTEPReader> nameless;
  ErrorLog log;
  log.Watch(nameless);
  ErrorLog ignored;
  ignored.Watch(nameless->GetExecutive());
  nameless->Update();
  CheckEqual("no file name is one error", 1, log.Count);
  nameless->SetFileName(good.c_str());
  nameless->SetOutputUnit("parsec");
  nameless->Update();
  CheckTrue(
    "an unknown unit is named", log.Count == 2 && log.Text.find("parsec") != std::string::npos, log.Text);
  nameless->SetOutputUnit("mm");
  nameless->Update();
  CheckEqual("the reader recovers", 3, nameless->GetOutput()->GetNumberOfPartitionedDataSets());
}

/// Junk before the header is skipped, and said.
void CheckJunk(const std::string& text)
{
  const std::string junk = Make("reader_junk.step", "xyz " + text);
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(junk.c_str());
  reader->Update();
  CheckEqual("junk is skipped", 3, reader->GetNumberOfInstances());
  CheckTrue("junk is said", reader->GetMessage(0).find("before \"ISO-10303-21;\"") != std::string::npos);
  CheckEqual("CanReadFile", 1, vtkSTEPReader::CanReadFile(junk.c_str()));
  CheckEqual(
    "CanReadFile of text", 0, vtkSTEPReader::CanReadFile(Make("reader_text.txt", "no step").c_str()));
  CheckEqual("CanReadFile of text with a STEP file's name, of which reading reports why", 1,
    vtkSTEPReader::CanReadFile(Make("reader_text.STEP", "no step").c_str()));
  CheckEqual("CanReadFile of a file that is not there", 0, vtkSTEPReader::CanReadFile("/nowhere/part.step"));
  CheckEqual("CanReadFile of nothing", 0, vtkSTEPReader::CanReadFile(nullptr));
}

/// The one face with a reference to an entity that is not there is left out. OpenCASCADE alone reads the file
/// without it, too.
void CheckDamage(const std::string& text)
{
  vtkNew<vtkSTEPReader> reader;
  std::string broken = text;
  const std::size_t surface = broken.find("),#", broken.find("ADVANCED_FACE('',(")) + 2;
  CheckTrue("a face to break", surface > 2 && surface < broken.size());
  broken.replace(surface, broken.find(',', surface) - surface, "#99999999");
  const std::string damaged = Make("reader_damaged.step", broken);
  reader->SetFileName(damaged.c_str());
  reader->Update();
  CheckEqual("status of a damaged file", "ok", reader->GetStatusAsString());
  CheckEqual("one face is left out", 6, GetLeaf(reader, 0)->GetModel()->GetNumberOfFaces());
  CheckEqual("and counted", 1, GetLeaf(reader, 0)->GetModel()->GetNumberOfMissingFaces());
  CheckEqual("in its body only", 0, GetLeaf(reader, 2)->GetModel()->GetNumberOfMissingFaces());
  CheckTrue("and said",
    reader->GetMessage(0).find("undefined reference; export the file again") != std::string::npos,
    reader->GetMessage(0));
}

/// An edge between one vertex and itself, whose curve goes elsewhere.
void CheckWrongVertex(const std::string& text)
{
  vtkNew<vtkSTEPReader> reader;
  const std::regex ends("EDGE_CURVE\\('',(#[0-9]+),(#[0-9]+),");
  reader->SetFileName(Make("reader_vertex.step",
    std::regex_replace(text, ends, "EDGE_CURVE('',$1,$1,", std::regex_constants::format_first_only))
                        .c_str());
  reader->Update();
  vtkTrimmedNURBSModel* torn = GetLeaf(reader, 0)->GetModel();
  CheckTrue("a wrong vertex is a defect, or its faces are missing",
    torn->GetNumberOfDefects() + torn->GetNumberOfMissingFaces() > 0);
  vtkNew<vtkTrimmedNURBSModel> copy;
  copy->ShallowCopy(torn);
  CheckEqual("which a copy has too", torn->GetNumberOfDefects(), copy->GetNumberOfDefects());
}

/// Instances with a scale: OpenCASCADE's reader loses it, which is a defect; ours applies it.
void CheckScale(const std::string& text)
{
  vtkNew<vtkSTEPReader> reader;
  const std::regex part(
    "(#[0-9]+) = (ADVANCED_BREP_SHAPE_REPRESENTATION\\('',\\((#[0-9]+),#[0-9]+\\),(#[0-9]+)\\);)");
  reader->SetFileName(Make("reader_scaled.step",
    std::regex_replace(text, part,
      "$1 = SHAPE_REPRESENTATION('',($3,#900001),$4);\n#900000 = $2\n"
      "#900001 = MAPPED_ITEM('',#900002,#900003);\n#900002 = REPRESENTATION_MAP($3,#900000);\n"
      "#900003 = CARTESIAN_TRANSFORMATION_OPERATOR_3D('','','',$$,$$,#900004,2.5,$$);\n"
      "#900004 = CARTESIAN_POINT('',(100.,0.,0.));",
      std::regex_constants::format_first_only))
                        .c_str());
  const auto measure = [&reader](int& defects)
  {
    reader->Update();
    double largest = 0.0;
    defects = 0;
    for (int i = 0; i < reader->GetNumberOfInstances(); ++i)
    {
      vtkTrimmedNURBSModel* const model = GetLeaf(reader, i)->GetModel();
      defects += model->GetNumberOfDefects();
      largest = std::max(largest, GetLeaf(reader, i)->GetLength());
    }
    return largest;
  };
  int defects = 0;
  const double scaled = measure(defects);
  CheckEqual("a scale is applied without defects", 0, defects);
  reader->SetFileName(Make("reader_unscaled.step", text).c_str());
  const double unscaled = measure(defects);
  Check("the scale", 2.5, scaled / unscaled, 1e-6, "boxes of meshes");
}

/// A ball in a box, with `more` entities. Returns whether its body is defective; `said` must be in a message,
/// nothing means no message.
void CheckDeclared(const std::string& name, const std::string& more, bool isDefect, const std::string& said)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(
    Make("reader_declared.step", MakeStepText(GetBallText() + GetAssemblyText() + more)).c_str());
  reader->Update();
  std::string messages;
  for (int i = 0; i < reader->GetNumberOfMessages(); ++i)
  {
    messages += reader->GetMessage(i) + "\n";
  }
  CheckEqual(name + ": bodies", 1, reader->GetNumberOfBodies());
  CheckEqual("  a defect", isDefect, !sm::GetFileState(reader->GetOutput()).Defects.empty());
  CheckTrue("  said", said.empty() ? messages.empty() : messages.find(said) != std::string::npos, messages);
}

/// Files whose bodies are all of kinds that are not supported: valid, not damaged.
void CheckUnsupported()
{
  const std::string empty =
    Replace(Replace(GetBallText(), "#31=MANIFOLD_SOLID_BREP('ball',#30);\n", ""), "(#23,#31)", "(#23,#75)");
  const std::pair<const char*, const char*> kinds[] = {
    { "#75=CSG_SOLID('',#76);\n#76=BOOLEAN_RESULT('',.DIFFERENCE.,#77,#78);\n#77=BLOCK('',#23,1.,2.,3.);\n"
      "#78=SPHERE('',0.5,#20);\n",
      "it has only constructive solid geometry (CSG), which is not supported: body #75 is of the type "
      "CSG_SOLID; export it as a" },
    { "#75=EXTRUDED_AREA_SOLID('',#76,#21,5.);\n#76=CURVE_BOUNDED_SURFACE('',#24,(#77),.T.);\n#77=CIRCLE('',#"
      "23,1.);\n",
      "it has only swept solids, which are not supported: body #75 is of the type EXTRUDED_AREA_SOLID; "
      "export" },
    { "#75=TESSELLATED_SOLID('',(#76),$);\n#76=TRIANGULATED_FACE('',#77,3,((0.,0.,1.)),$,(),((1,2,3)));\n"
      "#77=COORDINATES_LIST('',3,((0.,0.,0.),(1.,0.,0.),(0.,1.,0.)));\n",
      "it has triangles only: body #75 is of the type TESSELLATED_SOLID; export" },
  };
  for (const auto& [entities, said] : kinds)
  {
    vtkNew<vtkSTEPReader> reader;
    ErrorLog log;
    log.Watch(reader);
    ErrorLog executive;
    executive.Watch(reader->GetExecutive());
    reader->SetFileName(Make("reader_unsupported.step", MakeStepText(empty + entities)).c_str());
    reader->Update();
    CheckEqual("not supported: status", "unreadable", reader->GetStatusAsString());
    CheckTrue("  said", log.Text.find(said) != std::string::npos, log.Text);
    CheckTrue("  not called damaged", log.Text.find("damaged") == std::string::npos);
  }
}

/// Bodies and parts that the file declares and nothing is read of.
void CheckUnreadParts()
{
  const std::string product =
    "#70=PRODUCT('other','other','',(#40));\n#71=PRODUCT_DEFINITION_FORMATION('','',#70);\n"
    "#72=PRODUCT_DEFINITION('design','',#71,#43);\n";
  const std::string shape = product +
    "#73=PRODUCT_DEFINITION_SHAPE('','',#72);\n#74=SHAPE_REPRESENTATION('',(#75),#6);\n"
    "#76=SHAPE_DEFINITION_REPRESENTATION(#73,#74);\n";
  for (const char* type : { "TETRAHEDRON", "CONVEX_HEXAHEDRON", "RECTANGULAR_PYRAMID", "SOLID_WITH_HOLE",
         "MODIFIED_SOLID", "THICKENED_FACE_SOLID", "TRIMMED_VOLUME", "EXTRUDED_FACE_SOLID_WITH_DRAFT_ANGLE" })
  {
    CheckDeclared(type, shape + "#75=" + type + "('',#23);\n", true,
      std::string("Solid #75 of the file is of the type ") + type + ", which has no faces");
  }
  const std::string triangles = "of triangles instead of exact faces: it is left out";
  CheckDeclared("triangles", shape + "#75=TESSELLATED_SOLID('t',(#77),$);\n", true, triangles);
  CheckDeclared("triangles of the ball", shape + "#75=TESSELLATED_SOLID('t',(#77),#31);\n", false, "");
  CheckDeclared("triangles next to the ball",
    "#74=SHAPE_REPRESENTATION('',(#75),#6);\n#75=TESSELLATED_SOLID('t',(#77),$);\n"
    "#76=SHAPE_DEFINITION_REPRESENTATION(#45,#74);\n",
    false, "");
  // The ball has the radius 5 about the origin.
  for (const bool isElsewhere : { false, true })
  {
    CheckDeclared(isElsewhere ? "triangles elsewhere" : "triangles of the same place",
      std::string("#74=SHAPE_REPRESENTATION('',(#75),#6);\n#75=TESSELLATED_SOLID('t',(#77),$);\n"
                  "#76=SHAPE_DEFINITION_REPRESENTATION(#45,#74);\n"
                  "#77=TRIANGULATED_FACE('',#78,3,(),$,(1,2,3),((1,2,3)));\n#78=COORDINATES_LIST('',3,(("
                  "-5.,0.,0.),(0.,5.,0.),(0.,0.,") +
        (isElsewhere ? "15." : "5.") + ")));\n",
      isElsewhere, isElsewhere ? triangles : "");
  }
  CheckDeclared("annotations", shape + "#75=TESSELLATED_GEOMETRIC_SET('t',(#77));\n", false, triangles);

  const std::string part = "#80=NEXT_ASSEMBLY_USAGE_OCCURRENCE('2','second','',#52,#72,$);\n";
  CheckDeclared("a part without a shape", product + part, false,
    "1 product in assemblies of the file without a shape: #72.");
  // The file is in the working directory, and not in the folder of the assembly.
  const std::string workplace = Folder + "/workplace";
  mkdir(workplace.c_str(), 0777);
  Make("workplace/elsewhere.step", MakeStepText(GetBallText()));
  CheckEqual("working directory", 0, chdir(workplace.c_str()));
  const std::string document =
    "#81=DOCUMENT_TYPE('');\n#82=DOCUMENT_FILE('elsewhere.step','','',#81,'',$);\n";
  const std::string elsewhere =
    "Product #72 \"other\" of an assembly has its shape in another file, elsewhere.step, which is not read";
  const std::string reference = "#83=APPLIED_DOCUMENT_REFERENCE(#82,'',(#72));\n";
  CheckDeclared("a part in a file", product + part + document + reference, true, elsewhere);
  CheckDeclared("a part with an axis in a file",
    shape + "#75=AXIS2_PLACEMENT_3D('',#20,#21,#22);\n" + part + document + reference, true, elsewhere);
  CheckDeclared("a product with documents",
    Replace(product, "PRODUCT_DEFINITION('design','',#71,#43)",
      "PRODUCT_DEFINITION_WITH_ASSOCIATED_DOCUMENTS('design','',#71,#43,(#82))") +
      part + document,
    true, elsewhere);
  CheckDeclared("a document of the ball", document + Replace(reference, "#72", "#44"), false, "");

  const auto quantity = [](const char* number)
  {
    return std::string("#90=DIMENSIONAL_EXPONENTS(0.,0.,0.,0.,0.,0.,0.);\n#91=NAMED_UNIT(#90);\n"
                       "#92=MEASURE_WITH_UNIT(COUNT_MEASURE(") +
      number + "),#91);\n#93=QUANTIFIED_ASSEMBLY_COMPONENT_USAGE('5','','',#52,#44,$,#92);\n";
  };
  CheckDeclared("a quantity", quantity("5."), true,
    "Product #44 \"ball\" occurs 5 times in product #52 by the quantity #93 of the file, which places it 1 "
    "time");
  CheckDeclared("the quantity that is placed", quantity("1."), false, "");
}

/// A reader inside an observer of another one's progress reads, and the other one goes on.
void CheckNested(const std::string& path)
{
  struct Client
  {
    std::string Path;
    ErrorLog Log;
    int Runs = 0;
    int Instances = 0;
  } client;
  client.Path = path;
  vtkNew<vtkCallbackCommand> callback;
  callback->SetClientData(&client);
  callback->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* c = static_cast<Client*>(data);
      const double progress = static_cast<vtkSTEPReader*>(caller)->GetProgress();
      if (c->Runs > 0 || progress < 0.1 || progress >= 1.0)
      {
        return;
      }
      ++c->Runs;
      vtkNew<vtkSTEPReader> inner;
      c->Log.Watch(inner);
      inner->SetFileName(c->Path.c_str());
      inner->Update();
      c->Instances = inner->GetNumberOfInstances();
    });
  vtkNew<vtkSTEPReader> reader;
  reader->AddObserver(vtkCommand::ProgressEvent, callback);
  reader->SetFileName(path.c_str());
  reader->Update();
  CheckEqual("a nested reader ran", 1, client.Runs);
  CheckEqual("without an error", 0, client.Log.Count);
  CheckEqual("the whole file", 3, client.Instances);
  CheckEqual("the outer one goes on", 3, reader->GetNumberOfInstances());
}

/// Stops at the first report of at least `threshold`.
void CheckAbort(const std::string& path, double threshold)
{
  vtkNew<vtkSTEPReader> reader;
  ErrorLog log;
  log.Watch(reader);
  vtkNew<vtkCallbackCommand> stop;
  stop->SetClientData(&threshold);
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void* minimum, void* progress)
    {
      if (*static_cast<double*>(progress) >= *static_cast<double*>(minimum))
      {
        static_cast<vtkSTEPReader*>(caller)->SetAbortExecute(1);
      }
    });
  reader->AddObserver(vtkCommand::ProgressEvent, stop);
  reader->SetFileName(path.c_str());
  reader->Update();
  CheckEqual("stopped", "aborted", reader->GetStatusAsString());
  CheckEqual("without an error", 0, log.Count);
  CheckEqual("and empty", 0, reader->GetOutput()->GetNumberOfPartitionedDataSets());
}

/// The limit is over at the first report; without it the same reader goes on.
void CheckTimeLimit(const std::string& path)
{
  vtkNew<vtkSTEPReader> reader;
  ErrorLog log;
  log.Watch(reader);
  reader->SetFileName(path.c_str());
  reader->SetMaximumSeconds(1e-9);
  reader->Update();
  CheckEqual("too slow", "aborted", reader->GetStatusAsString());
  CheckTrue("and says so",
    reader->GetNumberOfMessages() > 0 &&
      reader->GetMessage(reader->GetNumberOfMessages() - 1).find("maximum seconds") != std::string::npos);
  CheckEqual("without an error", 0, log.Count);
  CheckEqual("and empty", 0, reader->GetOutput()->GetNumberOfPartitionedDataSets());
  reader->SetMaximumSeconds(0.0);
  reader->Update();
  CheckEqual("without a limit", "ok", reader->GetStatusAsString());
}

/// An exception that an observer throws while the file is read is an error, whatever its type.
void CheckExceptions(const std::string& path)
{
  struct Client
  {
    double Threshold = 0.0;
    bool Standard = true;
  } client;
  vtkNew<vtkCallbackCommand> callback;
  callback->SetClientData(&client);
  callback->SetCallback(
    [](vtkObject*, unsigned long, void* data, void* progress)
    {
      const auto* c = static_cast<Client*>(data);
      const double fraction = *static_cast<double*>(progress);
      if (fraction >= c->Threshold && fraction < 1.0)
      {
        if (c->Standard)
        {
          throw std::runtime_error("thrown by an observer");
        }
        throw 5;
      }
    });
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(path.c_str());
  ErrorLog log;
  ErrorLog executive;
  log.Watch(reader);
  executive.Watch(reader->GetExecutive());
  const unsigned long tag = reader->AddObserver(vtkCommand::ProgressEvent, callback);
  int errors = 0;
  // While the file is parsed, before the first body, and with a body in hand.
  for (const double threshold : { 0.01, 0.5, 0.76 })
  {
    client = { threshold, false };
    reader->Modified();
    bool crossed = false;
    try
    {
      reader->Update();
    }
    catch (...)
    {
      crossed = true;
    }
    const std::string what = "an exception at " + std::to_string(threshold);
    CheckTrue(what + " stays inside", !crossed);
    CheckEqual(what + " is an error", ++errors, log.Count);
    CheckEqual(what + ": status", "unreadable", reader->GetStatusAsString());
    CheckEqual(what + ": leaves", 0, reader->GetOutput()->GetNumberOfPartitionedDataSets());
  }
  client = { 0.5, true };
  reader->Modified();
  reader->Update();
  CheckTrue(
    "a standard one is quoted", log.Text.find("thrown by an observer") != std::string::npos, log.Text);
  reader->RemoveObserver(tag);
  reader->Modified();
  reader->Update();
  CheckEqual("and the reader recovers", 3, reader->GetNumberOfInstances());
}

/// Lets the stack grow as far as reading may need it: where it cannot grow later, the process ends without an
/// error.
[[gnu::noinline]] void GrowStack()
{
  volatile char bytes[1 << 20];
  for (std::size_t i = 0; i < sizeof(bytes); i += 1024)
  {
    bytes[i] = 0;
  }
}

/// Reads and writes with no more than `extra` bytes of address space than now. 0: done, 1: an error said why
/// not.
int RunWithMemory(const std::string& path, const std::string& copy, std::size_t extra)
{
  GrowStack();
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  vtkNew<vtkSTEPReader> reader;
  vtkNew<vtkSTEPWriter> writer;
  ErrorLog log;
  ErrorLog ignored;
  log.Watch(reader);
  log.Watch(writer);
  ignored.Watch(reader->GetExecutive());
  ignored.Watch(writer->GetExecutive());
  reader->SetFileName(path.c_str());
  writer->SetInputConnection(reader->GetOutputPort());
  writer->SetFileName(copy.c_str());
  const rlim_t bytes = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + extra;
  const rlimit limit{ bytes, bytes };
  setrlimit(RLIMIT_AS, &limit);
  const bool written = writer->Write() != 0;
  const bool said = log.Count > 0 && writer->GetErrorCode() != vtkErrorCode::NoError;
  return written && log.Count == 0 ? 0 : !written && said ? 1 : 2;
}

/// Reads and writes in child processes that have less and less memory.
void CheckMemory(const std::string& path)
{
  const std::string copy = Folder + "/reader_memory.step";
  int done = 0;
  int failed = 0;
  for (const std::size_t kibibytes :
    { 0, 256, 512, 1024, 2048, 3072, 4096, 4352, 4608, 4864, 5120, 5376, 5632, 5888, 6144, 8192, 524288 })
  {
    std::remove(copy.c_str());
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0)
    {
      _exit(RunWithMemory(path, copy, kibibytes << 10));
    }
    int status = 0;
    waitpid(child, &status, 0);
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    CheckTrue("with " + std::to_string(kibibytes) + " KiB: done, or an error", code < 2,
      "exit status " + std::to_string(code));
    CheckTrue("  a file is there when it is done", (code == 0) == static_cast<bool>(std::ifstream(copy)));
    done += code == 0 ? 1 : 0;
    failed += code == 1 ? 1 : 0;
  }
  CheckTrue("enough memory is enough", done > 0, std::to_string(done));
  CheckTrue("too little is too little", failed > 2, std::to_string(failed));
}
}

int TestSTEPReaderErrors(int argc, char* argv[])
{
  if (argc < 2)
  {
    std::fprintf(stderr, "usage: %s FOLDER [memory]\n", argv[0]);
    return EXIT_FAILURE;
  }
  Folder = argv[1];
  const std::string mode = argc > 2 ? argv[2] : "";
  const std::string good = Folder + "/reader_errors" + mode + ".step";
  WriteAssembly(good);
  if (mode == "memory")
  {
    CheckMemory(good);
    return Finish();
  }
  const std::string text = ReadAll(good);
  CheckTimeLimit(good);
  CheckAbort(good, 0.0);
  // The last body's triangles, and its faces.
  CheckAbort(good, 0.76);
  CheckAbort(good, 0.96);
  CheckNested(good);
  CheckExceptions(good);
  CheckUnreadable(text);
  CheckSettings(good);
  CheckJunk(text);
  CheckDamage(text);
  CheckWrongVertex(text);
  CheckScale(text);
  CheckUnsupported();
  CheckUnreadParts();
  return Finish();
}
