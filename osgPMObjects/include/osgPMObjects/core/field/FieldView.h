// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <viewlod/Frustum.h>

#include <osgPMObjects/core/field/Field.h>
#include <osgPMObjects/core/field/FieldPicture.h>
#include <osgPMObjects/core/selection/SceneSelector.h>

namespace osgPMObjects::core
{

/// How a camera looks at a field. Frame: the field's, scaled to metres.
struct FieldLook
{
    SelectionView view;
    glm::dvec3 eye{0.0}; ///< what places are given from: the camera's own, where its levels are another's
    viewlod::Frustum frustum; ///< its sides cull; near and far planes do not
    AttentionRule attention;
    double metresPerUnit = 1.0; ///< of the field
    std::uint64_t frame = 0;    ///< the same for cameras that share the eye; rises
    float stepS = 0.0f;         ///< since the last frame
    SceneBudgetSettings budget;
};

/// What one eye remembers of a field: the level of each object that it has in sight, and how far its switch has come.
/// An object that was not in sight in the frame before is where its rule wants it: nobody saw how it got there.
/// Threads: one at a time. The field has to outlive it. Memory: 28 B an object, and some 300 B an object in sight.
class FieldView
{
public:
    explicit FieldView(const Field& field);

    /// Chooses the levels of all objects in sight, goes on with their switches, and sorts them by what draws them.
    /// A second camera of the same frame finds the switches where the first has moved them.
    FieldPicture look(const FieldLook& look);

private:
    struct Memory
    {
        HeldLevel held;
        SwitchState state; ///< levels are rungs
        std::uint64_t frame = kNever;
    };
    static constexpr std::uint64_t kNever = ~std::uint64_t{0};

    void findVisible(const viewlod::Frustum& frustum, double metresPerUnit);
    void choose(const FieldLook& look, FieldPicture& picture);
    const BenefitCurve* curveOf(std::uint32_t model, const CostModel& cost);
    DrawnLevels advance(std::uint32_t object, const Selection& selection, const FieldLook& look);

    const Field& _field;
    std::vector<Memory> _memory; ///< by object
    std::vector<BenefitCurve> _curves;
    std::optional<CostModel> _curvesCost;
    SceneSelector _selector;
    // By object in sight; kept for their memory.
    std::vector<std::uint32_t> _visible;
    std::vector<SelectableObject> _selectable;
    std::vector<HeldLevel> _held;
    std::vector<Selection> _selections;
};

} // namespace osgPMObjects::core
