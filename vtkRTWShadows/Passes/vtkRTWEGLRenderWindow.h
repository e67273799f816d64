// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRTWEGLRenderWindow
 * @brief   a headless OpenGL window: no X server, no display, no screen
 *
 * Draws off screen through EGL, on a GPU or in software, and is used like any other window:
 *
 *     vtkNew<vtkRTWEGLRenderWindow> window;
 *     window->AddRenderer(renderer);
 *     window->SetSize(800, 600);
 *     window->Render();
 *
 * It is for VTK builds that cannot draw without an X server (up to 9.3 most packages), and works
 * with all others. The OpenGL context comes into being when first needed, and anew after
 * Finalize() or when the driver lost it. It is a core context of the highest version that the
 * driver gives, at least 3.2.
 *
 * Several windows may live at once. A thread has room for one current OpenGL context: an X window's
 * (GLX) is put aside while something is done here, and given back afterwards. But this context
 * stays current where there was none before, so call ReleaseCurrent() before an X window is first
 * drawn after this one, and before this window is used in another thread.
 *
 * The picture is in the window's own framebuffers: read it by vtkWindowToImageFilter or
 * GetPixelData(). MultiSamples works as usual. A size of zero in a direction counts as 300.
 *
 * InstallAsDefault() makes vtkRenderWindow::New() return this class.
 */

#ifndef vtkRTWEGLRenderWindow_h
#define vtkRTWEGLRenderWindow_h

#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkRTWShadowsModule.h" // for export macro

#include <array>  // for the version
#include <memory> // for unique_ptr

class rtwEGLContext;

class VTKRTWSHADOWS_EXPORT vtkRTWEGLRenderWindow : public vtkGenericOpenGLRenderWindow
{
public:
  static vtkRTWEGLRenderWindow* New();
  vtkTypeMacro(vtkRTWEGLRenderWindow, vtkGenericOpenGLRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Which EGL device to draw on: 0 to GetNumberOfDevices() - 1, in EGL's order, software devices
   * included, or -1 for the first that works, and failing all, EGL's surfaceless and default
   * displays. Less than -1 counts as -1; a device that there is not is an error when the context
   * is made. A change holds from the next context on, so set it before the first Render() or
   * after Finalize(). GetDeviceIndex() gives what was asked for, GetCurrentDeviceIndex() the one in
   * use. Default: -1.
   */
  void SetDeviceIndex(int index) override;
  ///@}

  /**
   * How many EGL devices this machine has, software ones included; 0 also where the driver cannot
   * enumerate them or there is no EGL.
   */
  int GetNumberOfDevices() override;

  /**
   * The EGL device that the present context is on; -1 with no context, or when it is on none of
   * the enumerated devices.
   */
  int GetCurrentDeviceIndex();

  ///@{
  /**
   * The highest OpenGL version to ask the driver for, from 3.2 to 4.6; less or more is an error,
   * and the value stays as it was. Where the driver has not that much, it is asked for less, down
   * to 3.2. The standard lets a driver give more than is asked for, and many do: what there is
   * tell GetOpenGLMajorVersion() and GetOpenGLMinorVersion(). (Mesa is held to a version by the
   * environment variable MESA_GL_VERSION_OVERRIDE.) A change holds from the next context on.
   * Default: 4.6.
   */
  void SetMaximumOpenGLVersion(int major, int minor);
  vtkGetMacro(MaximumOpenGLMajorVersion, int);
  vtkGetMacro(MaximumOpenGLMinorVersion, int);
  ///@}

  ///@{
  /**
   * The OpenGL version of the context, which is made if there is none yet; 0 when none can be.
   */
  int GetOpenGLMajorVersion();
  int GetOpenGLMinorVersion();
  ///@}

  /** Whether the window has an OpenGL context now. None is made by asking. */
  bool HasContext();

  ///@{
  /**
   * Make vtkRenderWindow::New(), and vtkRenderWindow() in Python, return this class, and
   * vtkRenderWindowInteractor::New() an interactor whose Start() returns at once, since there is
   * nobody to interact. With `onlyWithoutDisplay`, nothing is done where the environment variable
   * DISPLAY or WAYLAND_DISPLAY names a display, nor on Windows and macOS. Nothing is ever done in a
   * build without EGL. Returns whether this class is the default
   * afterwards. Calling it again changes nothing. UninstallAsDefault() undoes it; windows made
   * meanwhile stay what they are.
   */
  static bool InstallAsDefault(bool onlyWithoutDisplay = true);
  static void UninstallAsDefault();
  ///@}

  ///@{
  /**
   * As for every window. All that need a context make it if there is none; when that fails, the
   * reason is told once and nothing is drawn.
   */
  void Initialize() override;
  void Start() override;
  void End() override;
  void Render() override;
  void MakeCurrent() override;
  bool IsCurrent() override;
  void PushContext() override;
  void PopContext() override;
  void OpenGLInit() override;
  ///@}

  /**
   * Let go of this thread's hold on the context, so that another thread, or a window of another
   * API, can have it or its place. Whatever needs the context takes it again. Without effect where
   * it is not current.
   */
  void ReleaseCurrent();

  /**
   * Release all graphics resources, those of the renderers' props too, and the context. The next
   * Render() makes a new one.
   */
  void Finalize() override;

  ///@{
  /**
   * Whether OpenGL works here. A context is made to find out if there is none; failing is no
   * error, and GetOpenGLSupportMessage() has the reason.
   */
  int SupportsOpenGL() override;
  vtkTypeBool IsDirect() override;
  ///@}

  /** Vendor, renderer, version and extensions, or the reason why there is no context. */
  const char* ReportCapabilities() override;

  ///@{
  /** Depth of a rectangle of the last picture; VTK_ERROR when there is none. */
  using vtkOpenGLRenderWindow::GetZbufferData;
  int GetZbufferData(int x1, int y1, int x2, int y2, float* z) override;
  ///@}

  ///@{
  /** EGL's handles: an EGLContext, an EGLDisplay and an EGLSurface; null without a context. */
  void* GetGenericContext() override;
  void* GetGenericDisplayId() override;
  void* GetGenericDrawable() override;
  ///@}

protected:
  vtkRTWEGLRenderWindow();
  ~vtkRTWEGLRenderWindow() override;

  void OpenGLInitContext() override;
  int ReadPixels(
    const vtkRecti& rect, int front, int glFormat, int glType, void* data, int right) override;

private:
  vtkRTWEGLRenderWindow(const vtkRTWEGLRenderWindow&) = delete;
  void operator=(const vtkRTWEGLRenderWindow&) = delete;

  bool EnsureContext(bool report);
  bool EnsureInitialized(bool report);
  bool HasPicture();
  std::array<int, 2> QueryOpenGLVersion();
  void ForgetLostContext();

  int MaximumOpenGLMajorVersion = 4;
  int MaximumOpenGLMinorVersion = 6;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
