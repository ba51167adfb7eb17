// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include <osgPMObjects/core/simplify/RemoveVertices.h>

#include "VertexStar.h"

namespace osgPMObjects::core
{

/// Finds faces that fill the hole of a removed star, sector by sector, and decides whether it may be removed.
/// Threads: one; its memory is reused.
class HoleFilling
{
public:
    explicit HoleFilling(const LiveFaces& live) : _live(live) {}

    /// Errors: the reason why the position has to stay; faces() is then undefined.
    RemovalRefusal fill(const VertexStar& star, HoleTriangulation triangulation);

    /// Returns the position at which all new faces meet; RemovalStep::kNoApex for
    /// HoleTriangulation::delaunay.
    std::uint32_t apex() const { return _apex; }

    const std::vector<Face>& faces() const { return _faces; }

    /// The distance of the position from the new faces; where there are none, from the lines that close its
    /// contours.
    double distance() const { return _distance; }

private:
    /// A way to fill the hole by faces that meet at one position.
    struct Fan
    {
        double cosine; ///< of the least angle of a new face
        std::uint32_t apex;

        bool operator<(const Fan& other) const
        {
            return std::tie(cosine, apex) < std::tie(other.cosine, other.apex);
        }
    };

    RemovalRefusal fillByFan(const VertexStar& star);
    RemovalRefusal fitness(const VertexStar& star);
    void findFans(const VertexStar& star);
    bool addFan(const VertexStar& star, std::uint32_t apex);
    bool fillSector(const VertexStar& star, const StarSector& sector, std::uint32_t apex);
    void takeContour(const VertexStar& star, const StarSector& sector);
    bool project(const glm::dvec3& sectorNormal);
    bool triangulate(std::uint32_t apex);
    bool liesFlat(const Triangle& triangle, const glm::dvec3& sectorNormal) const;
    double leastAngleCosine() const;
    bool joins(const VertexStar& star) const;
    bool isTaken(std::uint32_t removed, const Triangle& added, std::size_t along, std::size_t against) const;
    bool isolates(const VertexStar& star) const;
    bool endsMaterial(const VertexStar& star) const;
    std::size_t addedSides(std::uint32_t from, std::uint32_t to) const;
    void measure(const VertexStar& star);

    const LiveFaces& _live;
    std::vector<Face> _faces;
    std::vector<Triangle> _corners; ///< position numbers of _faces
    double _distance = 0.0;
    std::uint32_t _apex = RemovalStep::kNoApex;
    std::vector<Fan> _fans; ///< the best first

    // of the current sector
    std::vector<std::uint32_t> _positions, _wedges;
    glm::dvec3 _up{0.0}; ///< normal of the plane that fits the contour
    std::vector<glm::dvec3> _contour;
    std::vector<glm::dvec2> _flat;
    std::vector<Triangle> _triangles;
};

} // namespace osgPMObjects::core
