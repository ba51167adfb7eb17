// SPDX-License-Identifier: Apache-2.0
#include "SceneInterior.h"

#include <algorithm>

#include <foundation/Angle.h>
#include <glm/gtc/matrix_transform.hpp>

#include "simulation/control/VehicleMotion.h"
#include "simulation/state/EnvironmentState.h"
#include "view/CockpitReadings.h"

namespace trainer
{

std::unique_ptr<SceneInterior> SceneInterior::create(const PlayScene& play, osgViewer::View& view,
                                                     const ChannelRig& rig)
{
    auto made = InteriorView::create(play.scene->shapeOf(play.watched), play.scene->eyeIn(play.watched));
    if (!made) return nullptr;
    std::unique_ptr<SceneInterior> interior(new SceneInterior(std::move(made)));
    interior->_flies = play.ownship().isAirborne();
    if (const auto origin = play.terrain.origin()) interior->_seaHeightM = origin->heightM;
    interior->_view->addTo(view, *rig.cameras().front(), *play.scene->air(), play.scene->root());
    return interior;
}

double SceneInterior::turnAltimeter(double hpa)
{
    return _altimeterHpa = std::clamp(_altimeterHpa + hpa, 940.0, 1060.0);
}

void SceneInterior::update(const PlayScene& play, const simulation::ScenarioPlayer& player,
                           const std::vector<simulation::EntityState>& entities,
                           const simulation::ExternalMotion* motion, const Picture& picture)
{
    if (!_view->isShown()) return;
    const simulation::EntityState& entity = entities[play.watched];
    const auto* const moved = dynamic_cast<const simulation::VehicleMotion*>(motion);
    const auto readings =
        cockpitReadings({entity, play.scene->lampsOf(play.watched),
                         moved ? &moved->vehicle().vehicle() : nullptr, _flies, _seaHeightM, _altimeterHpa});
    _view->update(scenery::poseOf(entity), picture.eye, picture.rig.setup().channels.front(), readings,
                  simulation::isDark(player.environment()), picture.pace);
}

scenery::Pose bent(const scenery::Pose& eye, double upDeg)
{
    const glm::dmat4 turn =
        glm::rotate(glm::dmat4(1.0), -foundation::radiansOf(upDeg), glm::dvec3(0.0, 1.0, 0.0));
    return {eye.positionWorld, eye.worldFromBody * glm::dmat3(turn)};
}

} // namespace trainer
