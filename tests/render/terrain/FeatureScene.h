// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <osgOffscreen/OffscreenViewer>
#include <osgTerrainROAM/RoamTerrain>

namespace featurescene
{

constexpr int kWidthPx = 480;
constexpr int kHeightPx = 270;
constexpr double kFieldOfViewDeg = 45.0; ///< of the picture's height

/// A plain at height 0, 64 km wide, with features painted on it, in the light of a high sun and clear air;
/// under even snow where `snow` says so.
osg::ref_ptr<osgTerrainROAM::RoamTerrain>
plain(const std::vector<osgTerrainROAM::core::GroundFeature>& features, bool snow = false);

/// A line from a to b. Metres.
osgTerrainROAM::core::GroundFeature line(osgTerrainROAM::core::FeatureKind kind, double widthM,
                                         const glm::dvec2& a, const glm::dvec2& b);

/// Looks at a scene, from an eye in a direction.
class Camera
{
public:
    explicit Camera(osg::Node* scene, double fieldOfViewDeg = kFieldOfViewDeg);

    osg::ref_ptr<osg::Image> picture(const osg::Vec3d& eye, const osg::Vec3d& ahead, const osg::Vec3d& up);

    /// Where a place falls in the last picture: pixels from its lower left corner, pixel centres at halves.
    osg::Vec2d pixelOf(const osg::Vec3d& place) const;

private:
    std::unique_ptr<osgOffscreen::OffscreenViewer> _viewer;
};

/// Replaces one piece of text of the ground's shaders, which must hold it.
void mutate(osgTerrainROAM::RoamTerrain& terrain, const std::string& from, const std::string& to);

/// Mean of the three channels, 0…255.
double level(const osg::Image& picture, int x, int y);

} // namespace featurescene
