// SPDX-License-Identifier: Apache-2.0
#include <osgMultiTriangulation/core/structure/KeepFragments.h>

namespace osgMultiTriangulation::core
{

void keepFragments(MultiTriangulation& tree, std::size_t count)
{
    std::size_t triangles = tree.rootTriangles, floors = 0;
    if (count > 0)
    {
        const Fragment& last = tree.fragments[count - 1];
        triangles = last.firstTriangle + last.triangleCount;
        floors = last.firstFloor + last.floorCount;
    }
    tree.fragments.resize(count);
    tree.points.resize(tree.rootPoints + count);
    tree.floors.resize(floors);
    tree.corners.resize(triangles);
    tree.errors.resize(triangles);
    tree.upper.resize(triangles);
    tree.lower.resize(triangles);
    for (std::uint32_t& lower : tree.lower)
        if (lower != kNone && lower >= count) lower = kNone;
}

void releaseMemory(MultiTriangulation& tree)
{
    tree.fragments.shrink_to_fit();
    tree.points.shrink_to_fit();
    tree.floors.shrink_to_fit();
    tree.corners.shrink_to_fit();
    tree.errors.shrink_to_fit();
    tree.upper.shrink_to_fit();
    tree.lower.shrink_to_fit();
}

} // namespace osgMultiTriangulation::core
