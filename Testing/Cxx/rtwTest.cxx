// SPDX-License-Identifier: BSD-3-Clause
#include "rtwTest.h"

#include "vtkRTWEGLRenderWindow.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>

namespace
{
int NumberOfFailures = 0;

bool IsSet(const char* variable)
{
  const char* value = std::getenv(variable);
  return value && *value && std::string(value) != "0";
}

void WritePNG(vtkImageData* image, const std::string& path)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(image);
  writer->Write();
  std::cout << "  written: " << path << std::endl;
}

// The least difference of a pixel, over its neighbours in the baseline: an edge that another
// driver draws half a pixel elsewhere is no difference.
int GetDifference(vtkImageData* image, vtkImageData* baseline, int x, int y, int radius)
{
  const std::array<int, 3> color = rtwPixel(image, x, y);
  const int* size = image->GetDimensions();
  int least = 255;
  for (int v = std::max(0, y - radius); v <= std::min(size[1] - 1, y + radius); ++v)
  {
    for (int u = std::max(0, x - radius); u <= std::min(size[0] - 1, x + radius); ++u)
    {
      const std::array<int, 3> other = rtwPixel(baseline, u, v);
      int greatest = 0;
      for (size_t c = 0; c < 3; ++c)
      {
        greatest = std::max(greatest, std::abs(color[c] - other[c]));
      }
      least = std::min(least, greatest);
    }
  }
  return least;
}

struct Comparison
{
  double Share = 0.0;
  double Mean = 0.0;
  vtkSmartPointer<vtkImageData> Picture;
};

Comparison Compare(vtkImageData* image, vtkImageData* baseline, const rtwImageTolerance& tolerance)
{
  Comparison result;
  const int* size = image->GetDimensions();
  result.Picture = vtkSmartPointer<vtkImageData>::New();
  result.Picture->SetDimensions(size[0], size[1], 1);
  result.Picture->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  double sum = 0.0;
  int count = 0;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      const int difference = GetDifference(image, baseline, x, y, tolerance.Radius);
      *static_cast<unsigned char*>(result.Picture->GetScalarPointer(x, y, 0)) =
        static_cast<unsigned char>(difference);
      count += difference > tolerance.Channel;
      const std::array<int, 3> a = rtwPixel(image, x, y);
      const std::array<int, 3> b = rtwPixel(baseline, x, y);
      sum += std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
    }
  }
  const double pixels = static_cast<double>(size[0]) * size[1];
  result.Share = count / pixels;
  result.Mean = sum / (3.0 * pixels);
  return result;
}
}

