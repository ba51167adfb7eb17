// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "../envelope/Envelope.h"
#include "../parts/ConnectedParts.h"
#include "../parts/LeafCards.h"
#include "../quadric/Placement.h"
#include "../star/StarMesh.h"
#include "../symmetry/MirrorTwins.h"
#include "../symmetry/RotationOrbits.h"
#include "AreaCost.h"
#include "CollapseQueue.h"
#include "UnitFrame.h"

namespace osgPMObjects::core
{

/// The best known collapse of a position.
struct Candidate
{
    std::uint32_t to = ~0u;
    std::uint32_t changes = 0, changesOfTo = 0; ///< counters of both stars at the time of the choice
    std::uint32_t neighbours = 0;               ///< number of neighbours that were compared
    Urgency urgency;
};

/// Cost of removing the last face of a material, as a distance of all its area and a share of the diagonal.
constexpr double kMaterialDistance = 0.5;

/// A mesh during simplification. Data of each position and face belong to one connected part, so threads that
/// work on different parts do not share any.
struct CollapseState
{
    const SimplifySettings settings;
    AreaWeight weight;
    std::unique_ptr<Mesh>
        movedMesh;    ///< with optimal placement: a copy without positions, whose wedges change
    const Mesh& mesh; ///< movedMesh, or the original
    UnitFrame frame;
    std::vector<glm::dvec3> positions; ///< in the unit frame
    Extent box;                        ///< in the unit frame
    StarMesh stars;
    RotationOrbits orbits;              ///< of a round mesh
    MirrorTwins twins;                  ///< of another one
    std::unique_ptr<Envelope> envelope; ///< null: no envelope
    std::vector<ConnectedPart> parts;
    std::vector<std::uint32_t> partOf; ///< by position: its part at the start
    std::vector<std::vector<LeafCard>>
        foliage; ///< by material: parts that a LeafCollapser simplifies instead of a Collapser
    mutable std::vector<std::uint32_t> joinedTo; ///< by part: the part it has joined; itself: none
    std::vector<std::uint32_t>
        nearby; ///< by position: the nearest one of another part; empty: parts do not join
    mutable std::vector<std::uint32_t> wentTo; ///< by position: the one it has merged into; itself: none
    AreaCost areaCost;
    std::vector<StarShape> shapes;               ///< by position
    std::vector<AccumulatedQuadric> accumulated; ///< by position; empty: quadrics are memoryless
    std::vector<LevelError> errors;              ///< by position: of everything merged into it
    std::vector<std::uint32_t> changes;          ///< by position: number of changes of its star
    std::vector<Candidate> candidates;           ///< by position

    CollapseState(const Mesh& original, const SimplifySettings& settings);

    bool movesPlaces() const { return settings.placement != Placement::subset; }
    ConnectedPart& part(std::uint32_t position) { return parts[partNumber(position)]; }
    const ConnectedPart& part(std::uint32_t position) const { return parts[partNumber(position)]; }
    std::uint32_t partNumber(std::uint32_t position) const { return followed(joinedTo, partOf[position]); }
    /// The position that the nearest position of another part has merged into; ~0: none, or it is in the same
    /// part now.
    std::uint32_t nearbyNow(std::uint32_t position) const;
    /// Joins the parts of two positions.
    void joinParts(std::uint32_t from, std::uint32_t to);

private:
    /// The end of a path; shortens the path on the way.
    static std::uint32_t followed(std::vector<std::uint32_t>& next, std::uint32_t i)
    {
        while (next[i] != i)
            i = next[i] = next[next[i]];
        return i;
    }
};

} // namespace osgPMObjects::core
