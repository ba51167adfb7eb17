// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <utility>

#include <osg/Geode>

#include <osgRoads/core/read/ReadNetwork.h>
#include <osgRoads/core/surface/BuildRoadMesh.h>

#include <osgRoads/OpenNetwork>
#include <osgRoads/RoadDrawable>
#include <osgRoads/RoadShader>

namespace osgRoads
{

namespace
{

constexpr double kEverywhereM = 1e9;

} // namespace

core::RoadViewSettings settingsWithoutGround()
{
    core::RoadViewSettings settings;
    settings.liftPx = 0.0;
    settings.farthestM = kEverywhereM;
    return settings;
}

foundation::Result<osg::ref_ptr<osg::Node>> openNetwork(const std::filesystem::path& file,
                                                        const core::RoadViewSettings& settings)
{
    auto read = core::readNetwork(file);
    if (!read) return read.error();
    const core::PlacedNetwork placed(std::make_shared<const core::RoadNetwork>(std::move(read->network)));
    const auto mesh = std::make_shared<const core::RoadMesh>(
        core::buildRoadMesh(placed, core::meshSettingsFor(placed.network())));
    const osg::ref_ptr<RoadDrawable> drawable = new RoadDrawable(mesh);
    if (const auto set = drawable->setSettings(settings); !set) return set.error();
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->setName(file.filename().string());
    geode->addDrawable(drawable);
    geode->getOrCreateStateSet()->setAttributeAndModes(makeRoadProgram());
    for (const std::string& message : core::firstMessages(read->problems, file.string()))
        geode->addDescription(message);
    if (const std::string unreached = core::unreachedMessage(*mesh, placed.network(), file.string());
        !unreached.empty())
        geode->addDescription(unreached);
    return osg::ref_ptr<osg::Node>(geode);
}

} // namespace osgRoads
