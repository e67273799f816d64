// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwPictures_h
#define rtwPictures_h

#include <vtkSmartPointer.h>

#include <string>

class vtkImageData;
class vtkRenderWindow;

namespace rtw
{
/// The last picture, in 8-bit RGB; nothing is rendered.
vtkSmartPointer<vtkImageData> Grab(vtkRenderWindow* window);

/// Throws std::runtime_error if the file cannot be written.
void WritePng(vtkImageData* image, const std::string& path);
}

#endif
