// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwSceneParts_h
#define rtwSceneParts_h

#include "rtwScene.h"

class vtkActor;

namespace rtw
{
vtkSmartPointer<vtkActor> MakeActor(const ScenePart& part);
}

#endif
