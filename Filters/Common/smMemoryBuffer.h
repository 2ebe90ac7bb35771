/**
 * @file smMemoryBuffer.h
 * @brief Bytes in memory for a std::istream, without a copy
 */
#ifndef smMemoryBuffer_h
#define smMemoryBuffer_h

#include <streambuf>
#include <string_view>

namespace sm
{
/// A stream buffer that reads `bytes`, which must outlive it. It supports seeking.
class MemoryBuffer : public std::streambuf
{
public:
  explicit MemoryBuffer(std::string_view bytes)
  {
    char* first = const_cast<char*>(bytes.data()); // never written: there is no put area
    this->setg(first, first, first + bytes.size());
  }

protected:
  pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode) override
  {
    const off_type size = this->egptr() - this->eback();
    const off_type base = from == std::ios_base::beg ? 0
      : from == std::ios_base::end                   ? size
                                                     : this->gptr() - this->eback();
    if (base + offset < 0 || base + offset > size)
    {
      return pos_type(off_type(-1));
    }
    this->setg(this->eback(), this->eback() + base + offset, this->egptr());
    return pos_type(base + offset);
  }
  pos_type seekpos(pos_type position, std::ios_base::openmode mode) override
  {
    return this->seekoff(off_type(position), std::ios_base::beg, mode);
  }
};
}

#endif
