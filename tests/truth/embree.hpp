#pragma once
// Embree 3 and Embree 4 under one roof: the little that they call differently. Only the truth's sources include this.

#if ATRIUM_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace atrium::truth::embree {

#if ATRIUM_EMBREE_MAJOR >= 4

using Context = RTCRayQueryContext;

inline void init(Context& context)
{
    rtcInitRayQueryContext(&context);
}

inline void intersect(RTCScene scene, Context& context, RTCRayHit& ray)
{
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = &context;
    rtcIntersect1(scene, &ray, &arguments);
}

inline void occluded(RTCScene scene, Context& context, RTCRay& ray)
{
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.context = &context;
    rtcOccluded1(scene, &ray, &arguments);
}

#else

using Context = RTCIntersectContext;

inline void init(Context& context)
{
    rtcInitIntersectContext(&context);
}

inline void intersect(RTCScene scene, Context& context, RTCRayHit& ray)
{
    rtcIntersect1(scene, &context, &ray);
}

inline void occluded(RTCScene scene, Context& context, RTCRay& ray)
{
    rtcOccluded1(scene, &context, &ray);
}

#endif

} // namespace atrium::truth::embree
