// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include <osgPMObjects/core/mesh/TriangleTree.h>

#include "../star/StarMesh.h"

namespace osgPMObjects::core
{

using Corners = std::array<glm::dvec3, 3>;

/// A bound of the distance between the original surface and the current mesh. Each original triangle has a
/// *home*: a position whose star is within `distance` of all of the triangle. So both surfaces are within the
/// distance of each other after any number of collapses; this is proved, not sampled.
/// Invariant: every original triangle is within the distance of its home's star, and every face within the
/// distance of the original.
/// Memory: 100 B a triangle. Threads: any number at once, on different parts.
/// Source: the guarantee of Cohen et al., *Simplification envelopes* (1996). Differs: distances are bounded
/// by convexity, not by offset surfaces, which need a manifold.
class Envelope
{
public:
    Envelope(std::vector<glm::dvec3> positions, std::vector<Triangle> triangles, double distance);

    /// Tells whether a new face is within the distance of the original.
    bool holds(const Corners& face) const;

    /// Tells whether an original triangle is within the distance of some faces.
    bool isCovered(std::uint32_t triangle, std::span<const Corners> faces) const;

    /// Calls visit(triangle) for each original triangle whose home is a position.
    template<class Visit>
    void visitHomeOf(std::uint32_t position, const Visit& visit) const
    {
        for (std::uint32_t t = _first[position]; t != kNone; t = _next[t])
            visit(t);
    }

    /// Moves the home of an original triangle from a position to another.
    void move(std::uint32_t triangle, std::uint32_t from, std::uint32_t to);

private:
    static constexpr std::uint32_t kNone = ~0u;

    std::vector<glm::dvec3> _positions;
    std::vector<Triangle> _triangles;
    TriangleTree _tree;
    double _distance;
    std::vector<std::uint32_t> _first; ///< by position: the first triangle with its home there
    std::vector<std::uint32_t> _next;  ///< by triangle: the next one with the same home
};

/// Tests collapses against an envelope, and updates the homes of its triangles.
class EnvelopeGuard
{
public:
    EnvelopeGuard(Envelope& envelope, const StarMesh& stars, std::span<const glm::dvec3> positions)
        : _envelope(envelope), _stars(stars), _positions(positions)
    {
    }

    /// Tells whether both surfaces stay within the distance when `from` merges into `to` at position `at`.
    bool allows(std::uint32_t from, std::uint32_t to, const glm::dvec3& at);

    /// Moves homes for the collapse that was allowed last; call it before the collapse is done.
    void commit();

private:
    struct Move
    {
        std::uint32_t triangle, from, to;
    };

    void gatherRing();
    void starAfter(std::uint32_t position, std::vector<Corners>& faces) const;
    bool newFacesHold();
    bool findsHome(std::uint32_t triangle, std::uint32_t home);

    Envelope& _envelope;
    const StarMesh& _stars;
    std::span<const glm::dvec3> _positions;
    std::uint32_t _from = 0, _to = 0;
    glm::dvec3 _at{0.0};
    std::vector<std::uint32_t> _ring; ///< starts with `to`
    std::vector<std::vector<Corners>> _ringStars;
    std::vector<Move> _moves;
};

} // namespace osgPMObjects::core
