// SPDX-License-Identifier: Apache-2.0
#include "BuildIdentity.h"

#include <string>

#include "MtHeader.h"

namespace osgMultiTriangulation::core
{

namespace
{

template<class T>
std::uint32_t sumOf(const std::vector<T>& list)
{
    return mtChecksum({reinterpret_cast<const char*>(list.data()), list.size() * sizeof(T)});
}

/// A sum over the cuts.
std::uint32_t identityOfCuts(const Partition& partition)
{
    std::string all;
    LittleEndian out(all);
    for (const PlanPart& part : partition.parts)
    {
        out.add(part.halves[0]);
        out.add(part.halves[1]);
        out.add(part.axis);
        out.add(part.cut);
    }
    return mtChecksum(all);
}

void addFrame(const PlanFrame& frame, std::string& bytes)
{
    LittleEndian out(bytes);
    for (const double value : {frame.originX, frame.originY, frame.stepX, frame.stepY})
        out.add(value);
    if (!frame.reference) return;
    for (const double value :
         {frame.reference->firstX, frame.reference->firstY, frame.reference->stepX, frame.reference->stepY})
        out.add(value);
    bytes += frame.reference->system;
}

} // namespace

std::uint32_t identityOf(const SurfaceMesh& mesh, const PlanFrame& frame, const Partition& partition)
{
    std::uint32_t points = 0;
    for (const SurfacePoint& p :
         mesh.points) // field by field: there are bytes between them that nobody wrote
    {
        std::string bytes;
        LittleEndian out(bytes);
        out.add(p.x);
        out.add(p.y);
        out.add(p.height);
        points = points * 31 + mtChecksum(bytes);
    }
    std::string all;
    LittleEndian out(all);
    for (const std::uint32_t sum : {points, sumOf(mesh.triangles), identityOfCuts(partition), kMtVersion})
        out.add(sum);
    addFrame(frame, all);
    return mtChecksum(all);
}

std::uint32_t identityOf(const SurfaceSpool& spool, const PlanFrame& frame, const Partition& partition,
                         std::uint64_t mostHidden)
{
    std::string all;
    LittleEndian out(all);
    for (const std::uint32_t sum : {spool.sum(), identityOfCuts(partition), kMtVersion})
        out.add(sum);
    addFrame(frame, all);
    out.add(mostHidden);
    return mtChecksum(all);
}

} // namespace osgMultiTriangulation::core
