// SPDX-License-Identifier: BSD-3-Clause
// From the coordinates in which a mapper's vertices are stored to the view's: composed in double precision, because VTK's own begin at the
// camera, which may be far from what it sees.
#ifndef rtwModelPlace_h
#define rtwModelPlace_h

class vtkAbstractMapper;
class vtkProp;
class vtkShaderProgram;

namespace rtw
{
struct View;

/// What InjectReceiver() has a vertex shader ask for, where it asks.
void SetModelToView(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop, const View& view);
}

#endif
