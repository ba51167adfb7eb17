// SPDX-License-Identifier: Apache-2.0
#include "Triangles.h"

#include <algorithm>
#include <vector>

namespace osgPMObjects
{

namespace
{

using Take = std::function<void(const std::array<unsigned, 3>&)>;

/// A run of vertices of one primitive.
struct Run
{
    const osg::PrimitiveSet& set;
    unsigned first, count; ///< positions in the set

    unsigned operator[](unsigned i) const { return set.index(first + i); }
};

void takeTriangle(const Run& run, const std::array<unsigned, 3>& places, const Take& take)
{
    take({run[places[0]], run[places[1]], run[places[2]]});
}

/// Passes on the triangles of a strip without the degenerate ones that join strips.
void takeOfStrip(const Run& run, unsigned i, unsigned step, const Take& take)
{
    const unsigned a = run[i], b = run[i + step], c = run[i + 2 * step];
    if (a == b || b == c || c == a) return;
    take(i / step % 2 == 0 ? std::array{a, b, c} : std::array{b, a, c});
}

void takeRun(const Run& run, GLenum mode, const Take& take)
{
    const unsigned n = run.count;
    switch (mode)
    {
    case GL_TRIANGLES:
        for (unsigned i = 0; i + 2 < n; i += 3)
            takeTriangle(run, {i, i + 1, i + 2}, take);
        break;
    case GL_TRIANGLE_STRIP:
        for (unsigned i = 0; i + 2 < n; ++i)
            takeOfStrip(run, i, 1, take);
        break;
    case GL_TRIANGLE_FAN:
    case GL_POLYGON:
        for (unsigned i = 1; i + 1 < n; ++i)
            takeTriangle(run, {0, i, i + 1}, take);
        break;
    case GL_QUADS:
        for (unsigned i = 0; i + 3 < n; i += 4)
        {
            takeTriangle(run, {i, i + 1, i + 3}, take);
            takeTriangle(run, {i + 1, i + 2, i + 3}, take);
        }
        break;
    case GL_QUAD_STRIP:
        for (unsigned i = 0; i + 3 < n; i += 2)
        {
            takeTriangle(run, {i, i + 1, i + 2}, take);
            takeTriangle(run, {i + 1, i + 3, i + 2}, take);
        }
        break;
    case GL_TRIANGLES_ADJACENCY:
        for (unsigned i = 0; i + 5 < n; i += 6)
            takeTriangle(run, {i, i + 2, i + 4}, take);
        break;
    case GL_TRIANGLE_STRIP_ADJACENCY:
        for (unsigned i = 0; i + 5 < n; i += 2)
            takeOfStrip(run, i, 2, take);
        break;
    default:
        break;
    }
}

/// Returns the runs of a set: one, except for sets that list several.
bool runsOf(const osg::PrimitiveSet& set, unsigned vertexCount, std::vector<Run>& runs)
{
    const unsigned mostInArray = vertexCount + 4; // allows one primitive beyond the array
    const auto add = [&](const auto& counts)
    {
        unsigned first = 0;
        for (const auto count : counts)
        {
            const unsigned whole = count > 0 ? static_cast<unsigned>(count) : 0;
            runs.push_back({set, first, std::min(whole, mostInArray)});
            first += whole;
        }
        return true;
    };
    switch (set.getType())
    {
    case osg::PrimitiveSet::DrawArraysPrimitiveType:
        runs.push_back({set, 0, std::min(set.getNumIndices(), mostInArray)});
        return true;
    case osg::PrimitiveSet::DrawElementsUBytePrimitiveType:
    case osg::PrimitiveSet::DrawElementsUShortPrimitiveType:
    case osg::PrimitiveSet::DrawElementsUIntPrimitiveType:
        runs.push_back({set, 0, set.getNumIndices()});
        return true;
    case osg::PrimitiveSet::DrawArrayLengthsPrimitiveType:
        return add(static_cast<const osg::DrawArrayLengths&>(set));
    case osg::PrimitiveSet::MultiDrawArraysPrimitiveType:
        return add(static_cast<const osg::MultiDrawArrays&>(set).getCounts());
    default:
        return false;
    }
}

} // namespace

bool isSurface(GLenum mode)
{
    switch (mode)
    {
    case GL_TRIANGLES:
    case GL_TRIANGLE_STRIP:
    case GL_TRIANGLE_FAN:
    case GL_QUADS:
    case GL_QUAD_STRIP:
    case GL_POLYGON:
    case GL_TRIANGLES_ADJACENCY:
    case GL_TRIANGLE_STRIP_ADJACENCY:
        return true;
    default:
        return false;
    }
}

bool forEachTriangle(const osg::PrimitiveSet& set, unsigned vertexCount, const Take& take)
{
    std::vector<Run> runs;
    if (!runsOf(set, vertexCount, runs)) return false;
    for (const Run& run : runs)
        takeRun(run, set.getMode(), take);
    return true;
}

} // namespace osgPMObjects
