// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/things/ThingObstacles.h"

#include <algorithm>

#include "scenery/models/trees/PlantObstacle.h"

namespace scenery::roads
{

namespace
{

using models::RoadModel;
using simulation::Obstacle;
using simulation::ObstacleKind;

constexpr double kPostRadiusM = 0.04, kMastRadiusM = 0.09, kMarkerRadiusM = 0.12, kHighPoleM = 4.0;
constexpr double kFootDepthM = 0.8;
constexpr double kLeastBoxM = 0.3; ///< lower boxes are driven over

Obstacle roundAt(ObstacleKind kind, const glm::dvec3& foot, double radiusM, double heightM)
{
    Obstacle body;
    body.kind = kind;
    body.isRound = true;
    body.middle = glm::dvec2(foot);
    body.halfM = glm::dvec2(radiusM);
    body.lowM = foot.z - kFootDepthM;
    body.highM = foot.z + heightM;
    return body;
}

Obstacle boxAt(const StandingThing& thing, const RoadModel& model)
{
    Obstacle box;
    box.middle = glm::dvec2(thing.position);
    const glm::dvec2 ahead(thing.axes[0]);
    box.along = ahead / std::max(1e-9, glm::length(ahead));
    box.halfM = 0.5 * thing.scale * glm::dvec2(model.lengthM, model.widthM);
    box.lowM = thing.position.z - kFootDepthM;
    box.highM = thing.position.z + thing.scale * model.heightM;
    return box;
}

double otherwise(double size, double usual)
{
    return size > 0.0 ? size : usual;
}

void addModel(const StandingThing& thing, const RoadModel& model, simulation::ObstacleList& obstacles)
{
    using enum RoadModel::Kind;
    const glm::dvec3 beside = thing.position - model.armM * thing.axes[1];
    switch (model.kind)
    {
    case sign:
    case board:
        if (model.postDepthM > 0.0)
            obstacles.add(roundAt(ObstacleKind::post, beside, kPostRadiusM, model.raisedM + model.heightM),
                          "sign");
        return;
    case trafficLight:
    case pedestrianLight:
        if (model.postDepthM > 0.0)
            obstacles.add(roundAt(ObstacleKind::mast, beside, kMastRadiusM, model.raisedM + 1.0),
                          "traffic light");
        return;
    case pole:
    {
        const double heightM = otherwise(model.heightM, 3.0);
        obstacles.add(roundAt(heightM < kHighPoleM ? ObstacleKind::post : ObstacleKind::mast, thing.position,
                              0.5 * otherwise(model.widthM, 2.0 * kPostRadiusM), heightM),
                      "pole");
        return;
    }
    case delineator:
        return obstacles.add(roundAt(ObstacleKind::marker, thing.position, kPostRadiusM, 1.05), "delineator");
    case cone:
        return obstacles.add(
            roundAt(ObstacleKind::marker, thing.position, kMarkerRadiusM, otherwise(model.heightM, 0.75)),
            "cone");
    case lampPost:
        return obstacles.add(
            roundAt(ObstacleKind::mast, thing.position, kMastRadiusM, otherwise(model.heightM, 8.0)),
            "lamp post");
    case bollard:
        return obstacles.add(
            roundAt(ObstacleKind::mast, thing.position, kMastRadiusM, otherwise(model.heightM, 0.9)),
            "bollard");
    case gantry:
        for (const double side : {0.5, -0.5})
            obstacles.add(roundAt(ObstacleKind::mast,
                                  thing.position + side * otherwise(model.widthM, 15.0) * thing.axes[1],
                                  2.0 * kMastRadiusM, 6.0),
                          "gantry");
        return;
    case runwaySign:
        for (const double side : {-0.35, 0.35}) // on joints that break
            obstacles.add(roundAt(ObstacleKind::marker, thing.position + side * model.widthM * thing.axes[1],
                                  kPostRadiusM, model.raisedM + model.heightM),
                          "runway sign");
        return;
    case box:
        if (model.heightM >= kLeastBoxM) obstacles.add(boxAt(thing, model), "object");
        return;
    case railPost:
        return;
    }
}

} // namespace

void addObstacles(const RoadThings& things, simulation::ObstacleList& obstacles)
{
    for (const StandingThing& thing : things.standing)
        addModel(thing, things.models[thing.model], obstacles);
    for (const StandingThing& plant : things.plants)
    {
        const models::Kind kind = things.grown[plant.model].kind;
        obstacles.add(models::plantObstacle(kind, plant.position, plant.scale), models::factsOf(kind).name);
    }
    obstacles.add(things.bodies);
}

} // namespace scenery::roads
