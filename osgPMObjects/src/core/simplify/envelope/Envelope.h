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

/// The original surface, and where each of its triangles is found on the mesh as it is now: each has a *home*, a position
/// whose star it is within `distance` of. So however many collapses there were, both surfaces are within the distance of each other, proved
/// and not sampled.
/// Invariant: every original triangle is within the distance of its home's star; every face of the mesh within the distance
/// of the original.
/// Memory: 100 B a triangle. Threads: any number at once, on different parts.
/// Source: the guarantee of Cohen et al., "Simplification envelopes" (1996); we bound distances by convexity instead of building offset
/// surfaces, which need a manifold.
class Envelope
{
public:
    Envelope(std::vector<glm::dvec3> positions, std::vector<Triangle> triangles, double distance);

    /// Whether a new face stays near the original.
    bool holds(const Corners& face) const;

    /// Whether an original triangle stays near some faces.
    bool isCovered(std::uint32_t triangle, std::span<const Corners> faces) const;

    template<class Visit>
    void visitHomeOf(std::uint32_t position, const Visit& visit) const
    {
        for (std::uint32_t t = _first[position]; t != kNone; t = _next[t])
            visit(t);
    }

    void move(std::uint32_t triangle, std::uint32_t from, std::uint32_t to);

private:
    static constexpr std::uint32_t kNone = ~0u;

    std::vector<glm::dvec3> _positions;
    std::vector<Triangle> _triangles;
    TriangleTree _tree;
    double _distance;
    std::vector<std::uint32_t> _first; ///< by position: a triangle at home there
    std::vector<std::uint32_t> _next;  ///< by triangle
};

/// Asks an envelope about collapses, and keeps its homes.
class EnvelopeGuard
{
public:
    EnvelopeGuard(Envelope& envelope, const StarMesh& stars, std::span<const glm::dvec3> positions)
        : _envelope(envelope), _stars(stars), _positions(positions)
    {
    }

    /// Whether both surfaces stay within the distance when a position goes into another, at a place.
    bool allows(std::uint32_t from, std::uint32_t to, const glm::dvec3& at);

    /// Has to be called before what was allowed last is done.
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
    std::vector<std::uint32_t> _ring; ///< `to` first
    std::vector<std::vector<Corners>> _ringStars;
    std::vector<Move> _moves;
};

} // namespace osgPMObjects::core
