#include "GL/rtwStageTimers.h"

#include "GL/rtwOpenGL.h"

#include <algorithm>

namespace rtw
{
StageTimers::Scope::Scope(StageTimers& timers, const char* stage)
  : End(timers.Enabled ? timers.Begin(stage) : 0)
{
}

StageTimers::Scope::~Scope()
{
  if (this->End)
  {
    glQueryCounter(this->End, GL_TIMESTAMP);
  }
}

unsigned int StageTimers::TakeQuery()
{
  GLuint id = 0;
  if (this->Free.empty())
  {
    glGenQueries(1, &id);
  }
  else
  {
    id = this->Free.back();
    this->Free.pop_back();
  }
  return id;
}

unsigned int StageTimers::Begin(const char* stage)
{
  const Query query{ stage, this->TakeQuery(), this->TakeQuery() };
  this->Frames[this->Current].push_back(query);
  glQueryCounter(query.Start, GL_TIMESTAMP);
  return query.End;
}

// Collects from the oldest frame on, so that the results of the newest that is ready stay.
void StageTimers::NextFrame()
{
  this->Current = (this->Current + 1) % FramesKept;
  for (int age = FramesKept; age > 0; --age)
  {
    this->Collect(this->Frames[(this->Current + FramesKept - age) % FramesKept]);
  }
  this->Forget(this->Frames[this->Current]);
}

// Takes over a frame's results if all of them are ready.
void StageTimers::Collect(std::vector<Query>& queries)
{
  GLint ready = 0;
  if (!queries.empty())
  {
    glGetQueryObjectiv(queries.back().End, GL_QUERY_RESULT_AVAILABLE, &ready);
  }
  if (!ready)
  {
    return;
  }
  this->Results.clear();
  for (const Query& query : queries)
  {
    GLuint64 start = 0, end = 0;
    glGetQueryObjectui64v(query.Start, GL_QUERY_RESULT, &start);
    glGetQueryObjectui64v(query.End, GL_QUERY_RESULT, &end);
    const auto same = [&](const Result& result) { return result.Name == query.Stage; };
    auto at = std::find_if(this->Results.begin(), this->Results.end(), same);
    if (at == this->Results.end())
    {
      at = this->Results.insert(at, { query.Stage, 0.0 });
    }
    at->Milliseconds += 1e-6 * static_cast<double>(end - start);
  }
  this->Forget(queries);
}

void StageTimers::Forget(std::vector<Query>& queries)
{
  for (const Query& query : queries)
  {
    this->Free.push_back(query.Start);
    this->Free.push_back(query.End);
  }
  queries.clear();
}

void StageTimers::Release()
{
  for (auto& frame : this->Frames)
  {
    this->Forget(frame);
  }
  if (!this->Free.empty())
  {
    glDeleteQueries(static_cast<GLsizei>(this->Free.size()), this->Free.data());
  }
  this->Abandon();
}

void StageTimers::Abandon()
{
  for (auto& frame : this->Frames)
  {
    frame.clear();
  }
  this->Free.clear();
  this->Results.clear();
}
}
