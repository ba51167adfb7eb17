// SPDX-License-Identifier: Apache-2.0
#include "measurement/light/view/AirPictures.h"

#include <cmath>
#include <memory>
#include <utility>

#include <osg/Math>
#include <osg/Uniform>

#include <osgRoads/core/read/ReadNetwork.h>
#include <osgRoads/core/surface/BuildRoadMesh.h>
#include <osgTerrainROAM/core/Climate.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

#include <osgTerrainROAM/RoamTerrain>
#include <osgTerrainROAM/TerrainMaterial>

#include "measurement/light/view/GreyBox.h"
#include "measurement/light/view/ShownLight.h"
#include "scenery/nodes/RoadShading.h"

namespace measurement
{

namespace
{

constexpr int kAirWidePx = 32, kAirHighPx = 18;
constexpr float kExposure = 0.4F;  ///< of all these pictures: the air of a bright day leaves room for more
constexpr double kHalfSeenM = 1.2; ///< of the surface, across the picture
constexpr double kAsideM = 1.75;   ///< the middle of a lane

/// A road of two lanes along x, 100 m to both sides.
foundation::Result<osg::ref_ptr<osg::Node>> roadOf()
{
    constexpr const char* kRoad = R"(<OpenDRIVE><header revMajor="1" revMinor="7"/>
<road id="1" length="200" junction="-1"><planView><geometry s="0" x="-100" y="0" hdg="0" length="200"><line/></geometry></planView>
<lanes><laneSection s="0"><left><lane id="1" type="driving" level="false"><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></left>
<center><lane id="0" type="none" level="false"/></center>
<right><lane id="-1" type="driving" level="false"><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></right></laneSection></lanes>
</road></OpenDRIVE>)";
    auto read = osgRoads::core::parseNetwork(kRoad, "the road that is measured");
    if (!read) return read.error();
    const auto network = std::make_shared<const osgRoads::core::RoadNetwork>(std::move(read->network));
    return scenery::makeRoadNode(std::make_shared<const osgRoads::core::RoadMesh>(
        osgRoads::core::buildRoadMesh(osgRoads::core::PlacedNetwork(network))));
}

osg::ref_ptr<osgTerrainROAM::RoamTerrain> groundOf()
{
    using namespace osgTerrainROAM;
    constexpr int kSide = 65;
    core::HeightField field;
    field.name = "plain";
    field.columns = field.rows = kSide;
    field.spacingEastM = field.spacingNorthM = 250.0;
    // A millimetre from sample to sample: ground that is exactly level is taken for water.
    for (int i = 0; i < kSide * kSide; ++i)
        field.heightsM.push_back(0.001F * static_cast<float>(i % 2));
    const auto tile = std::make_shared<const core::RoamTile>(
        core::PlacedTile(std::move(field), core::Placement::planar, core::Storage::compact));
    core::LandParameters land;
    land.seaLevelM = -100.0;
    return new RoamTerrain(tile, new TerrainMaterial(tile->tile, climateOf(tile->tile, land)));
}

} // namespace

foundation::Result<std::unique_ptr<AirPictures>> AirPictures::create(SeenSurface surface)
{
    osgOffscreen::OffscreenSettings settings;
    settings.widthPx = kAirWidePx;
    settings.heightPx = kAirHighPx;
    settings.samples = 1;
    auto viewer = osgOffscreen::OffscreenViewer::create(settings);
    if (!viewer) return viewer.error();
    osg::ref_ptr<osg::Node> node;
    if (surface == SeenSurface::ground)
        node = groundOf();
    else if (surface == SeenSurface::road)
    {
        auto road = roadOf();
        if (!road) return road.error();
        node = *road;
    }
    else
        node = greyBox({-100.0F, -100.0F, -0.1F}, {100.0F, 100.0F, 0.0F}, 0.6F,
                       surface == SeenSurface::object ? scenery::Finish::matt : scenery::Finish::lacquered);
    return std::unique_ptr<AirPictures>(new AirPictures(node, std::move(*viewer)));
}

