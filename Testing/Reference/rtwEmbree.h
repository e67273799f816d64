// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwEmbree_h
#define rtwEmbree_h

// What differs between Embree 3 and Embree 4.
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace rtw
{
#if RTC_VERSION_MAJOR >= 4
using EmbreeContext = RTCRayQueryContext;

inline void InitContext(EmbreeContext* context)
{
  rtcInitRayQueryContext(context);
}

inline void Intersect(RTCScene scene, EmbreeContext* context, RTCRayHit* ray)
{
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = context;
  rtcIntersect1(scene, ray, &arguments);
}

inline void Occluded(RTCScene scene, EmbreeContext* context, RTCRay* ray)
{
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = context;
  rtcOccluded1(scene, ray, &arguments);
}
#else
using EmbreeContext = RTCIntersectContext;

inline void InitContext(EmbreeContext* context)
{
  rtcInitIntersectContext(context);
}

inline void Intersect(RTCScene scene, EmbreeContext* context, RTCRayHit* ray)
{
  rtcIntersect1(scene, context, ray);
}

inline void Occluded(RTCScene scene, EmbreeContext* context, RTCRay* ray)
{
  rtcOccluded1(scene, context, ray);
}
#endif
}

#endif
