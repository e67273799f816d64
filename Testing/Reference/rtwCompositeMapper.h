// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwCompositeMapper_h
#define rtwCompositeMapper_h

#include <vtkVersionMacros.h>

// The mapper of composite data that knows which blocks are visible.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
#include <vtkCompositePolyDataMapper.h>
namespace rtw
{
using CompositeMapper = vtkCompositePolyDataMapper;
}
#else
#include <vtkCompositePolyDataMapper2.h>
namespace rtw
{
using CompositeMapper = vtkCompositePolyDataMapper2;
}
#endif

#endif