int rtwTestResult()
{
  return NumberOfFailures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

bool rtwCheck(bool passed, const char* file, int line, const std::string& what)
{
  if (!passed)
  {
    ++NumberOfFailures;
    std::cout << file << ":" << line << ": failed: " << what << std::endl;
  }
  return passed;
}

bool rtwCheckNear(
  double actual, double expected, double tolerance, const char* file, int line, const char* what)
{
  std::ostringstream text;
  text << what << " (it is " << actual << ", not " << expected << " within " << tolerance << ")";
  return rtwCheck(std::abs(actual - expected) <= tolerance, file, line, text.str());
}

vtkSmartPointer<vtkImageData> rtwGrab(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->SetInputBufferTypeToRGB();
  filter->ReadFrontBufferOff();
  filter->ShouldRerenderOff();
  filter->Update();
  return filter->GetOutput();
}

std::array<int, 3> rtwPixel(vtkImageData* image, int x, int y)
{
  const auto* rgb = static_cast<const unsigned char*>(image->GetScalarPointer(x, y, 0));
  return { rgb[0], rgb[1], rgb[2] };
}

bool rtwCheckPixel(vtkImageData* image, int x, int y, const std::array<int, 3>& color,
  int tolerance, const char* file, int line)
{
  const int* size = image->GetDimensions();
  std::ostringstream text;
  text << "pixel " << x << ", " << y << " of a picture of " << size[0] << " x " << size[1];
  if (x < 0 || y < 0 || x >= size[0] || y >= size[1])
  {
    return rtwCheck(false, file, line, text.str());
  }
  const std::array<int, 3> actual = rtwPixel(image, x, y);
  bool same = true;
  text << " is " << actual[0] << " " << actual[1] << " " << actual[2] << ", not ";
  for (size_t c = 0; c < 3; ++c)
  {
    same = same && std::abs(actual[c] - color[c]) <= tolerance;
    text << color[c] << " ";
  }
  return rtwCheck(same, file, line, text.str());
}

std::string rtwGetArgument(int argc, char* argv[], const std::string& flag)
{
  for (int i = 0; i + 1 < argc; ++i)
  {
    if (flag == argv[i])
    {
      return argv[i + 1];
    }
  }
  return {};
}

bool rtwCompareWithBaseline(
  vtkRenderWindow* window, int argc, char* argv[], const rtwImageTolerance& tolerance)
{
  return rtwCompareWithBaseline(rtwGrab(window), argc, argv, tolerance);
}

bool rtwCompareWithBaseline(
  vtkImageData* image, int argc, char* argv[], const rtwImageTolerance& tolerance)
{
  const std::string path = rtwGetArgument(argc, argv, "-V");
  if (IsSet("RTW_UPDATE_BASELINES"))
  {
    WritePNG(image, path);
    return true;
  }
  const std::string name = path.substr(path.find_last_of("/\\") + 1);
  const std::string output =
    rtwGetArgument(argc, argv, "-T") + "/" + name.substr(0, name.rfind('.'));
  if (!std::ifstream(path).good())
  {
    WritePNG(image, output + ".png");
    return rtwCheck(false, __FILE__, __LINE__,
      "the baseline " + path + " exists (RTW_UPDATE_BASELINES=1 makes it of this picture)");
  }

  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData* baseline = reader->GetOutput();
  const int* size = image->GetDimensions();
  const int* wanted = baseline->GetDimensions();
  if (size[0] != wanted[0] || size[1] != wanted[1] || baseline->GetNumberOfScalarComponents() < 3)
  {
    return rtwCheck(false, __FILE__, __LINE__, "the picture has the size of the baseline, in RGB");
  }
  const Comparison result = Compare(image, baseline, tolerance);
  std::ostringstream text;
  text << "the picture is as " << name << " (" << 100.0 * result.Share
       << " % of the pixels differ, " << 100.0 * tolerance.Share
       << " % may; the mean difference is " << result.Mean << ", " << tolerance.Mean << " may be)";
  const bool same = result.Share <= tolerance.Share && result.Mean <= tolerance.Mean;
  if (!same)
  {
    WritePNG(image, output + ".png");
    WritePNG(result.Picture, output + ".diff.png");
  }
  return rtwCheck(same, __FILE__, __LINE__, text.str());
}

//------------------------------------------------------------------------------
class rtwMessageCatcher::Observer : public vtkCommand
{
public:
  static Observer* New() { return new Observer; }
  void Execute(vtkObject*, unsigned long event, void* data) override
  {
    ++(event == vtkCommand::ErrorEvent ? this->Errors : this->Warnings);
    this->Text += static_cast<const char*>(data);
  }
  int Errors = 0;
  int Warnings = 0;
  std::string Text;
};

rtwMessageCatcher::rtwMessageCatcher(vtkObject* object)
  : Object(object)
  , Command(vtkSmartPointer<Observer>::New())
{
  object->AddObserver(vtkCommand::ErrorEvent, this->Command);
  object->AddObserver(vtkCommand::WarningEvent, this->Command);
}

rtwMessageCatcher::~rtwMessageCatcher()
{
  this->Object->RemoveObserver(this->Command);
}

int rtwMessageCatcher::GetNumberOfErrors() const
{
  return this->Command->Errors;
}

int rtwMessageCatcher::GetNumberOfWarnings() const
{
  return this->Command->Warnings;
}

std::string rtwMessageCatcher::GetText() const
{
  return this->Command->Text;
}

//------------------------------------------------------------------------------
void rtwTestBegin(int, char*[])
{
  // RTW_TEST_NATIVE_WINDOW=1 runs the tests with VTK's own window instead, which needs a display.
  if (!IsSet("RTW_TEST_NATIVE_WINDOW"))
  {
    vtkRTWEGLRenderWindow::InstallAsDefault(false);
  }
}

int rtwTestEnd(int result)
{
  if (result == rtwTestSkipped)
  {
    std::cout << "skipped: this machine cannot run it" << std::endl;
  }
  vtkRTWEGLRenderWindow::UninstallAsDefault();
  return result;
}
