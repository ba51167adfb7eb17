// SPDX-License-Identifier: Apache-2.0
#include "PartJobs.h"

#include <algorithm>
#include <utility>

namespace osgMultiTriangulation::core
{

PartJobs::PartJobs(const SurfaceMesh& mesh, const Partition& partition)
    : _mesh(mesh),
      _partition(partition),
      _trianglesOf(mesh.triangles.size()),
      _firstOf(partition.parts.size() + 1, 0),
      _joinedAt(mesh.points.size(), 255),
      _current(mesh.points.size(), kNone),
      _rests(partition.parts.size()),
      _locked(partition.parts.size(), 0)
{
    std::vector<std::uint32_t> holders;
    holders.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles)
    {
        std::uint32_t holder = partition.partOf[t[0]];
        for (int c = 1; c < 3; ++c)
            holder = partition.common(holder, partition.partOf[t[c]]);
        const auto depth = static_cast<std::uint8_t>(std::min(partition.parts[holder].depth, 255u));
        for (const std::uint32_t corner : t)
            _joinedAt[corner] = std::min(_joinedAt[corner], depth);
        holders.push_back(holder);
        ++_firstOf[holder + 1];
    }
    for (std::size_t part = 1; part < _firstOf.size(); ++part)
        _firstOf[part] += _firstOf[part - 1];
    std::vector<std::uint32_t> next(_firstOf.begin(), _firstOf.end() - 1);
    for (std::uint32_t t = 0; t < holders.size(); ++t)
        _trianglesOf[next[holders[t]]++] = t;
}

TreeRecord PartJobs::build(std::uint32_t part)
{
    const PlanPart& own = _partition.parts[part];
    std::vector<std::size_t> roots; // triangles of each half; they come first in what is gathered
    for (const std::uint32_t half : own.halves)
        if (half != kNone) roots.push_back(_rests[half].measured.mesh.triangles.size());
    PartMesh gathered = gather(part);
    TreeOptions options;
    const std::size_t count = gathered.inputs.size();
    options.isLocked.resize(count);
    for (std::size_t p = 0; p < count; ++p)
        options.isLocked[p] = gathered.joinedAt[p] < own.depth;
    _locked[part] = static_cast<std::uint32_t>(std::ranges::count(options.isLocked, true));
    options.keep = own.depth == 0 ? 0 : _locked[part] + (count - _locked[part]) / 2;
    BuiltTree built = buildTree(gathered.measured, options);

    TreeRecord record{std::move(built.tree), {}};
    auto root = built.triangle.begin();
    for (const std::size_t triangles : roots)
    {
        record.childRoots.emplace_back(root, root + triangles);
        root += triangles;
    }
    if (own.depth == 0) return record;
    PartMesh rest;
    rest.measured = std::move(built.rest);
    for (std::uint32_t p = 0; p < rest.measured.mesh.points.size(); ++p)
    {
        rest.inputs.push_back(gathered.inputs[built.points[p]]);
        rest.joinedAt.push_back(gathered.joinedAt[built.points[p]]);
    }
    restore(part, std::move(rest));
    return record;
}

void PartJobs::restore(std::uint32_t part, PartMesh rest)
{
    for (std::uint32_t p = 0; p < rest.inputs.size(); ++p)
        _current[rest.inputs[p]] = p;
    _rests[part] = std::move(rest);
}

PartMesh PartJobs::gather(std::uint32_t part)
{
    PartMesh whole;
    for (const std::uint32_t half : _partition.parts[part].halves)
        if (half != kNone) join(whole, _rests[half]);
    addTriangles(part, whole);
    whole.measured.firstHidden.resize(whole.measured.mesh.triangles.size() + 1,
                                      static_cast<std::uint32_t>(whole.measured.hidden.size()));
    return whole;
}

/// Adds what is left of a half, and drops it there.
void PartJobs::join(PartMesh& whole, PartMesh& half)
{
    const auto firstPoint = static_cast<std::uint32_t>(whole.inputs.size());
    MeasuredMesh &all = whole.measured, &own = half.measured;
    if (firstPoint == 0)
    {
        whole = std::move(half);
        if (!whole.measured.firstHidden.empty()) whole.measured.firstHidden.pop_back();
        half = {};
        return;
    }
    for (const std::uint32_t input : half.inputs)
        _current[input] += firstPoint;
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
    half = {};
}

/// Adds the triangles of the input that this part is the smallest to hold, and those of their corners that are in no half.
void PartJobs::addTriangles(std::uint32_t part, PartMesh& gathered)
{
    MeasuredMesh& all = gathered.measured;
    for (std::uint32_t i = _firstOf[part]; i < _firstOf[part + 1]; ++i)
    {
        Triangle triangle = _mesh.triangles[_trianglesOf[i]];
        for (std::uint32_t& corner : triangle)
        {
            std::uint32_t& current = _current[corner];
            if (current == kNone)
            {
                current = static_cast<std::uint32_t>(gathered.inputs.size());
                all.mesh.points.push_back(_mesh.points[corner]);
                gathered.inputs.push_back(corner);
                gathered.joinedAt.push_back(_joinedAt[corner]);
            }
            corner = current;
        }
        all.mesh.triangles.push_back(triangle);
        all.errors.push_back(0.0f);
        all.firstHidden.push_back(static_cast<std::uint32_t>(all.hidden.size()));
    }
}

} // namespace osgMultiTriangulation::core
