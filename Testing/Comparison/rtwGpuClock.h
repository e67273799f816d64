// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwGpuClock_h
#define rtwGpuClock_h

namespace rtw
{
/// The GPU's own time from construction to Stop(), in the current OpenGL context. By time stamps,
/// which other queries don't disturb.
class GpuClock
{
public:
  GpuClock();
  ~GpuClock();
  GpuClock(const GpuClock&) = delete;
  GpuClock& operator=(const GpuClock&) = delete;

  void Stop();

  /// Waits for the GPU. 0 where the driver has no time stamps.
  double GetMilliseconds() const;

private:
  unsigned int Queries[2] = { 0, 0 };
};
}

#endif