AirPictures::AirPictures(osg::Node* surface, std::unique_ptr<osgOffscreen::OffscreenViewer> viewer)
    : _root(new osg::Group), _atmosphere(new osgSky::Atmosphere), _viewer(std::move(viewer))
{
    _atmosphere->addUniformsTo(*_root->getOrCreateStateSet());
    if (auto* const terrain = dynamic_cast<osgTerrainROAM::RoamTerrain*>(surface))
        terrain->setAtmosphere(_atmosphere);
    _root->addChild(surface);
    _viewer->viewer().setSceneData(_root);
}

/// The green of the middle of the picture, as light times exposure, where the surface is lit by a sky of
/// `light` from all sides.
double AirPictures::lightSeen(double light)
{
    const auto all = static_cast<float>(light);
    osg::StateSet& uniforms = *_atmosphere->stateSet();
    for (const char* name : {"atmosphereSky", "atmosphereGround"})
        uniforms.getUniform(name)->set(osg::Vec3f(all, all, all));
    uniforms.getUniform("atmosphereSun")->set(osg::Vec3f());
    uniforms.getUniform("atmosphereExposure")->set(kExposure);
    uniforms.getUniform("atmosphereLayer")->set(osg::Vec2f()); // as dense at every height
    const osg::ref_ptr<osg::Image> picture = _viewer->picture();
    double sum = 0.0;
    int count = 0;
    for (unsigned x = kAirWidePx / 4; x < 3 * kAirWidePx / 4; ++x)
        for (unsigned y = kAirHighPx / 4; y < 3 * kAirHighPx / 4; ++y, ++count)
            sum += exposedOf(picture->data(x, y)[1] / 255.0);
    return sum / count;
}

/// By how much more light is seen for more light on the surface: the slope of a straight line through
/// pictures with a sky from 0 to `mostLight`.
double AirPictures::slope(double awayM, const osgSky::AtmosphereSettings& air, double mostLight)
{
    constexpr int kPictures = 24;
    static_cast<void>(_atmosphere->setSettings(air)); // made from numbers in range
    if (_spoil) _spoil(*_atmosphere->stateSet());
    _viewer->camera().setProjectionMatrixAsPerspective(
        2.0 * osg::RadiansToDegrees(std::atan(kHalfSeenM / awayM)),
        static_cast<double>(kAirWidePx) / kAirHighPx, 0.5 * awayM, 2.0 * awayM);
    _viewer->camera().setViewMatrixAsLookAt({0.0, kAsideM, awayM}, {0.0, kAsideM, 0.0}, {0.0, 1.0, 0.0});
    double sumX = 0.0, sumY = 0.0, sumXX = 0.0, sumXY = 0.0;
    for (int i = 0; i < kPictures; ++i)
    {
        const double light = mostLight * i / (kPictures - 1), seen = lightSeen(light);
        sumX += light;
        sumY += seen;
        sumXX += light * light;
        sumXY += light * seen;
    }
    return (kPictures * sumXY - sumX * sumY) / (kPictures * sumXX - sumX * sumX);
}

double AirPictures::contrastLeft(double awayM, double visibilityM, double sunElevationDeg)
{
    constexpr double kClearM = 1e9, kMostSeen = 0.7;
    osgSky::AtmosphereSettings air;
    air.sunDirectionWorld = osgSky::sunDirectionFromAngles(180.0, sunElevationDeg);
    air.visibilityM = kClearM;
    const auto [known, isNew] = _clear.try_emplace(awayM, 0.0);
    if (isNew) known->second = slope(awayM, air, kMostSeen / slope(awayM, air, 1.0));
    const double clear = known->second;
    air.visibilityM = visibilityM;
    return slope(awayM, air, kMostSeen / clear * std::exp(3.0 * awayM / visibilityM)) / clear;
}

} // namespace measurement
