// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgMultiTriangulation/core/build/BuildTree.h>
#include <osgMultiTriangulation/core/split/BuildForest.h>
#include <osgMultiTriangulation/core/structure/TreeRecord.h>

namespace osgMultiTriangulation::core
{

/// What is left of a part of the surface after its tree has been built, or what a tree is built from.
struct PartMesh
{
    MeasuredMesh measured;
    std::vector<std::uint32_t> inputs;  ///< by point of the mesh: its number in the input
    std::vector<std::uint8_t> joinedAt; ///< by point: depth of the part that has all triangles around it
};

/// The jobs of a split build: one for each part of a partition. A part may be built once its halves are.
/// Threads: parts that do not hold each other may be built at once.
class PartJobs
{
public:
    PartJobs(const SurfaceMesh& mesh, const Partition& partition);

    /// Builds the tree of a part, and keeps what is left of it for the part above.
    TreeRecord build(std::uint32_t part);

    /// What is left of a part that was built, until the part above is.
    const PartMesh& restOf(std::uint32_t part) const { return _rests[part]; }

    /// Goes on from a part that was built by an earlier run.
    void restore(std::uint32_t part, PartMesh rest);

    /// The points that stay on the border of a part, after it was built.
    std::uint32_t lockedIn(std::uint32_t part) const { return _locked[part]; }

private:
    PartMesh gather(std::uint32_t part);
    void addTriangles(std::uint32_t part, PartMesh& gathered);
    void join(PartMesh& whole, PartMesh& half);

    const SurfaceMesh& _mesh;
    const Partition& _partition;
    std::vector<std::uint32_t> _trianglesOf; ///< triangles of the input, by the smallest part that holds them
    std::vector<std::uint32_t> _firstOf;     ///< by part, and one more
    std::vector<std::uint8_t> _joinedAt;     ///< by point of the input
    std::vector<std::uint32_t>
        _current;                 ///< by point of the input: its number in the part it is in; kNone: in none
    std::vector<PartMesh> _rests; ///< by part
    std::vector<ForestTree> _trees;     ///< by part
    std::vector<std::uint32_t> _locked; ///< by part
};

} // namespace osgMultiTriangulation::core
