// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/entities/RollingParts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

#include "scenery/models/mesh/ModelBuilder.h"
#include "scenery/models/vehicles/Wheel.h"

namespace scenery::models
{

namespace
{

constexpr double kMostTravelM = 0.15;

Model makeWheel(double radiusM, double widthM)
{
    ModelBuilder builder;
    builder.begin("wheel", {Painting::wheel, Coat::matt});
    addWheel(builder, {{}, radiusM, widthM, 1.0});
    return builder.finish(38.0);
}

/// The first axle takes the travel of the front wheels, the others that of the rear wheels.
WheelPlace placeOf(const EntityShape& shape, std::size_t axle, double side, double widthM)
{
    const AxleShape& at = shape.axles[axle];
    const double outer = std::min(0.5 * at.trackM + 0.5 * widthM, 0.495 * shape.widthM);
    const bool isFront = axle == 0 && shape.axles.size() > 1;
    return {{at.xM, side * (outer - 0.5 * widthM), at.wheelRadiusM},
            at.wheelRadiusM,
            at.steers,
            (isFront ? 0 : 2) + (side > 0.0 ? 0 : 1)};
}

} // namespace

glm::dmat4 wheelMatrix(const WheelPlace& wheel, const EntityMotion& motion)
{
    const double travel = wheel.travel < 0
                              ? 0.0
                              : std::clamp(motion.wheelTravelM[static_cast<std::size_t>(wheel.travel)],
                                           -kMostTravelM, kMostTravelM);
    const bool isRight = wheel.hub.y < 0.0;
    const bool isTurned = wheel.travel >= 0 && motion.wheelTurnRad;
    const double rolled = isTurned ? (*motion.wheelTurnRad)[static_cast<std::size_t>(wheel.travel)]
                                   : std::fmod(motion.odometerM / wheel.radiusM, 2.0 * std::numbers::pi);
    const double turned = (wheel.steers ? motion.steeringRad : 0.0) + (isRight ? std::numbers::pi : 0.0);
    glm::dmat4 matrix = glm::translate(glm::dmat4(1.0), wheel.hub + glm::dvec3(0.0, 0.0, travel));
    matrix = glm::rotate(matrix, turned, glm::dvec3(0.0, 0.0, 1.0));
    return glm::rotate(matrix, isRight ? -rolled : rolled, glm::dvec3(0.0, 1.0, 0.0));
}

std::vector<glm::dmat4> RollingPose::operator()(const EntityMotion& motion) const
{
    std::vector<glm::dmat4> pose{body};
    for (const WheelPlace& wheel : wheels)
        pose.push_back(wheelMatrix(wheel, motion));
    return pose;
}

void addWheels(EntityModel& model, const EntityShape& shape, const glm::dmat4& body, double widthM,
               std::size_t dualFrom)
{
    RollingPose pose{body, {}};
    model.names = {"body"};
    std::map<std::pair<double, double>, std::size_t> known; ///< by radius and width
    for (std::size_t axle = 0; axle < shape.axles.size(); ++axle)
        for (const double side : {1.0, -1.0})
        {
            const double wide = axle >= dualFrom ? 2.0 * widthM : widthM;
            const double radius = shape.axles[axle].wheelRadiusM;
            const auto [entry, isNew] = known.try_emplace({radius, wide}, model.meshes.size());
            if (isNew) model.addMesh(makeWheel(radius, wide));
            model.parts.push_back(entry->second);
            model.names.push_back(std::string("wheel ") + std::to_string(axle) +
                                  (side > 0.0 ? " left" : " right"));
            pose.wheels.push_back(placeOf(shape, axle, side, wide));
        }
    model.pose = std::move(pose);
}

} // namespace scenery::models
