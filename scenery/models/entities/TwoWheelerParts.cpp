// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/entities/TwoWheelerParts.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "scenery/models/entities/Loft.h"
#include "scenery/models/roads/RoadModelParts.h"

namespace scenery::models
{

namespace
{

constexpr glm::vec3 kRubber(0.08F, 0.08F, 0.085F);

} // namespace

Model makeSpokedWheel(double radiusM, double tyreM, int spokes)
{
    constexpr int kArcs = 28;
    ModelBuilder builder;
    const auto at = [](double radius, int i, int of)
    {
        const double turn = 2.0 * std::numbers::pi * (i % of) / of;
        return glm::dvec3(radius * std::cos(turn), 0.0, radius * std::sin(turn));
    };
    const auto ring = [&](double radius, double thick)
    {
        std::vector<LoftRing> rings;
        for (int i = 0; i <= kArcs; ++i)
            rings.push_back(
                {at(radius, i, kArcs), thick * glm::normalize(at(1.0, i, kArcs)), {0.0, thick, 0.0}});
        addLoft(builder, rings, 8);
    };
    builder.begin("tyre", kPlain, kRubber);
    ring(radiusM - tyreM, tyreM);
    builder.begin("rim", kPlain, kBareMetal);
    ring(radiusM - 1.9 * tyreM, 0.5 * tyreM);
    for (int i = 0; i < spokes; ++i)
        bar(builder, {}, at(radiusM - 2.0 * tyreM, i, spokes), spokes > 8 ? 0.003 : 0.018);
    bar(builder, {0.0, -0.05, 0.0}, {0.0, 0.05, 0.0}, spokes > 8 ? 0.02 : 0.06);
    return builder.finish();
}

void addRider(ModelBuilder& builder, const PersonSize& size, const PersonColours& colours,
              const glm::dvec3& hip, const glm::dvec3& grip)
{
    for (const double side : {1.0, -1.0})
    {
        const glm::dvec3 shoulder =
            hip + glm::dvec3(0.40 * size.shoulderAboveHip(), side * size.halfShoulders(),
                             0.88 * size.shoulderAboveHip());
        const glm::dvec3 hand(grip.x, side * grip.y, grip.z);
        const glm::dvec3 elbow = 0.5 * (shoulder + hand) + glm::dvec3(-0.02, side * 0.05, -0.07);
        addArm(builder, size, colours, shoulder, elbow, hand);
    }
}

Model makeLeaningTrunk(const PersonSize& size, const PersonColours& colours)
{
    ModelBuilder builder;
    addTrunk(builder, size, colours, true);
    return builder.finish();
}

RollingPose twoWheels(EntityModel& model, const TwoWheels& wheels, Model wheel)
{
    const std::size_t mesh = model.addMesh(std::move(wheel));
    model.parts.insert(model.parts.end(), {mesh, mesh});
    return {glm::dmat4(1.0),
            {{{wheels.frontX, 0.0, wheels.radius}, wheels.radius, true, -1},
             {{wheels.rearX, 0.0, wheels.radius}, wheels.radius, false, -1}}};
}

void addLampsOfTwoWheeler(EntityModel& model, const glm::dvec3& head, const glm::dvec3& tail)
{
    using Lamp = EntityLamp::Kind;
    model.lamps.push_back({Lamp::head, head, true, 0.12, 0.12});
    model.lamps.push_back({Lamp::tail, tail, false, 0.08, 0.05});
    model.lamps.push_back({Lamp::brake, tail + glm::dvec3(0.0, 0.0, 0.05), false, 0.08, 0.05});
}

} // namespace scenery::models
