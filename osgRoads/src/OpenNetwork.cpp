// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
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

constexpr std::size_t kMostNotes = 10;
constexpr double kEverywhereM = 1e9;

void describe(osg::Node& node, const std::string& file, const std::vector<core::Problem>& problems)
{
    for (std::size_t i = 0; i < std::min(problems.size(), kMostNotes); ++i)
        node.addDescription(problems[i].message(file));
    if (problems.size() > kMostNotes)
        node.addDescription(file + ": " + std::to_string(problems.size() - kMostNotes) +
                            " more; roadtool validate tells them all");
}

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
    const osg::ref_ptr<RoadDrawable> drawable =
        new RoadDrawable(std::make_shared<const core::RoadMesh>(core::buildRoadMesh(placed)));
    if (const auto set = drawable->setSettings(settings); !set) return set.error();
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->setName(file.filename().string());
    geode->addDrawable(drawable);
    geode->getOrCreateStateSet()->setAttributeAndModes(makeRoadProgram());
    describe(*geode, file.string(), read->problems);
    return osg::ref_ptr<osg::Node>(geode);
}

} // namespace osgRoads
