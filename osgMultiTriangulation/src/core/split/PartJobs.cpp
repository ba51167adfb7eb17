// SPDX-License-Identifier: Apache-2.0
#include "PartJobs.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include <osgMultiTriangulation/core/check/SurfaceCheck.h>

namespace osgMultiTriangulation::core
{

namespace
{

/// Adds what is left of a half.
void join(PartMesh& whole, PartMesh half)
{
    const auto firstPoint = static_cast<std::uint32_t>(whole.inputs.size());
    MeasuredMesh &all = whole.measured, &own = half.measured;
    if (firstPoint == 0)
    {
        whole = std::move(half);
        if (!whole.measured.firstHidden.empty()) whole.measured.firstHidden.pop_back();
        return;
    }
    whole.allHidden += half.allHidden;
    whole.inputs.insert(whole.inputs.end(), half.inputs.begin(), half.inputs.end());
    whole.joinedAt.insert(whole.joinedAt.end(), half.joinedAt.begin(), half.joinedAt.end());
    all.mesh.points.insert(all.mesh.points.end(), own.mesh.points.begin(), own.mesh.points.end());
    for (Triangle t : own.mesh.triangles)
    {
        for (std::uint32_t& corner : t)
            corner += firstPoint;
        all.mesh.triangles.push_back(t);
    }
    all.errors.insert(all.errors.end(), own.errors.begin(), own.errors.end());
    for (std::size_t t = 0; t < own.mesh.triangles.size(); ++t)
        all.firstHidden.push_back(own.firstHidden[t] + static_cast<std::uint32_t>(all.hidden.size()));
    all.hidden.insert(all.hidden.end(), own.hidden.begin(), own.hidden.end());
}

/// Adds the triangles of the input that this part is the smallest to hold, and those of their corners that
/// are in no half.
void addTriangles(const PartSource& source, std::uint32_t part, std::uint32_t depth, PartMesh& gathered)
{
    MeasuredMesh& all = gathered.measured;
    std::unordered_map<std::uint32_t, std::uint32_t> places; // by number in the input
    for (std::uint32_t p = 0; p < gathered.inputs.size(); ++p)
        if (gathered.joinedAt[p] <= depth) places.emplace(gathered.inputs[p], p);
    const auto points = source.points();
    for (Triangle triangle : source.trianglesOf(part))
    {
        for (std::uint32_t& corner : triangle)
        {
            const auto [found, isNew] =
                places.try_emplace(corner, static_cast<std::uint32_t>(gathered.inputs.size()));
            if (isNew)
            {
                const SourcePoint point = points->at(corner);
                all.mesh.points.push_back(point.point);
                gathered.inputs.push_back(corner);
                gathered.joinedAt.push_back(point.joinedAt);
            }
            corner = found->second;
        }
        all.mesh.triangles.push_back(triangle);
    }
    all.errors.resize(all.mesh.triangles.size(), 0.0f);
    all.firstHidden.resize(all.mesh.triangles.size() + 1, static_cast<std::uint32_t>(all.hidden.size()));
}

} // namespace

BuiltPart buildPart(const PartSource& source, const Partition& partition, std::uint32_t part,
                    PartHalves halves)
{
    const PlanPart& own = partition.parts[part];
    std::vector<std::size_t> roots; // triangles of each half; they come first in what is gathered
    PartMesh gathered;
    for (std::size_t place = 0; place < halves.size(); ++place)
    {
        if (own.halves[place] == kNone) continue;
        roots.push_back(halves[place].measured.mesh.triangles.size());
        join(gathered, std::move(halves[place]));
    }
    addTriangles(source, part, own.depth, gathered);
    BuiltPart result;
    if (!source.isChecked() && !gathered.measured.mesh.triangles.empty())
        if ((result.fault = checkInput(gathered.measured.mesh))) return result;
    TreeOptions options;
    const std::size_t count = gathered.inputs.size();
    options.isLocked.resize(count);
    for (std::size_t p = 0; p < count; ++p)
        options.isLocked[p] = gathered.joinedAt[p] < own.depth;
    result.locked = static_cast<std::uint32_t>(std::ranges::count(options.isLocked, true));
    options.keep = own.depth == 0 ? 0 : result.locked + (count - result.locked) / 2;
    BuiltTree built = buildTree(gathered.measured, options);

    result.record.part = std::move(built.tree);
    auto root = built.triangle.begin();
    for (const std::size_t triangles : roots)
    {
        result.record.childRoots.emplace_back(root, root + static_cast<std::ptrdiff_t>(triangles));
        root += static_cast<std::ptrdiff_t>(triangles);
    }
    result.rest.allHidden = gathered.allHidden + result.record.part.fragments.size();
    if (own.depth == 0) return result;
    result.rest.measured = std::move(built.rest);
    for (std::uint32_t p = 0; p < result.rest.measured.mesh.points.size(); ++p)
    {
        result.rest.inputs.push_back(gathered.inputs[built.points[p]]);
        result.rest.joinedAt.push_back(gathered.joinedAt[built.points[p]]);
    }
    return result;
}

} // namespace osgMultiTriangulation::core
