// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/SceneryNode.h"

#include <map>

#include "scenery/nodes/ObjectShading.h"
#include "scenery/nodes/ProgressiveModel.h"

namespace scenery
{

namespace
{

using osgPMObjects::FieldInstance;
using osgPMObjects::FieldKind;

FieldInstance instanceOfPlacement(const Placement& placement, double groundZM, double importance)
{
    FieldInstance instance;
    const glm::dvec3 position = placement.position - placement.axes[2] * (groundZM * placement.scale);
    instance.position.set(position.x, position.y, position.z);
    instance.attitude = attitudeOf(placement.axes);
    instance.scale = placement.scale;
    instance.priority.importance = importance;
    return instance;
}

} // namespace

foundation::Result<SceneryNode> makeSceneryNode(const SceneryDescription& description,
                                                std::vector<Placement> placements,
                                                const SceneryShapes& shapes, const std::string& place)
{
    std::vector<FieldKind> kinds;
    std::vector<FieldInstance> instances;
    instances.reserve(placements.size());
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> kindOf;
    for (const Placement& placement : placements)
    {
        const SceneryField& field = description.fields[placement.field];
        const auto [found, isNew] =
            kindOf.try_emplace({placement.field, placement.object}, static_cast<std::uint32_t>(kinds.size()));
        if (isNew)
        {
            const auto& shape = shapes.shapes[placement.object];
            const auto selection =
                selectionFor(field.selection, shape->levels(), place + ": field " + field.name);
            if (!selection) return selection.error();
            kinds.push_back({shape, *selection, field.switching});
        }
        instances.push_back(
            instanceOfPlacement(placement, shapes.groundZM[placement.object], field.importance));
        instances.back().kind = found->second;
    }
    placements = {}; // its memory serves the field
    SceneryNode made{new osg::Group, new osgPMObjects::ProgressiveField};
    setObjectShading(*made.root, Finish::matt);
    if (const auto set = made.field->setBudget(description.budget); !set) return set.error();
    if (const auto set = made.field->setContents(std::move(kinds), std::move(instances)); !set)
        return set.error();
    made.root->addChild(made.field);
    return made;
}

} // namespace scenery
