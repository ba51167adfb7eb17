// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/trees/Tree.h"

#include <algorithm>

#include "scenery/models/mesh/Tube.h"
#include "scenery/models/trees/Foliage.h"
#include "scenery/models/trees/Skeleton.h"

namespace scenery::models
{

namespace
{

void addLimbs(ModelBuilder& builder, const TreeForm& form, const Skeleton& tree)
{
    const auto add = [&](const Limb& limb, int sides, double around, bool isTrunk)
    {
        Tube tube{limb.line, limb.radiiM, sides, {around, form.barkRepeats.y}, isTrunk ? 5.0 : 0.0, {}};
        for (const glm::dvec3& place : limb.line) // limbs inside the crown are darker
            tube.light.push_back(
                place.z < tree.crown.baseM
                    ? 1.0F
                    : static_cast<float>(std::min(0.36 + 0.3 * tree.crown.depthOf(place), 0.66)));
        addTube(builder, tube);
    };
    for (const Limb& trunk : tree.trunks)
        add(trunk, form.stems > 1 ? 6 : 12, form.barkRepeats.x, form.stems == 1);
    for (const Limb& bough : tree.boughs)
        add(bough, form.flatCards ? 3 : 6, 1.0, false);
    for (const Limb& twig : tree.twigs)
        add(twig, 3, 1.0, false);
}

} // namespace

Model makeTree(TreeKind kind, std::uint64_t seed)
{
    const TreeForm& form = treeForm(kind);
    Dice dice(seed + 1000 * static_cast<std::uint64_t>(kind));
    const Skeleton tree = growSkeleton(form, dice);
    ModelBuilder builder;
    const auto barkLight = static_cast<float>(dice.between(0.85, 1.1));
    builder.begin("limbs", {form.bark, Coat::matt}, glm::vec3(barkLight));
    addLimbs(builder, form, tree);
    const auto random = [&](double low, double high) { return static_cast<float>(dice.between(low, high)); };
    const float brightness = random(0.88, 1.08);
    builder.begin("foliage", {form.leaves, Coat::foliage},
                  form.leafTint * glm::vec3(random(0.92, 1.08), 1.0F, random(0.88, 1.05)) * brightness);
    addFoliage(builder, form, tree, dice);
    return builder.finish();
}

} // namespace scenery::models
