// A GLSL program of our own, beside VTK's: built from files that are laid end to end.
#ifndef rtwProgram_h
#define rtwProgram_h

#include <initializer_list>
#include <string>

namespace rtw
{
class Program
{
public:
  struct Stage
  {
    unsigned int Kind; ///< GL_VERTEX_SHADER and so on
    std::initializer_list<const char*> Parts;
  };

  Program() = default;
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// Compiles and links unless that is done already. Each part is a file or a few definitions; that version of GLSL goes
  /// before them. On failure GetLog() says why and every later call fails at once.
  bool Build(std::initializer_list<Stage> stages, int version = 430);
  bool IsBuilt() const { return this->Id != 0; }
  const std::string& GetLog() const { return this->Log; }
  void Use() const;
  int Location(const char* uniform) const;
  void Set(const char* uniform, int value) const;
  void Set(const char* uniform, float value) const;
  void Set(const char* uniform, float x, float y) const;
  void Set(const char* uniform, float x, float y, float z) const;
  void SetMatrix(const char* uniform, const float* columns) const;
  /// Sets the binding at which a uniform block finds its buffer, if the program has such a block.
  void SetBlock(const char* block, unsigned int binding) const;
  void Release();
  void Abandon() { this->Id = 0, this->Failed = false; }

private:
  unsigned int Id = 0;
  bool Failed = false;
  std::string Log;
};
}

#endif
