// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <viewlod/Frustum.h>

#include <osgPMObjects/core/field/Field.h>
#include <osgPMObjects/core/field/FieldDrawList.h>
#include <osgPMObjects/core/selection/SceneSelector.h>

namespace osgPMObjects::core
{

/// The camera of a field view, and what else changes from frame to frame. Frame: the field's, scaled to
/// metres.
struct FieldCamera
{
    SelectionView view;
    glm::dvec3 eye{
        0.0}; ///< origin of instance positions: this camera's eye, also if `view` is another camera's
    viewlod::Frustum frustum; ///< its side planes cull; near and far planes do not
    AttentionRule attention;
    double metresPerUnit = 1.0; ///< of the field's units
    std::uint64_t frame = 0;    ///< rises from frame to frame; equal for cameras that share the eye
    float stepS = 0.0f;         ///< time since the last frame
    SceneBudgetSettings budget;
};

/// The state of one eye's view of a field: by object, the held level and the progress of its switch. An
/// object that was not visible in the last frame begins at the level that its rule chooses, without a switch,
/// and so does one to which the eye has jumped: by more than half of its distance since the last frame.
/// Threads: one at a time. The field must outlive it. Memory: 56 B an object, and some 300 B a visible
/// object.
class FieldView
{
public:
    explicit FieldView(const Field& field);

    /// Chooses the levels of all visible objects, advances their switches, and sorts them into runs to draw.
    /// Another camera of the same frame gets the switches as the first camera has left them.
    FieldDrawList update(const FieldCamera& camera);

    /// Returns the runs to draw for a camera that shows what another one chose, as that of a shadow or of a
    /// mirror does, and changes nothing. Objects that no camera has chosen in this frame, behind the eye for
    /// one, have the level that they would get without a budget. `pixelM`: of a camera of parallel rays, for
    /// which levels as coarse as its pixels will do, and smaller objects are left out; absent for others.
    FieldDrawList lend(const FieldCamera& camera, std::optional<double> pixelM = std::nullopt);

private:
    struct Memory
    {
        HeldLevel held;
        SwitchState state; ///< its levels are rungs
        DrawnLevels drawn; ///< in the last frame
        std::uint64_t frame = kNever;
    };
    static constexpr std::uint64_t kNever = ~std::uint64_t{0};

    void findVisible(const FieldCamera& camera);
    void choose(const FieldCamera& camera, FieldDrawList& drawList);
    const BenefitCurve* curveOf(std::uint32_t model, const CostModel& cost);
    DrawnLevels advance(std::uint32_t object, const Selection& selection, const FieldCamera& camera);
    DrawnLevels lent(std::uint32_t object, const FieldCamera& camera, std::optional<double> pixelM);

    void followEye(const FieldCamera& camera);
    bool hasJumpedTo(std::uint32_t object, const FieldCamera& camera) const;

    const Field& _field;
    std::vector<Memory> _memory; ///< by object
    glm::dvec3 _eye{0.0};        ///< of the last update, metres
    std::uint64_t _eyeFrame = kNever;
    double _movedM = 0.0; ///< by the eye since the frame before
    std::vector<BenefitCurve> _curves;
    std::optional<CostModel> _curvesCost;
    SceneSelector _selector;
    // By visible object; members to keep their memory.
    std::vector<std::uint32_t> _visible;
    std::vector<SelectableObject> _selectable;
    std::vector<HeldLevel> _held;
    std::vector<Selection> _selections;
};

} // namespace osgPMObjects::core
