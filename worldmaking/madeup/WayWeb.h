// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "worldmaking/plan/PlanGrid.h"

namespace worldmaking
{

/// A street of a made-up map. Frame: the plane. Units: metres.
struct MadeWay
{
    std::string_view kind; ///< the value of highway
    std::vector<glm::dvec2> points;
    int settlement = -1; ///< within which it lies; -1: between them

    double halfWidthM() const;
};

/// The place of a web that is nearest to another.
struct WayMatch
{
    std::size_t way = 0, segment = 0;
    glm::dvec2 place{0.0}, along{1.0, 0.0}; ///< unit direction of the way there
    double distanceM = 0.0;
};

/// The streets of a made-up map. Streets that meet have a point in common, bit by bit.
/// Invariant after weave(): no two streets cross without one (crossesAnywhere()).
class WayWeb
{
public:
    /// Returns its number.
    std::size_t add(MadeWay way);

    const std::vector<MadeWay>& ways() const { return _ways; }

    /// The nearest place of all ways within a distance, but of the way `except`.
    std::optional<WayMatch> nearest(const glm::dvec2& place, double withinM,
                                    std::size_t except = kNone) const;

    /// Makes a place of a way one of its points. `place`: on the segment.
    void insert(std::size_t way, const glm::dvec2& place);

    /// Gives ways that cross, or end on another, a point in common.
    void weave();

    /// The ends of ways and the points that several have, in order.
    std::vector<glm::dvec2> knots() const;

    /// Whether two ways cross or touch without a common point; by looking at all pairs.
    bool crossesAnywhere() const;

    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

private:
    struct Piece
    {
        std::size_t way;
        glm::dvec2 a, b;
    };
    std::vector<MadeWay> _ways;
    std::vector<Piece> _pieces; ///< segments as they were added: insert() changes none of their lines
    PlanGrid _grid;
};

/// The nearest point of a line to a place.
glm::dvec2 nearestOn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& place);

/// Where two lines cross within both; nothing where they do not, or run alongside each other.
std::optional<glm::dvec2> crossingOf(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
                                     const glm::dvec2& d);

} // namespace worldmaking
