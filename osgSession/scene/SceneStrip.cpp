// SPDX-License-Identifier: Apache-2.0
#include "SceneStrip.h"

#include <cmath>
#include <numeric>

#include <foundation/Angle.h>

#include <osgTerrainROAM/core/edit/GroundEditor.h>

#include "scenery/ground/TileGround.h"

namespace trainer
{

namespace
{

constexpr int kHeightsAlong = 50;
constexpr double kShoulderM = 15.0; ///< of level ground on either side and at the ends

glm::dvec2 alongStrip(const StripRequest& strip)
{
    const double course = foundation::radiansOf(strip.courseDeg);
    return {std::sin(course), std::cos(course)};
}

} // namespace

osgTerrainROAM::core::GroundFeature paintedStrip(const StripRequest& strip)
{
    osgTerrainROAM::core::GroundFeature runway;
    runway.style.kind = osgTerrainROAM::core::FeatureKind::runway;
    runway.style.widthM = strip.widthM;
    runway.paths = {{strip.threshold, strip.threshold + strip.lengthM * alongStrip(strip)}};
    return runway;
}

foundation::Result<osgTerrainROAM::core::GroundFeature>
layStrip(const std::shared_ptr<osgTerrainROAM::core::RoamTile>& tile, const StripRequest& strip)
{
    const glm::dvec2 along = alongStrip(strip);
    osgTerrainROAM::core::Ribbon ribbon;
    ribbon.points = {strip.threshold - kShoulderM * along,
                     strip.threshold + (strip.lengthM + kShoulderM) * along};
    ribbon.widthM = strip.widthM + 2.0 * kShoulderM;
    const auto query = ground::groundOf(tile->tile);
    std::vector<double> alongM;
    for (int i = 0; i <= kHeightsAlong; ++i)
    {
        alongM.push_back(kShoulderM + strip.lengthM * i / kHeightsAlong);
        const glm::dvec2 place = ribbon.points[0] + along * alongM.back();
        if (!query(place.x, place.y))
            return foundation::Error{"--strip", "the strip lies beyond the data of the terrain", "move it"};
    }
    osgTerrainROAM::core::GroundEditor editor(tile);
    const std::vector<double> groundM = editor.profile(ribbon, alongM);
    ribbon.heightsM.assign(2, std::accumulate(groundM.begin(), groundM.end(), 0.0) /
                                  static_cast<double>(groundM.size()));
    const auto laid = editor.conform(ribbon);
    if (!laid) return foundation::Error{"--strip", laid.error().what, laid.error().remedy};
    return paintedStrip(strip);
}

} // namespace trainer
