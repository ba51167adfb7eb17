// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <vector>

#include <glm/mat4x4.hpp>

#include "scenery/models/Model.h"
#include "scenery/models/entities/EntityShape.h"

namespace scenery::models
{

/// How an entity moves, as far as its parts show it. Units: metres, m/s, radians.
struct EntityMotion
{
    double odometerM = 0.0; ///< distance covered
    double speedMps = 0.0;
    double steeringRad = 0.0;             ///< of the front wheels, to the left
    std::array<double, 4> wheelTravelM{}; ///< front left, front right, rear left, rear right; upwards
};

/// A lamp of a vehicle.
struct EntityLamp
{
    enum class Kind
    {
        head,
        tail,
        brake,
        indicatorLeft,
        indicatorRight,
        reversing,
        warning, ///< blue lights
        count,
    };
    Kind kind = Kind::head;
    glm::dvec3 middle{0.0}; ///< in the entity's frame
    bool looksAhead = true; ///< else backwards
    double widthM = 0.2, heightM = 0.1;
    double sweepM = 0.0; ///< how far the end on its left lies farther ahead than that on its right
};

/// Which lamps shine, by EntityLamp::Kind.
using LitLamps = std::array<bool, static_cast<std::size_t>(EntityLamp::Kind::count)>;

/// A generated entity: rigid parts, what places them, and where its lamps are.
/// Frame of the parts: their own; `pose` returns for each part the matrix to the entity's frame.
/// Invariant: pose() is pure, and returns as many matrices as there are parts.
struct EntityModel
{
    std::vector<Model> meshes;
    std::vector<std::size_t> parts; ///< the mesh of each part
    std::function<std::vector<glm::dmat4>(const EntityMotion&)> pose;
    std::vector<EntityLamp> lamps;
    glm::dvec3 eye{0.0}; ///< of its driver or rider
    double shadowMiddleXM = 0.0, shadowHalfLengthM = 0.5, shadowHalfWidthM = 0.3;

    std::size_t addMesh(Model mesh)
    {
        meshes.push_back(std::move(mesh));
        return meshes.size() - 1;
    }
};

/// Generates the model of an entity. Pure. Precondition: isPlausible() of UsualSize.h. Axles that are missing are added,
/// and wheels that are too large for the body are made smaller. Cost: 1 to 20 ms.
EntityModel makeEntityModel(EntityShape shape);

} // namespace scenery::models
