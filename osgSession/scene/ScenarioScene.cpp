// SPDX-License-Identifier: Apache-2.0
#include "ScenarioScene.h"

#include <algorithm>
#include <cmath>

#include <osg/Notify>

#include "SceneWeather.h"
#include "scenery/lights/Allard.h"
#include "scenery/lights/LitTimes.h"
#include "scenery/nodes/Sky.h"
#include "simulation/state/EnvironmentState.h"

namespace trainer
{

ScenarioScene::ScenarioScene()
    : _root(new osg::Group),
      _atmosphere(new osgSky::Atmosphere),
      _sunlit(new osgSky::SunShadows(_atmosphere)),
      _surface(*_root->getOrCreateStateSet()),
      _beam(*_root->getOrCreateStateSet()),
      _lights(*_root->getOrCreateStateSet())
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
    scene._root->addChild(&scene._nightSky.node());
    scene._root->addChild(&scene._clouds.node());
    scene._clouds.shadeBy(*scene._root->getStateSet());
    scene._root->addChild(scene._sunlit);
    scene._root->addChild(&scene._drops.node());
    scene._sunlit->addChild(terrain.node);
    scene._roadThings = terrain.roadThings;
    scene._airfield = terrain.airfield;
    scene._settlements = terrain.settlements;
    if (terrain.airfield)
        scene._root->getStateSet()->addUniform(new osg::Uniform("featureLampsElsewhere", 1.0F));
    scene._moonlight = terrain.moonlight;
    scene._ground = terrain.ground();
    scene._worldClouds = terrain.clouds;
    scene._place = terrain.origin().value_or(scene._place);
    if (scene._ground)
        if (const auto ground = scene._ground(0.0, 0.0)) scene._groundM = ground->heightM;
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
        for (const std::string& note : entity.notes())
            if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
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
    _clouds.setDetail(rules.pixelsPerRay, rules.raySteps);
    constexpr double kWhole = 0.8; // of the reach: a vehicle's shadow is in the maps as a whole
    const auto maps = static_cast<std::size_t>(rules.shadows.movingMaps);
    _mapsReachM = maps > 0 ? kWhole * rules.shadows.reachesM[maps - 1] : 0.0;
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

void ScenarioScene::show(const simulation::ScenarioPlayer& player,
                         const std::vector<simulation::EntityState>& entities)
{
    const auto& sun = player.environment().sun;
    const osg::Vec3d towards = osgSky::sunDirectionFromAngles(sun.azimuthDeg, sun.elevationDeg);
    const EntityModel::Light light{{towards.x(), towards.y(), towards.z()},
                                   simulation::isDark(player.environment()),
                                   player.timeS(),
                                   _sunlit->isShown() ? _mapsReachM : 0.0,
                                   _eye};
    for (std::size_t i = 0; i < _entities.size(); ++i)
        _entities[i].show(entities[i], light, _ground);
    showBeam(entities, light.isDark);
    showSignals(player.signalStates());
    showWeather(player.environment(), player.timeS(), entities);
}

void ScenarioScene::showBeam(const std::vector<simulation::EntityState>& entities, bool isDark)
{
    if (!_lampBearer) return;
    const EntityModel& bearer = _entities[*_lampBearer];
    constexpr auto kHead = static_cast<std::size_t>(scenery::models::EntityLamp::Kind::head);
    _beam.show(scenery::poseOf(entities[*_lampBearer]), bearer.lamps(), isDark && bearer.litLamps()[kHead]);
}

/// Sets all light points: what the eye sees of them, and how bright each group shines.
void ScenarioScene::showLights(const simulation::EnvironmentState& environment,
                               const osgSky::AtmosphereSettings& air, double timeS)
{
    const double sunDeg = environment.sun.elevationDeg;
    const scenery::LightLevels levels = scenery::levelsOf(_lightSteps, sunDeg, air.visibilityM);
    constexpr double kDegreeS = 240.0; // of longitude, in the sun's time
    const double dayS = std::fmod(1e-3 * static_cast<double>(environment.dateTime.unixMilliseconds) +
                                      kDegreeS * _place.longitudeDeg,
                                  scenery::kDayS);
    _lights.show(scenery::leastIlluminanceLx(scenery::backgroundCdM2(sunDeg, air.cloudCover)), timeS, dayS,
                 levels);
    if (_airfield) _airfield->light(levels);
    if (_settlements) _settlements->light(levels);
}

void ScenarioScene::showWeather(const simulation::EnvironmentState& environment, double timeS,
                                const std::vector<simulation::EntityState>& entities)
{
    if (const auto& wind = environment.wind; wind && _airfield)
        _airfield->setWind(wind->speedMps *
                           glm::dvec2(std::cos(wind->directionRad), std::sin(wind->directionRad)));
    _air = airOf(environment);
    const simulation::MoonSight moon =
        simulation::moonSight(environment.dateTime, _place.latitudeDeg, _place.longitudeDeg);
    _nightSky.show(simulation::worldFromStars(environment.dateTime, _place.latitudeDeg, _place.longitudeDeg),
                   environment.sun.elevationDeg, moon);
    _air.moonlight = _moonlight.value_or(simulation::moonlightOf(moon));
    showClouds(environment, timeS);
    breathe();
    showLights(environment, _atmosphere->settings(), timeS);
    _surface.show(environment.surface, _groundM, environment.temperatureK);
    const glm::dvec3 eye = _ridden ? entities[*_ridden].velocity : glm::dvec3(0.0);
    _drops.show(fallingOf(environment), timeS, windOf(environment), {eye.x, eye.y, eye.z});
}

void ScenarioScene::showClouds(const simulation::EnvironmentState& environment, double timeS)
{
    const auto told = cloudsOf(environment);
    static const std::vector<simulation::CloudLayer> kNone;
    _clouds.setLayers(_givenClouds   ? *_givenClouds
                      : told         ? *told
                      : _worldClouds ? *_worldClouds
                                     : kNone,
                      _groundM);
    const osg::Vec3d wind = windOf(environment);
    const osgSky::AtmosphereLight light = osgSky::atmosphereLight(_air);
    _clouds.show(_air.sunDirectionWorld, light.sun * light.adaptation, // as shaders have it
                 {wind.x() * timeS, wind.y() * timeS});
}

/// Sets the air as it is below the clouds that hang above the eye.
void ScenarioScene::breathe()
{
    osgSky::AtmosphereSettings air = _air;
    air.cloudCover = greyUnder(_clouds.coverAbove(_eye ? _eye->z : _groundM));
    if (const auto set = _atmosphere->setSettings(air); !set)
        osg::notify(osg::WARN) << set.error().message() << std::endl;
    _clouds.setShadowStrength(1.0 - air.cloudCover);
}

void ScenarioScene::follow(const glm::dvec3& eye)
{
    _eye = eye;
    if (!_clouds.layers().empty()) breathe();
}

void ScenarioScene::showClouds(bool areShown)
{
    _clouds.node().setNodeMask(areShown && !_clouds.layers().empty() ? ~0U : 0U);
}

} // namespace trainer
