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

/// The interface of arrangements: it decides in which slot of the index buffer each face lies, at every
/// level.
class FaceArrangement
{
public:
    virtual ~FaceArrangement() = default;

    /// Fills the slots of the full mesh, material by material.
    virtual void begin(const LevelWalk& walk, SlotTable& slots) = 0;

    /// Rearranges faces after a step. The faces that vanished are removed from `slots` before.
    virtual void afterStep(const LevelWalk& walk, SlotTable& slots) = 0;
};

/// Makes Arrangement::plain: faces lie in the order of their vanishing, latest first, so that nothing ever
/// moves.
std::unique_ptr<FaceArrangement> plainArrangement();

/// Makes Arrangement::tswap: a face that vanishes leaves a hole; whenever a share of the faces has vanished
/// (the atomic step), cycles of moves bring the others into the greedy order (GreedyOrder.h) and the holes to
/// the end (SlotCycles.h).
/// Source: *Cache-friendly view-independent progressive meshes* (Graphicon 2003), section 5. Differs: levels
/// within an atomic step are drawn, too, with holes.
std::unique_ptr<FaceArrangement> tswapArrangement(const ArrangementSettings& settings);

/// Makes Arrangement::blocks: the last face of a block fills its holes, and two neighbouring blocks that fit
/// into one merge.
std::unique_ptr<FaceArrangement> blockArrangement(const ArrangementSettings& settings);

/// Makes Arrangement::windows: holes stay until some neighbouring blocks fit into one block less. Then their
/// faces are reordered to cost least until the next time. A hole is drawn as a triangle without area at the
/// vertex drawn just before.
std::unique_ptr<FaceArrangement> windowArrangement(const ArrangementSettings& settings);

std::unique_ptr<FaceArrangement> makeArrangement(const ArrangementSettings& settings);

/// Returns the faces of each material at the walk's level, ascending.
std::vector<std::vector<std::uint32_t>> liveFacesByMaterial(const LevelWalk& walk);

/// Orders a few faces of many. It numbers their wedges from 0 in order of use, so the time does not depend on
/// the others.
class LocalNumbers
{
public:
    explicit LocalNumbers(const LevelWalk& walk);

    /// Returns the faces in the order that `order(triangles, wedgeCount)` gives their triangles.
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

    std::vector<std::uint32_t> _numbers; ///< by wedge: its local number
    std::uint32_t _count = 0;            ///< wedges of the last faces given
};

} // namespace osgPMObjects::core
