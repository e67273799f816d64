#include "rtwStageTimers.h"

#include "rtwOpenGL.h"

#include <algorithm>

namespace rtw
{
StageTimers::Scope::Scope(StageTimers& timers, const char* stage)
  : Timers(timers.Enabled ? &timers : nullptr)
{
  if (this->Timers)
  {
    this->Timers->Begin(stage);
  }
}

StageTimers::Scope::~Scope()
{
  if (this->Timers)
  {
    this->Timers->End();
  }
}

void StageTimers::Begin(const char* stage)
{
  if (this->Free.empty())
  {
    GLuint id = 0;
    glGenQueries(1, &id);
    this->Free.push_back(id);
  }
  this->Frames[this->Current].push_back({ stage, this->Free.back() });
  this->Free.pop_back();
  glBeginQuery(GL_TIME_ELAPSED, this->Frames[this->Current].back().Id);
}

void StageTimers::End()
{
  glEndQuery(GL_TIME_ELAPSED);
}

// From the oldest on, so that the newest that is ready stays.
void StageTimers::NextFrame()
{
  this->Current = (this->Current + 1) % FramesKept;
  for (int age = FramesKept; age > 0; --age)
  {
    this->Collect(this->Frames[(this->Current + FramesKept - age) % FramesKept]);
  }
  this->Forget(this->Frames[this->Current]);
}

// If all of the frame is ready.
void StageTimers::Collect(std::vector<Query>& queries)
{
  GLint ready = 0;
  if (!queries.empty())
  {
    glGetQueryObjectiv(queries.back().Id, GL_QUERY_RESULT_AVAILABLE, &ready);
  }
  if (!ready)
  {
    return;
  }
  this->Results.clear();
  for (const Query& query : queries)
  {
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(query.Id, GL_QUERY_RESULT, &nanoseconds);
    const auto same = [&](const Result& result) { return result.Name == query.Stage; };
    auto at = std::find_if(this->Results.begin(), this->Results.end(), same);
    if (at == this->Results.end())
    {
      at = this->Results.insert(at, { query.Stage, 0.0 });
    }
    at->Milliseconds += 1e-6 * static_cast<double>(nanoseconds);
  }
  this->Forget(queries);
}

void StageTimers::Forget(std::vector<Query>& queries)
{
  for (const Query& query : queries)
  {
    this->Free.push_back(query.Id);
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
