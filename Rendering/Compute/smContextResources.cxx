#include "smContextResources.h"

#include "smOpenGL.h"
#include "smWindowResources.h"

#include <atomic>
#include <utility>

namespace
{
std::atomic<std::uint64_t> LastGeneration{ 0 };
std::atomic<long> LiveBuffers{ 0 };
std::atomic<std::int64_t> LiveBytes{ 0 };
std::atomic<long> LivePrograms{ 0 };
}

namespace sm
{
void ContextResources::AddBuffer(unsigned int name, std::size_t bytes)
{
  this->Buffers[name] = bytes;
  ++LiveBuffers;
  LiveBytes += static_cast<std::int64_t>(bytes);
  this->Window->AddBytes(bytes);
}

void ContextResources::AddProgram(unsigned int name)
{
  this->Programs.insert(name);
  ++LivePrograms;
}

void ContextResources::FreeBuffer(unsigned int name)
{
  const auto found = this->Buffers.find(name);
  if (found != this->Buffers.end())
  {
    LiveBytes -= static_cast<std::int64_t>(found->second);
    this->Window->AllocatedBytes -= found->second;
    --LiveBuffers;
    this->Buffers.erase(found);
    GL::DeleteBuffers(1, &name);
  }
}

void ContextResources::FreeProgram(unsigned int name)
{
  if (this->Programs.erase(name) != 0)
  {
    --LivePrograms;
    GL::DeleteProgram(name);
  }
}

void ContextResources::End(bool current)
{
  while (!this->AtEnd.empty())
  {
    const std::function<void()> callback = std::move(this->AtEnd.begin()->second);
    this->AtEnd.erase(this->AtEnd.begin());
    callback();
  }
  for (const auto& buffer : this->Buffers)
  {
    if (current)
    {
      GL::DeleteBuffers(1, &buffer.first);
    }
    LiveBytes -= static_cast<std::int64_t>(buffer.second);
    this->Window->AllocatedBytes -= buffer.second;
    --LiveBuffers;
  }
  for (const unsigned int program : this->Programs)
  {
    if (current)
    {
      GL::DeleteProgram(program);
    }
    --LivePrograms;
  }
  if (this->Stage && current)
  {
    this->Stage->Free();
  }
  this->Stage = nullptr;
  this->Buffers.clear();
  this->Programs.clear();
  this->Window = nullptr;
  this->Generation = 0;
  this->MaximumStorageBlockSize = 0;
  this->StorageOffsetAlignment = 0;
  this->MaximumWorkGroupCount[0] = this->MaximumWorkGroupCount[1] = 0;
}

std::uint64_t ContextResources::NewGeneration()
{
  return ++LastGeneration;
}

long ContextResources::GetLiveBuffers()
{
  return LiveBuffers;
}

std::int64_t ContextResources::GetLiveBytes()
{
  return LiveBytes;
}

long ContextResources::GetLivePrograms()
{
  return LivePrograms;
}
}
