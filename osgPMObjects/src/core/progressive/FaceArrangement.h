// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <osgPMObjects/core/progressive/ProgressiveMesh.h>

#include "LevelWalk.h"
#include "SlotTable.h"

namespace osgPMObjects::core
{

/// Where the faces of a mesh lie in its index buffer, at every level.
class FaceArrangement
{
public:
    virtual ~FaceArrangement() = default;

    /// The slots of the full mesh, material by material.
    virtual void begin(const LevelWalk& walk, SlotTable& slots) = 0;

    /// Rearranges after a step. The dead of the walk are buried already.
    virtual void afterStep(const LevelWalk& walk, SlotTable& slots) = 0;
};

/// Plain VIPM: the faces that vanish are always the last. Nothing ever moves.
std::unique_ptr<FaceArrangement> plainArrangement();

/// The paper's tswap: the last face goes into each hole, and whenever some share of the faces has vanished the paper's greedy order
/// (GreedyOrder.h) is made of the others, in cycles.
/// Source: paper 003, §5.
std::unique_ptr<FaceArrangement> tswapArrangement(const ArrangementSettings& settings);

/// Blocks of a few faces: a hole is filled with the last face of its block, and two neighbours that have room in one become one.
std::unique_ptr<FaceArrangement> blockArrangement(const ArrangementSettings& settings);

/// Ours: holes stay until some neighbouring blocks have room in one less; then those are ordered anew, in the way that costs
/// least until they will be again. A hole is drawn as a triangle without area, all of whose corners are the vertex drawn just before.
std::unique_ptr<FaceArrangement> windowArrangement(const ArrangementSettings& settings);

std::unique_ptr<FaceArrangement> makeArrangement(const ArrangementSettings& settings);

/// The live faces of each material, in order of their numbers.
std::vector<std::vector<std::uint32_t>> liveFacesByMaterial(const LevelWalk& walk);

/// Orders some faces of many: their wedges are numbered from 0 as they come, so that it takes no longer for the others.
class LocalNumbers
{
public:
    explicit LocalNumbers(const LevelWalk& walk);

    /// Faces in the order that `order(triangles, wedgeCount)` puts their triangles in, as numbers.
    template<class Order>
    std::vector<std::uint32_t> ordered(const LevelWalk& walk, std::span<const std::uint32_t> faces,
                                       const Order& order)
    {
        const std::vector<Triangle> triangles = trianglesOf(walk, faces);
        std::vector<std::uint32_t> numbers = order(triangles, _count);
        for (std::uint32_t& number : numbers)
            number = faces[number];
        return numbers;
    }

private:
    std::vector<Triangle> trianglesOf(const LevelWalk& walk, std::span<const std::uint32_t> faces);

    static constexpr std::uint32_t kNone = ~0u;

    std::vector<std::uint32_t> _numbers; ///< by wedge
    std::uint32_t _count = 0;            ///< of the faces that were looked at last
};

} // namespace osgPMObjects::core
