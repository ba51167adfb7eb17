// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgRoads/core/place/PlacedNetwork.h>
#include <osgRoads/core/place/RoadBed.h>
#include <osgRoads/core/surface/RoadMesh.h>

namespace osgRoads::core
{

/// A strip of a cross-section, from right to left: a lane, the step between two lanes, a verge or a skirt.
struct Strip
{
    SurfaceKind kind = SurfaceKind::asphalt;
    const Lane* lane = nullptr;      ///< of a lane
    const Lane* rightMark = nullptr; ///< whose marks lie at its borders; null: none
    const Lane* leftMark = nullptr;
    int columns = 2;
    bool isBesideLanes() const { return !lane && kind != SurfaceKind::kerb; }
};

/// A point of a cross-section.
struct SectionPoint
{
    double t = 0.0, h = 0.0;
    double across = 0.0, width = 0.0; ///< within its strip
};

/// The cross-sections of one lane section: the same strips and columns at every s.
class CrossSection
{
public:
    CrossSection(const Road& road, const LaneSection& section, const RoadBed& bed);

    const std::vector<Strip>& strips() const { return _strips; }
    std::size_t columns() const { return _columns; }

    /// Replaces `points` by those of one s, strip after strip, each from right to left.
    void pointsAt(double s, std::vector<SectionPoint>& points) const;

private:
    void addLane(const Lane& lane, int columns);

    const Road& _road;
    const LaneSection& _section;
    RoadBed _bed;
    bool _hasSteps;
    std::vector<Strip> _strips;
    std::size_t _columns = 0;
};

} // namespace osgRoads::core
