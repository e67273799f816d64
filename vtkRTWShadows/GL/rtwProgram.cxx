#include "GL/rtwProgram.h"

#include "GL/rtwOpenGL.h"

#include <vector>

namespace rtw
{
namespace
{
std::string ShaderLog(GLuint shader)
{
  GLint length = 0;
  glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length) + 1, '\0');
  glGetShaderInfoLog(shader, length, nullptr, &log[0]);
  return log.c_str();
}

std::string ProgramLog(GLuint program)
{
  GLint length = 0;
  glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length) + 1, '\0');
  glGetProgramInfoLog(program, length, nullptr, &log[0]);
  return log.c_str();
}

// The parts are handed over one by one, so that a compiler's message names the part and its own line.
GLuint Compile(const Program::Stage& stage, int version, std::string& log)
{
  const std::string first = "#version " + std::to_string(version) + " core\n";
  std::vector<const char*> parts{ first.c_str() };
  std::vector<std::string> numbered;
  numbered.reserve(stage.Parts.size());
  for (const char* part : stage.Parts)
  {
    numbered.push_back("#line 1 " + std::to_string(numbered.size() + 1) + "\n" + part + "\n");
    parts.push_back(numbered.back().c_str());
  }
  const GLuint shader = glCreateShader(stage.Kind);
  glShaderSource(shader, static_cast<GLsizei>(parts.size()), parts.data(), nullptr);
  glCompileShader(shader);
  GLint done = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (!done)
  {
    log += ShaderLog(shader);
    glDeleteShader(shader);
    return 0;
  }
  return shader;
}
}

bool Program::Build(std::initializer_list<Stage> stages, int version)
{
  if (this->Id || this->Failed)
  {
    return this->Id != 0;
  }
  this->Log.clear();
  this->Failed = true; // until it is linked
  const GLuint program = glCreateProgram();
  std::vector<GLuint> shaders;
  for (const Stage& stage : stages)
  {
    if (const GLuint shader = Compile(stage, version, this->Log))
    {
      glAttachShader(program, shader);
      shaders.push_back(shader);
    }
  }
  if (shaders.size() == stages.size())
  {
    glLinkProgram(program);
    GLint done = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &done);
    this->Log += done ? "" : ProgramLog(program);
    this->Failed = !done;
  }
  for (const GLuint shader : shaders)
  {
    glDetachShader(program, shader);
    glDeleteShader(shader);
  }
  if (this->Failed)
  {
    glDeleteProgram(program);
    return false;
  }
  this->Id = program;
  return true;
}

void Program::Use() const
{
  glUseProgram(this->Id);
}

int Program::Location(const char* uniform) const
{
  return glGetUniformLocation(this->Id, uniform);
}

void Program::Set(const char* uniform, int value) const
{
  glUniform1i(this->Location(uniform), value);
}

void Program::Set(const char* uniform, float value) const
{
  glUniform1f(this->Location(uniform), value);
}

void Program::Set(const char* uniform, float x, float y) const
{
  glUniform2f(this->Location(uniform), x, y);
}

void Program::Set(const char* uniform, float x, float y, float z) const
{
  glUniform3f(this->Location(uniform), x, y, z);
}

void Program::SetBlock(const char* block, unsigned int binding) const
{
  const GLuint index = glGetUniformBlockIndex(this->Id, block);
  if (index != GL_INVALID_INDEX)
  {
    glUniformBlockBinding(this->Id, index, binding);
  }
}

void Program::SetMatrix(const char* uniform, const float* columns) const
{
  glUniformMatrix4fv(this->Location(uniform), 1, GL_FALSE, columns);
}

void Program::Release()
{
  if (this->Id)
  {
    glDeleteProgram(this->Id);
  }
  this->Abandon();
}
}
