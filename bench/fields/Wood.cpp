// SPDX-License-Identifier: Apache-2.0
#include "Wood.h"

#include <cmath>

#include "Random.h"
#include "scenery/models/Catalogue.h"
#include "scenery/nodes/SceneryShapes.h"

namespace fieldbench
{

namespace
{

using namespace osgPMObjects;

constexpr std::uint32_t kTrees = 5; // the first kinds of the catalogue are trees and the bush

std::uint32_t drawn(testsupport::Random& random, std::uint32_t first, std::uint32_t end)
{
    return first + static_cast<std::uint32_t>(random.unit() * (end - first)) % (end - first);
}

} // namespace

std::vector<osg::ref_ptr<const ProgressiveShape>> landscapeShapes()
{
    std::vector<scenery::SceneryObject> objects;
    for (const scenery::models::KindFacts& facts : scenery::models::kinds())
        objects.push_back({facts.kind, 1, {}});
    return scenery::makeSceneryShapes(objects)->shapes; // generators do not fail
}

std::vector<FieldInstance> scattered(std::uint32_t count, std::uint32_t kinds, double spacingM)
{
    // Each cell of a grid has one instance at a random position near its middle.
    const auto side = static_cast<std::uint32_t>(std::ceil(std::sqrt(count)));
    testsupport::Random random(20'26);
    std::vector<FieldInstance> instances;
    for (std::uint32_t i = 0; i < count; ++i)
    {
        const double x = i % side + 0.8 * random.unit() - 0.5 * side;
        const double y = std::floor(i / side) + 0.8 * random.unit() - 0.5 * side;
        FieldInstance& instance = instances.emplace_back();
        instance.position = osg::Vec3d(x, y, 0.0) * spacingM;
        instance.attitude = osg::Quat(6.2832 * random.unit(), osg::Vec3d(0.0, 0.0, 1.0));
        instance.scale = 0.85 + 0.3 * random.unit();
        instance.kind = random.unit() < 0.85 ? drawn(random, 0, kTrees) : drawn(random, kTrees, kinds);
    }
    return instances;
}

} // namespace fieldbench
