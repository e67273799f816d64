// An OpenGL buffer that grows as needed and is released by hand, while its context is current.
#ifndef rtwBuffer_h
#define rtwBuffer_h

#include <cstddef>
#include <vector>

namespace rtw
{
class Buffer
{
public:
  Buffer() = default;
  ~Buffer();
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  /// Makes room for at least so many bytes; what was in it survives only where `keep` is set.
  void Reserve(std::size_t bytes, bool keep = false);
  void Write(std::size_t offset, const void* data, std::size_t bytes);
  /// Copies bytes from another buffer, on the GPU.
  void Copy(std::size_t to, const Buffer& other, std::size_t from, std::size_t bytes);
  void Read(std::size_t offset, void* data, std::size_t bytes) const;
  template <class T>
  void Assign(const std::vector<T>& values)
  {
    this->Reserve(values.size() * sizeof(T));
    this->Write(0, values.data(), values.size() * sizeof(T));
  }
  void Clear(); ///< fills it with zeros
  void BindStorage(unsigned int binding) const;
  void BindUniforms(unsigned int binding, std::size_t offset, std::size_t bytes) const;
  void Bind(unsigned int target) const;
  void Release();
  /// Forgets the handle of a context that is gone.
  void Abandon() { this->Id = 0, this->Size = 0; }
  unsigned int GetId() const { return this->Id; }
  std::size_t GetSize() const { return this->Size; }

private:
  unsigned int Id = 0;
  std::size_t Size = 0;
};
}

#endif
