// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <foundation/Result.h>
#include <glm/glm.hpp>

namespace scenery
{

/// The way from a network's plan to the scene and back, interpolated between nodes, so that no projection is
/// computed for each vertex of a road. A place of the plan is a point of the scene for each height: p(x, y) +
/// height · up(x, y).
/// Units: metres. Errors: of the cubic interpolation 1e-6 m on networks of 40 km; those of the nodes'
/// positions themselves.
/// Memory: 48 B a node, at most 67² of them. Threads: const, any.
/// Source: Lagrange's cubic through four nodes in each direction (Abramowitz & Stegun, *Handbook of
/// Mathematical Functions*, 1964, 25.2.13).
class PlanMap
{
public:
    /// Returns the place in the scene of a point of the plan at a height.
    using Place = std::function<foundation::Result<glm::dvec3>(const glm::dvec2& plan, double heightM)>;

    /// Covers the box from `low` to `high`. Errors: the first that `place` returns.
    static foundation::Result<PlanMap> create(const glm::dvec2& low, const glm::dvec2& high,
                                              const Place& place);

    /// `plan`: x, y and height.
    glm::dvec3 toScene(const glm::dvec3& plan) const;

    /// The inverse, by Newton's method with the slopes of the box's middle; within 1e-8 m.
    glm::dvec3 toPlan(const glm::dvec3& scene) const;

private:
    struct Node
    {
        glm::dvec3 position{0.0}, up{0.0, 0.0, 1.0};
    };

    /// An affine map is computed without weights: on a plane tile it is one.
    struct Affine
    {
        Node origin;
        glm::dvec3 east{0.0}, north{0.0}; ///< of one step
    };

    Node at(const glm::dvec2& plan) const;
    std::optional<Affine> affineMap() const;

    glm::dvec2 _low{0.0}, _middle{0.0}, _stepM{1.0};
    int _columns = 0, _rows = 0;
    std::vector<Node> _nodes; ///< row-major; the first is one step before _low in both directions
    std::optional<Affine> _affine;
    glm::dmat3 _toPlan{1.0};
};

} // namespace scenery
