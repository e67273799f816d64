// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwOpenGL_h
#define rtwOpenGL_h

// The one place that chooses the header of the OpenGL functions: the loader of this VTK.
// The build defines VTK_MODULE_ENABLE_VTK_* for each optional dependency in vtk.module.
#if VTK_MODULE_ENABLE_VTK_glad
#include "vtk_glad.h" // VTK >= 9.4
#else
#include "vtk_glew.h" // VTK <= 9.3
#endif

#endif
