#include "smMessageList.h"

#include "smInstanceNames.h"

#include "vtkCADReader.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkNURBSDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkSurfaceIntegralBase.h"
#include "vtkTrimmedNURBSModel.h"

#include <algorithm>

namespace
{
/// Returns true for the reader's summary of a model's messages: the first one, with the body's name.
bool IsSummary(const std::string& message, vtkTrimmedNURBSModel* model)
{
  if (model->GetMessages().empty())
  {
    return false;
  }
  const std::string id = model->GetFileId() > 0 ? " (#" + std::to_string(model->GetFileId()) + ")" : "";
  const std::string start = "Body \"" + model->GetName() + "\"" + id + ": " + model->GetMessages().front();
  return message == start || message.rfind(start + " (and ", 0) == 0;
}

/// Returns true if a message of the filter is that of a face, which the model has among its own messages.
bool IsOfFace(const std::string& fact, const std::vector<std::string>& said)
{
  const size_t colon = fact.find(": ");
  if (fact.rfind("face #", 0) != 0 || colon == std::string::npos)
  {
    return false;
  }
  const std::string text = fact.substr(colon);
  const bool isNumbered = fact.rfind("face #0:", 0) != 0;
  return std::any_of(said.begin(), said.end(),
    [&](const std::string& old)
    {
      return isNumbered ? old == "F" + fact.substr(1)
                        : old.rfind("Face number ", 0) == 0 && old.size() > text.size() &&
          old.compare(old.size() - text.size(), text.size(), text) == 0;
    });
}
}

namespace sm
{
void MessageList::AddReader(vtkCADReader* reader)
{
  this->CollectBodies(reader);
  this->LabelBodies();
  for (int i = 0; i < reader->GetNumberOfMessages(); ++i)
  {
    const std::string message = reader->GetMessage(i);
    this->Heard.push_back(message);
    if (std::none_of(this->Bodies.begin(), this->Bodies.end(),
          [&](const Body& body) { return IsSummary(message, body.Model); }))
    {
      this->Add(message);
    }
  }
  for (Body& body : this->Bodies)
  {
    for (const std::string& message : body.Model->GetMessages())
    {
      this->AddFact(body, message);
    }
  }
}

void MessageList::AddFilter(vtkSurfaceIntegralBase* filter)
{
  for (int i = 0; i < filter->GetNumberOfMessages(); ++i)
  {
    const std::string message = filter->GetMessage(i);
    this->Heard.push_back(message);
    // The message is "instance: fact", and both may contain colons.
    auto found = this->BodiesByName.end();
    size_t colon = message.find(": ");
    for (; colon != std::string::npos && found == this->BodiesByName.end();
         colon = message.find(": ", colon + 1))
    {
      found = this->BodiesByName.find(message.substr(0, colon));
      if (found != this->BodiesByName.end())
      {
        break;
      }
    }
    if (found == this->BodiesByName.end())
    {
      this->Add(message);
      continue;
    }
    const std::string fact = message.substr(colon + 2);
    const std::vector<size_t>& places = found->second;
    const bool isSaid = std::any_of(places.begin(), places.end(),
      [&](size_t place)
      {
        const Body& body = this->Bodies[place];
        return body.Said.count(fact) > 0 || IsOfFace(fact, body.Model->GetMessages());
      });
    if (!isSaid && places.size() == 1)
    {
      this->AddFact(this->Bodies[places.front()], fact);
    }
    else if (!isSaid)
    {
      this->Add(message); // several bodies have this name
    }
  }
}

void MessageList::AddEcho(const std::string& message)
{
  if (std::none_of(this->Heard.begin(), this->Heard.end(),
        [&](const std::string& old) { return message.find(old) != std::string::npos; }))
  {
    this->Heard.push_back(message);
    this->Add(message);
  }
}

void MessageList::CollectBodies(vtkCADReader* reader)
{
  auto* parts = vtkPartitionedDataSetCollection::SafeDownCast(reader->GetOutputDataObject(0));
  std::map<vtkTrimmedNURBSModel*, size_t> places;
  for (unsigned int i = 0; parts && i < parts->GetNumberOfPartitionedDataSets(); ++i)
  {
    for (unsigned int j = 0; j < parts->GetNumberOfPartitions(i); ++j)
    {
      auto* leaf = vtkNURBSDataSet::SafeDownCast(parts->GetPartitionAsDataObject(i, j));
      vtkTrimmedNURBSModel* model = leaf ? leaf->GetModel() : nullptr;
      if (!model)
      {
        continue;
      }
      const char* given =
        parts->HasMetaData(i) ? parts->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()) : nullptr;
      const std::string name = GetPartName(*leaf, given ? given : "");
      const auto [place, isNew] = places.emplace(model, this->Bodies.size());
      if (isNew)
      {
        this->Bodies.push_back({ model, name, {} });
      }
      std::vector<size_t>& named = this->BodiesByName[name];
      if (std::find(named.begin(), named.end(), place->second) == named.end())
      {
        named.push_back(place->second);
      }
    }
  }
}

void MessageList::LabelBodies()
{
  for (Body& body : this->Bodies)
  {
    const vtkTypeInt64 id = body.Model->GetFileId();
    if (id > 0 && this->BodiesByName[body.Label].size() > 1)
    {
      body.Label += " (#" + std::to_string(id) + ")";
    }
  }
}

void MessageList::Add(const std::string& message)
{
  if (!message.empty() &&
    std::find(this->Messages.begin(), this->Messages.end(), message) == this->Messages.end())
  {
    this->Messages.push_back(message);
  }
}

void MessageList::AddFact(Body& body, const std::string& fact)
{
  if (body.Said.insert(fact).second)
  {
    this->Add(body.Label.empty() ? fact : body.Label + ": " + fact);
  }
}
}
