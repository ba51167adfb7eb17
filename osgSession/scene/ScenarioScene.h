// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osg/Group>
#include <osgSky/Atmosphere>
#include <osgSky/SunShadows>

#include "EntityModel.h"
#include "SceneTerrain.h"
#include "scenery/lights/LightSteps.h"
#include "scenery/nodes/Clouds.h"
#include "scenery/nodes/FallingDrops.h"
#include "scenery/nodes/HeadLampBeam.h"
#include "scenery/nodes/LightPoints.h"
#include "scenery/nodes/NightSky.h"
#include "scenery/nodes/SurfaceLook.h"
#include "simulation/player/ScenarioPlayer.h"
#include "view/Quality.h"

namespace trainer
{

/// The scene graph of a scenario: terrain, sky, atmosphere and one model for each entity.
/// Frame: world, the scene's east-north-up. Threads: show() between frames.
class ScenarioScene
{
public:
    /// `folder`: the scenario's. Errors: as EntityModel.
    static foundation::Result<ScenarioScene> create(const simulation::Scenario& scenario,
                                                    const SceneTerrain& terrain,
                                                    const std::filesystem::path& folder);

    osg::Group& root() { return *_root; }

    /// What the sun shines on: terrain, entities and scenery. Part of root().
    osgSky::SunShadows& sunlit() { return *_sunlit; }

    /// Returns one line for each model that differs from the one asked for.
    std::vector<std::string> notes() const;

    /// Sets entities, traffic lights, sun, atmosphere and weather to the state of the player.
    void show(const simulation::ScenarioPlayer& player) { show(player, player.entities()); }

    /// The same with entities between two steps.
    void show(const simulation::ScenarioPlayer& player, const std::vector<simulation::EntityState>& entities);

    /// The eye moves with this entity, or stands: drops are streaks by their speed relative to it.
    void ride(const std::optional<std::size_t>& entity) { _ridden = entity; }

    /// The eye of the last picture: far from it entities cast patches on the ground, not into shadow maps.
    /// What hangs above it is what makes its sky grey.
    void follow(const glm::dvec3& eye);

    /// The head lamps of this entity light what is before it, in the dark.
    void bearLamps(std::size_t entity) { _lampBearer = entity; }

    /// Shadows of the sun by maps, or patches below entities alone.
    void setShadows(bool areShown) { _sunlit->setShown(areShown); }

    /// Shadows and shaders of this quality, from the next picture on.
    void setQuality(const QualityRules& rules);

    /// Steps of lamps that an instructor sets, from the next show() on.
    void setLightSteps(const scenery::LightSteps& steps) { _lightSteps = steps; }

    /// Returns the eye in an entity. Frame: the entity's.
    const glm::dvec3& eyeIn(std::size_t entity) const { return _entities[entity].eye(); }

    /// Returns as what an entity is generated (EntityModel::shape()).
    const scenery::models::EntityShape& shapeOf(std::size_t entity) const
    {
        return _entities[entity].shape();
    }

    /// Returns which of an entity's lamps are lit.
    const scenery::models::LitLamps& lampsOf(std::size_t entity) const
    {
        return _entities[entity].litLamps();
    }

    /// The uniforms of light and air, for what is drawn beside the scene.
    osg::StateSet* air() const { return _atmosphere->stateSet(); }

    /// Clouds in place of those that the scenario tells.
    void setClouds(const std::vector<simulation::CloudLayer>& layers) { _givenClouds = layers; }

    /// Shows or hides them.
    void showClouds(bool areShown);

    /// Hides an entity: the one whose camera is used; or shows it again.
    void hide(std::size_t entity, bool isHidden = true) { _entities[entity].hide(isHidden); }

    /// Hides all entities until they are shown anew.
    void hideEntities()
    {
        for (EntityModel& entity : _entities)
            entity.node()->setNodeMask(0U);
    }

private:
    ScenarioScene();
    void showBeam(const std::vector<simulation::EntityState>& entities, bool isDark);
    void showSignals(const std::map<std::string, std::string>& states);
    void showClouds(const simulation::EnvironmentState& environment, double timeS);
    void breathe();
    void showWeather(const simulation::EnvironmentState& environment, double timeS,
                     const std::vector<simulation::EntityState>& entities);
    void showLights(const simulation::EnvironmentState& environment, const osgSky::AtmosphereSettings& air,
                    double timeS);

    osg::ref_ptr<osg::Group> _root;
    osg::ref_ptr<osgSky::Atmosphere> _atmosphere;
    osg::ref_ptr<osgSky::SunShadows> _sunlit;
    scenery::SurfaceLook _surface;
    scenery::FallingDrops _drops;
    scenery::NightSky _nightSky;
    scenery::Clouds _clouds;
    simulation::Geodetic _place{45.0, 0.0, 0.0}; ///< whose stars are seen; tells the hour there
    std::optional<std::vector<simulation::CloudLayer>> _givenClouds, _worldClouds;
    osgSky::AtmosphereSettings _air; ///< without clouds
    double _groundM = 0.0;           ///< at the origin
    std::optional<std::size_t> _ridden, _lampBearer;
    std::optional<glm::dvec3> _eye;
    double _mapsReachM = 0.0;         ///< of the shadow maps that show what moves
    std::optional<double> _moonlight; ///< of the world; absent: as the moon stands
    scenery::HeadLampBeam _beam;
    scenery::LightUniforms _lights;
    scenery::LightSteps _lightSteps{};
    std::shared_ptr<scenery::RoadThingsNode> _roadThings;    ///< null without roads
    std::shared_ptr<scenery::AirfieldNode> _airfield;        ///< null without any
    std::shared_ptr<scenery::SettlementLights> _settlements; ///< the same
    std::map<std::string, std::string> _signals;             ///< states that are shown
    simulation::GroundProvider _ground;                      ///< onto which shadows fall
    std::vector<EntityModel> _entities;                      ///< in the order of Scenario::entities
};

} // namespace trainer
