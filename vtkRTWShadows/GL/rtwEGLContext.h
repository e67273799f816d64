// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwEGLContext_h
#define rtwEGLContext_h

#include <memory>
#include <string>

class rtwGLXContext;

/**
 * An OpenGL core context by EGL that needs no window system. It owns the context and its tiny
 * pbuffer; the EGL display stays initialized, for reasons given at its destructor.
 *
 * Built without EGL (RTW_HAVE_EGL=0), it reports no device and creates nothing.
 */
class rtwEGLContext
{
public:
  /** What is asked for. */
  struct Request
  {
    int DeviceIndex = -1; ///< number of the enumerated device; -1: the first that works
    int MaximumMajor = 4; ///< the highest OpenGL version to ask the driver for
    int MaximumMinor = 6;

    bool operator==(const Request& other) const
    {
      return this->DeviceIndex == other.DeviceIndex && this->MaximumMajor == other.MaximumMajor &&
        this->MaximumMinor == other.MaximumMinor;
    }
  };

  /** What came of MakeCurrent. */
  enum class Status
  {
    Current,
    Lost, ///< by a reset of the driver, or by an eglTerminate elsewhere: only a new one helps
    Failed
  };

  /** How many EGL devices there are, software ones included; 0 without EGL. */
  static int GetNumberOfDevices();

  /** Address of an OpenGL function, for a loader; nullptr where there is none. */
  static void (*GetFunction(const char* name))();

  /** Null on failure, with the reason in `why`: one line for a user to read. */
  static std::unique_ptr<rtwEGLContext> Create(const Request& request, std::string& why);

  ~rtwEGLContext();
  rtwEGLContext(const rtwEGLContext&) = delete;
  void operator=(const rtwEGLContext&) = delete;

  /** Makes it current in this thread; a GLX context that is so has to make room. */
  Status MakeCurrent();
  /** After this, no context of EGL is current in this thread. */
  void ReleaseCurrent();
  /** Gives the place back to the GLX context that made room for this one, if one did. */
  void GiveBack();
  bool IsCurrent() const;

  /** The device it lives on, -1 where that is none of the enumerated ones. */
  int GetDeviceIndex() const { return this->DeviceIndex; }
  void* GetNativeContext() const { return this->Context; }
  void* GetNativeDisplay() const { return this->Display; }
  void* GetNativeSurface() const { return this->Surface; }

private:
  rtwEGLContext();
  bool Displace();
  bool Open(void* display, const Request& request, std::string& why);

  // EGL's handles are void*; its headers stay out of this one, since they may bring X11's macros.
  void* Display = nullptr;
  void* Context = nullptr;
  void* Surface = nullptr;
  int DeviceIndex = -1;
  std::unique_ptr<rtwGLXContext> Displaced;
};

#endif
