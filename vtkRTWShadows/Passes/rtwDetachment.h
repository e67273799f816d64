// SPDX-License-Identifier: BSD-3-Clause
// While one lives, no pass has code in the shaders of some props: they are drawn for something else than the picture that
// a pass around ours makes, into targets that it doesn't know.
#ifndef rtwDetachment_h
#define rtwDetachment_h

#include "vtkSmartPointer.h"

#include <utility>
#include <vector>

class vtkInformation;
class vtkObjectBase;
class vtkProp;

namespace rtw
{
class Detachment
{
public:
  explicit Detachment(const std::vector<vtkProp*>& props);
  ~Detachment();
  Detachment(const Detachment&) = delete;
  Detachment& operator=(const Detachment&) = delete;

private:
  std::vector<std::pair<vtkSmartPointer<vtkInformation>, vtkSmartPointer<vtkObjectBase>>> Detached;
};
}

#endif
