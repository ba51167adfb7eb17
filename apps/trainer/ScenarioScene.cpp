// SPDX-License-Identifier: Apache-2.0
#include "ScenarioScene.h"

#include <algorithm>
#include <map>

#include <osg/Notify>

#include "scenery/nodes/Sky.h"

namespace trainer
{

namespace
{

/// Returns the cloud cover 0…1 of the cloud states of OpenSCENARIO 1.0 and of 1.2 (oktas).
double cloudCover(const std::string& state)
{
    static const std::map<std::string, double> kCover{
        {"free", 0.0},      {"cloudy", 0.6},      {"overcast", 1.0},  {"rainy", 1.0},
        {"zeroOktas", 0.0}, {"oneOktas", 0.125},  {"twoOktas", 0.25}, {"threeOktas", 0.375},
        {"fourOktas", 0.5}, {"fiveOktas", 0.625}, {"sixOktas", 0.75}, {"sevenOktas", 0.875},
        {"eightOktas", 1.0}};
    const auto found = kCover.find(state);
    return found == kCover.end() ? 0.0 : found->second;
}

osgTerrainROAM::AtmosphereSettings airOf(const simulation::EnvironmentState& environment)
{
    osgTerrainROAM::AtmosphereSettings air;
    air.sunDirectionWorld =
        osgTerrainROAM::sunDirectionFromAngles(environment.sun.azimuthDeg, environment.sun.elevationDeg);
    if (environment.fogVisualRangeM) air.visibilityM = std::max(*environment.fogVisualRangeM, 1.0);
    air.cloudCover = cloudCover(environment.cloudState);
    return air;
}

} // namespace

ScenarioScene::ScenarioScene()
    : _root(new osg::Group),
      _atmosphere(new osgTerrainROAM::Atmosphere),
      _sunlit(new osgTerrainROAM::SunShadows(_atmosphere))
{
    _atmosphere->addUniformsTo(*_root->getOrCreateStateSet());
    _root->getStateSet()->setDataVariance(osg::Object::DYNAMIC);
}

foundation::Result<ScenarioScene> ScenarioScene::create(const simulation::Scenario& scenario,
                                                        const SceneTerrain& terrain,
                                                        const std::filesystem::path& folder)
{
    ScenarioScene scene;
    if (terrain.terrain) terrain.terrain->setAtmosphere(scene._atmosphere);
    scene._root->addChild(scenery::makeSky());
    scene._root->addChild(scene._sunlit);
    scene._sunlit->addChild(terrain.node);
    scene._roadThings = terrain.roadThings;
    scene._ground = terrain.ground();
    scenery::EntityShapes shapes;
    for (const simulation::ScenarioObject& object : scenario.entities)
    {
        auto model = EntityModel::create(object, folder, shapes);
        if (!model) return model.error();
        scene._sunlit->addChild(model->node());
        if (model->shadow()) scene._root->addChild(model->shadow());
        scene._entities.push_back(std::move(*model));
    }
    return scene;
}

std::vector<std::string> ScenarioScene::notes() const
{
    std::vector<std::string> notes;
    for (const EntityModel& entity : _entities)
        if (!entity.note().empty()) notes.push_back(entity.note());
    return notes;
}

void ScenarioScene::setQuality(const QualityRules& rules)
{
    osg::StateSet& state = *_root->getStateSet();
    for (const Quality quality : {Quality::low, Quality::medium})
        if (const char* const other = rulesOf(quality).define; other != rules.define)
            state.removeDefine(other);
    if (rules.define) state.setDefine(rules.define);
    _sunlit->setSettings(rules.shadows);
}

/// Switches the traffic lights whose state has changed. A signal that is not drawn is told once.
void ScenarioScene::showSignals(const std::map<std::string, std::string>& states)
{
    if (!_roadThings) return;
    for (const auto& [signal, state] : states)
    {
        std::string& shown = _signals[signal];
        if (shown == state) continue;
        if (!_roadThings->setState(signal, state))
            osg::notify(osg::NOTICE) << "signal " << signal << ": no traffic light shows '" << state << "'"
                                     << std::endl;
        shown = state;
    }
}

bool ScenarioScene::isDark(const simulation::EnvironmentState& environment)
{
    constexpr double kDuskDeg = 2.0; // of the sun's elevation
    return environment.sun.elevationDeg < kDuskDeg;
}

void ScenarioScene::show(const simulation::ScenarioPlayer& player,
                         const std::vector<simulation::EntityState>& entities)
{
    const auto& sun = player.environment().sun;
    const osg::Vec3d towards = osgTerrainROAM::sunDirectionFromAngles(sun.azimuthDeg, sun.elevationDeg);
    const EntityModel::Light light{{towards.x(), towards.y(), towards.z()},
                                   isDark(player.environment()),
                                   player.timeS(),
                                   _sunlit->isShown()};
    for (std::size_t i = 0; i < _entities.size(); ++i)
        _entities[i].show(entities[i], light, _ground);
    showSignals(player.signalStates());
    if (const auto set = _atmosphere->setSettings(airOf(player.environment())); !set)
        osg::notify(osg::WARN) << set.error().message() << std::endl;
}

} // namespace trainer
