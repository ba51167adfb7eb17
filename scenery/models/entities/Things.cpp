// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>

#include "scenery/models/entities/EntityGenerators.h"
#include "scenery/models/entities/Loft.h"
#include "scenery/models/roads/RoadModelParts.h"

namespace scenery::models
{

namespace
{

Model ofRoad(RoadModel::Kind kind, const EntityShape& shape)
{
    RoadModel thing;
    thing.kind = kind;
    thing.lengthM = shape.lengthM;
    thing.widthM = shape.widthM;
    thing.heightM = shape.heightM;
    return makeRoadModel(thing);
}

/// A concrete barrier with the sloped foot of a New Jersey profile, along its longer side.
Model makeBarrier(const EntityShape& shape)
{
    const bool isAcross = shape.widthM > shape.lengthM;
    const double half = 0.5 * std::max(shape.lengthM, shape.widthM),
                 thick = 0.5 * std::min(shape.lengthM, shape.widthM);
    const double h = shape.heightM, slope = std::min(thick, 0.3 * h);
    const std::array<glm::dvec2, 8> profile{{{-thick, 0.0},
                                             {thick, 0.0},
                                             {thick, 0.09 * h},
                                             {thick - 0.6 * slope, 0.4 * h},
                                             {thick - 0.75 * slope, h},
                                             {-thick + 0.75 * slope, h},
                                             {-thick + 0.6 * slope, 0.4 * h},
                                             {-thick, 0.09 * h}}};
    ModelBuilder builder;
    builder.begin("barrier", kPlain, {0.62F, 0.61F, 0.59F});
    addPrism(builder, profile.size(),
             [&](std::size_t end, std::size_t point, std::size_t)
             {
                 const double along = end == 0 ? -half : half;
                 const glm::dvec2& at = profile[point];
                 return Corner{isAcross ? glm::dvec3(-at.x, along, at.y) : glm::dvec3(along, at.x, at.y),
                               plainUv()};
             });
    return builder.finish();
}

/// A crate: a box with battens along its edges.
Model makeCrate(const EntityShape& shape)
{
    const glm::dvec3 half(0.5 * shape.lengthM, 0.5 * shape.widthM, 0.0);
    const double batten = 0.06 * std::min({shape.lengthM, shape.widthM, shape.heightM});
    const glm::vec3 tint(shape.red, shape.green, shape.blue);
    ModelBuilder builder;
    builder.begin("box", kPlain, tint);
    box(builder, {-half.x + batten, -half.y + batten, batten},
        {half.x - batten, half.y - batten, shape.heightM - batten});
    builder.begin("battens", kPlain, 0.8F * tint);
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
        {
            const glm::dvec3 corner(x * (half.x - batten), y * (half.y - batten), 0.0);
            box(builder, corner - glm::dvec3(batten, batten, 0.0),
                corner + glm::dvec3(batten, batten, shape.heightM));
        }
    for (const double z : {0.0, shape.heightM - 2.0 * batten})
    {
        for (const double y : {-half.y, half.y - 2.0 * batten})
            box(builder, {-half.x, y, z}, {half.x, y + 2.0 * batten, z + 2.0 * batten});
        for (const double x : {-half.x, half.x - 2.0 * batten})
            box(builder, {x, -half.y, z}, {x + 2.0 * batten, half.y, z + 2.0 * batten});
    }
    return builder.finish();
}

} // namespace

EntityModel makeThing(const EntityShape& shape)
{
    EntityModel model;
    const auto mesh = [&]
    {
        switch (shape.kind)
        {
        case EntityKind::cone:
            return ofRoad(RoadModel::Kind::cone, shape);
        case EntityKind::pole:
            return ofRoad(RoadModel::Kind::pole, shape);
        case EntityKind::barrier:
            return makeBarrier(shape);
        default:
            return makeCrate(shape);
        }
    };
    model.parts = {model.addMesh(mesh())};
    const glm::dmat4 placed = glm::translate(glm::dmat4(1.0), {shape.middleXM, 0.0, 0.0});
    model.pose = [placed](const EntityMotion&) { return std::vector<glm::dmat4>{placed}; };
    model.eye = {shape.middleXM, 0.0, shape.heightM};
    return model;
}

} // namespace scenery::models
