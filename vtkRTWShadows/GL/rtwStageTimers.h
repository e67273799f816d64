// GPU time of each stage of a frame, read when it is ready so that nothing waits. Each is the time between two stamps: of
// elapsed time there can be only one query under way, and that may be somebody else's.
#ifndef rtwStageTimers_h
#define rtwStageTimers_h

#include <string>
#include <vector>

namespace rtw
{
class StageTimers
{
public:
  StageTimers() = default;
  StageTimers(const StageTimers&) = delete;
  StageTimers& operator=(const StageTimers&) = delete;

  /// Times one stage while it lives; nothing where timing is off.
  class Scope
  {
  public:
    Scope(StageTimers& timers, const char* stage);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

  private:
    unsigned int End = 0;
  };

  void SetEnabled(bool enabled) { this->Enabled = enabled; }
  bool GetEnabled() const { return this->Enabled; }
  /// Collects the newest frame that is ready and starts a new one.
  void NextFrame();
  int GetNumberOfStages() const { return static_cast<int>(this->Results.size()); }
  const char* GetName(int stage) const { return this->Results[stage].Name.c_str(); }
  double GetMilliseconds(int stage) const { return this->Results[stage].Milliseconds; }
  void Release();
  void Abandon();

private:
  struct Query
  {
    std::string Stage;
    unsigned int Start;
    unsigned int End;
  };
  struct Result
  {
    std::string Name;
    double Milliseconds;
  };
  static constexpr int FramesKept = 3;

  unsigned int TakeQuery();
  unsigned int Begin(const char* stage); ///< the query that ends it
  void Collect(std::vector<Query>& queries);
  void Forget(std::vector<Query>& queries);

  bool Enabled = false;
  int Current = 0;
  std::vector<Query> Frames[FramesKept];
  std::vector<unsigned int> Free;
  std::vector<Result> Results;
};
}

#endif
