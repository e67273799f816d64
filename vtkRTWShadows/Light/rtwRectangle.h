// SPDX-License-Identifier: BSD-3-Clause
// A rectangle on a light plane, along s and t.
#ifndef rtwRectangle_h
#define rtwRectangle_h

#include <glm/glm.hpp>

namespace rtw
{
struct Rectangle
{
  glm::dvec2 Low{ 0 };
  glm::dvec2 High{ 1 };
};

}

#endif
