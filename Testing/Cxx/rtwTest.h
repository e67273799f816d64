// SPDX-License-Identifier: BSD-3-Clause
// What a drawing test needs. A test is a function that checks things and says at its end whether
// they held:
//
//     int TestX(int argc, char* argv[])
//     {
//       vtkNew<vtkRenderWindow> window; // a headless one: see rtwTestBegin
//       ...
//       RTW_CHECK(pass->GetNumberOfLayers() == 1);
//       rtwCompareWithBaseline(window, argc, argv);
//       return rtwTestResult();
//     }
#ifndef rtwTest_h
#define rtwTest_h

#include "vtkCommand.h"
#include "vtkSmartPointer.h"

#include <array>
#include <sstream>
#include <string>
#include <vector>

class vtkImageData;
class vtkObject;
class vtkRenderWindow;

/** What a test returns that cannot run here, say, for want of OpenGL 4.3. */
constexpr int rtwTestSkipped = 125;

/** EXIT_SUCCESS if every check held so far, else EXIT_FAILURE. */
int rtwTestResult();

/** Say so if a check failed. Returns `passed`. */
bool rtwCheck(bool passed, const char* file, int line, const std::string& what);

#define RTW_CHECK(condition) rtwCheck(static_cast<bool>(condition), __FILE__, __LINE__, #condition)

/** As RTW_CHECK, and shows both values. */
#define RTW_CHECK_EQUAL(actual, expected)                                                          \
  rtwCheckEqual((actual), (expected), __FILE__, __LINE__, #actual " == " #expected)

#define RTW_CHECK_NEAR(actual, expected, tolerance)                                                \
  rtwCheckNear((actual), (expected), (tolerance), __FILE__, __LINE__, #actual " ~ " #expected)

template <typename A, typename B>
bool rtwCheckEqual(const A& actual, const B& expected, const char* file, int line, const char* what)
{
  std::ostringstream text;
  text << what << " (it is " << actual << ", not " << expected << ")";
  return rtwCheck(actual == expected, file, line, text.str());
}

bool rtwCheckNear(
  double actual, double expected, double tolerance, const char* file, int line, const char* what);

/** The last picture, as it is: nothing is rendered. 8-bit RGB, row 0 at the bottom. */
vtkSmartPointer<vtkImageData> rtwGrab(vtkRenderWindow* window);

/** A pixel of a picture of rtwGrab. */
std::array<int, 3> rtwPixel(vtkImageData* image, int x, int y);

/** Whether a pixel is `color` within `tolerance` in each channel; tells its colour if not. */
bool rtwCheckPixel(vtkImageData* image, int x, int y, const std::array<int, 3>& color,
  int tolerance, const char* file, int line);

#define RTW_CHECK_PIXEL(image, x, y, r, g, b)                                                      \
  rtwCheckPixel((image), (x), (y), { (r), (g), (b) }, 6, __FILE__, __LINE__)

/** How alike two pictures must be. */
struct rtwImageTolerance
{
  int Channel = 16;     ///< a pixel differs if a channel, of 255, differs by more than this
  int Radius = 1;       ///< from every pixel of the baseline within this distance
  double Share = 0.002; ///< how many of the pixels may differ
  double Mean = 2.0;    ///< how much the mean difference of the channels may be, of 255
};

/**
 * Checks a picture against the baseline that -V names. If they differ, both lie in the folder that
 * -T names, as does a picture of the difference. With RTW_UPDATE_BASELINES=1 in the environment,
 * the picture becomes the baseline.
 */
bool rtwCompareWithBaseline(vtkImageData* image, int argc, char* argv[],
  const rtwImageTolerance& tolerance = rtwImageTolerance());
bool rtwCompareWithBaseline(vtkRenderWindow* window, int argc, char* argv[],
  const rtwImageTolerance& tolerance = rtwImageTolerance());

/** The argument after a flag, such as -T; empty if there is none. */
std::string rtwGetArgument(int argc, char* argv[], const std::string& flag);

/**
 * While it lives, keeps an object's errors and warnings from being printed, and from failing the
 * test, and has them for checks.
 */
class rtwMessageCatcher
{
public:
  explicit rtwMessageCatcher(vtkObject* object);
  ~rtwMessageCatcher();
  rtwMessageCatcher(const rtwMessageCatcher&) = delete;
  void operator=(const rtwMessageCatcher&) = delete;

  int GetNumberOfErrors() const;
  int GetNumberOfWarnings() const;
  /** All texts so far, errors and warnings. */
  std::string GetText() const;

private:
  class Observer;
  vtkSmartPointer<vtkObject> Object;
  vtkSmartPointer<Observer> Command;
};

///@{
/** For the driver: before a test, vtkRTWEGLRenderWindow becomes the default window. */
void rtwTestBegin(int argc, char* argv[]);
int rtwTestEnd(int result);
///@}

#endif
