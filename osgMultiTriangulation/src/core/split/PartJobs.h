// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <osgMultiTriangulation/core/build/BuildTree.h>
#include <osgMultiTriangulation/core/structure/TreeRecord.h>

#include "PartSource.h"

namespace osgMultiTriangulation::core
{

/// What is left of a part of the surface after its tree has been built, or what a tree is built from.
struct PartMesh
{
    MeasuredMesh measured;
    std::vector<std::uint32_t> inputs;  ///< by point of the mesh: its number in the input
    std::vector<std::uint8_t> joinedAt; ///< by point: depth of the part that has all triangles around it
    std::uint64_t allHidden =
        0; ///< hidden points; those beyond the ones in the mesh are in a file (PartStore.h)
    std::uint32_t hiddenSum = 0; ///< of that file

    bool hasAllHidden() const { return allHidden == measured.hidden.size(); }
};

/// A part that was built.
struct BuiltPart
{
    TreeRecord record;
    PartMesh rest;                      ///< for the part above; empty for the whole
    std::uint32_t locked = 0;           ///< points that stay on its border
    std::optional<std::string> fault{}; ///< of an input that was not checked; then there is no tree
};

/// The halves of a part, built before; empty where there is none.
using PartHalves = std::array<PartMesh, 2>;

/// Builds the tree of a part, from what is left of its halves and the triangles between them. The same halves
/// give the same part, wherever and how often it is built.
BuiltPart buildPart(const PartSource& source, const Partition& partition, std::uint32_t part,
                    PartHalves halves);

} // namespace osgMultiTriangulation::core
