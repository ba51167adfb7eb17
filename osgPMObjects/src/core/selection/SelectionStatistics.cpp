// SPDX-License-Identifier: Apache-2.0
#include <osgPMObjects/core/selection/SelectionStatistics.h>

namespace osgPMObjects::core
{

void MethodStatistics::count(const Selection& selection, std::uint32_t drawnTriangles)
{
    const bool isGone = selection.reason == SelectionReason::gone;
    ++objects;
    switched += selection.hasSwitched;
    clamped += selection.reason == SelectionReason::clamped;
    fullArea += selection.reason == SelectionReason::fullArea;
    faded += !isGone && selection.alpha < 1.0f;
    gone += isGone;
    triangles += isGone ? 0 : drawnTriangles;
}

MethodStatistics& MethodStatistics::operator+=(const MethodStatistics& other)
{
    objects += other.objects;
    switched += other.switched;
    clamped += other.clamped;
    fullArea += other.fullArea;
    faded += other.faded;
    gone += other.gone;
    triangles += other.triangles;
    return *this;
}

MethodStatistics SelectionStatistics::all() const
{
    MethodStatistics sum;
    for (const MethodStatistics& method : byMethod)
        sum += method;
    return sum;
}

} // namespace osgPMObjects::core
