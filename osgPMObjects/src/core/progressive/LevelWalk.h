// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/Triangle.h>

#include "SplitOrder.h"

namespace osgPMObjects::core
{

/// Walks from the finest level to the coarsest, one step at a time, and holds the faces of the current level.
/// Faces keep their numbers.
/// Memory: 12 B a face, 24 B a wedge, and lists of the faces around each wedge. Cost of a step: the faces
/// around its wedges.
class LevelWalk
{
public:
    /// A corner of a face whose wedge is replaced by its parent.
    struct Patch
    {
        std::uint32_t face = 0;
        std::uint32_t from = 0; ///< the wedge that is removed
    };

    explicit LevelWalk(const SplitOrder& split);

    /// Removes the next position. patches() and vanished() tell what the last step changed.
    void step();

    std::uint32_t stepsTaken() const { return _steps; }
    std::uint32_t stepCount() const { return static_cast<std::uint32_t>(_split.errors.size()); }
    bool isLive(std::uint32_t face) const { return _isLive[face]; }
    std::uint32_t liveFaces() const { return _liveFaces; }
    std::uint32_t faceCount() const { return static_cast<std::uint32_t>(_triangles.size()); }
    std::uint32_t wedgeCount() const { return _wedgesLeft; } ///< of this level: the first ones

    /// Returns the wedges of a face; of a vanished face, its last ones.
    const Triangle& triangle(std::uint32_t face) const { return _triangles[face]; }
    const SplitOrder& split() const { return _split; }

    const std::vector<Patch>& patches() const { return _patches; } ///< by removed wedge, then by face
    const std::vector<std::uint32_t>& vanished() const { return _vanished; }

    /// Returns the faces that have ever used a wedge, vanished ones included.
    const std::vector<std::uint32_t>& facesOf(std::uint32_t wedge) const { return _facesOf[wedge]; }

private:
    bool vanishes(std::uint32_t face, std::uint32_t from, std::uint32_t to) const;
    void collapse(std::uint32_t from, std::uint32_t to);

    const SplitOrder& _split;
    std::vector<Triangle> _triangles;
    std::vector<bool> _isLive;
    std::vector<std::vector<std::uint32_t>> _facesOf;
    std::vector<Patch> _patches;
    std::vector<std::uint32_t> _vanished;
    std::uint32_t _steps = 0, _liveFaces = 0, _wedgesLeft = 0;
};

} // namespace osgPMObjects::core
