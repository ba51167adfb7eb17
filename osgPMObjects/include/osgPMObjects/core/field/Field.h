// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/gtc/quaternion.hpp>

#include <osgPMObjects/core/field/LevelLadder.h>
#include <osgPMObjects/core/selection/LevelSelector.h>
#include <osgPMObjects/core/selection/SceneBudget.h>
#include <osgPMObjects/core/selection/Switch.h>

namespace osgPMObjects::core
{

/// What the instances of one kind share. The tables stay with the caller.
/// Frame: the model's; `sphere` and `box` about `origin`, the point that stands at 0 in the vertex buffer.
struct FieldModel
{
    const LevelTable* table = nullptr;
    const LevelLadder* ladder = nullptr;
    const FacingBins* facing = nullptr; ///< about the model's axes
    BoundingSphere sphere;
    OrientedBox box;
    glm::dvec3 origin{0.0};
    SelectionSettings selection;
    SwitchSettings switching;
};

/// One instance. Frame: the field's. Units: the field's; `scale` of them to one of the model's.
struct FieldObject
{
    glm::dvec3 position{0.0}; ///< of the model's 0
    glm::dquat attitude{1.0, 0.0, 0.0, 0.0};
    double scale = 1.0;
    std::uint32_t model = 0;
    Priority priority;
};

/// Objects near to each other, which are culled together.
struct FieldCell
{
    BoundingSphere sphere;
    std::uint32_t first = 0, end = 0; ///< of the objects
};

/// Many instances of a few models that stand still: in cells of a grid over x and y, so that those in sight are found quickly.
/// It never changes; what a view remembers of it is a FieldView. Invariant: isField().
/// Memory: some 200 B an object. Threads: may be read by any number.
class Field
{
public:
    /// How many objects a cell has in the mean: a test of its sphere costs as much as that of an object's.
    static constexpr std::uint32_t kObjectsPerCell = 48;

    Field() = default;
    /// Objects are of these models; scales are above 0.
    Field(std::vector<FieldModel> models, std::vector<FieldObject> objects);

    std::span<const FieldModel> models() const { return _models; }
    std::span<const FieldObject> objects() const { return _objects; } ///< by cell
    std::span<const BoundingSphere> spheres() const { return _spheres; }
    std::span<const FieldCell> cells() const { return _cells; }
    /// The rungs of a model's ladder that its settings allow (SelectionSettings::leastFaces), in steps.
    std::span<const std::uint32_t> choosable(std::uint32_t model) const { return _choosable[model]; }
    /// The number that an object had among those that were given.
    std::uint32_t numberOf(std::uint32_t object) const { return _numbers[object]; }

    /// An object as the rules want it; without its curve, which depends on the cost of drawing. `metresPerUnit`: of the field.
    SelectableObject selectable(std::uint32_t object, double metresPerUnit) const;

private:
    void sortIntoCells();

    std::vector<FieldModel> _models;
    std::vector<std::span<const std::uint32_t>> _choosable; ///< by model; of the callers' ladders
    std::vector<FieldObject> _objects;
    std::vector<BoundingSphere> _spheres;
    std::vector<std::uint32_t> _numbers;
    std::vector<FieldCell> _cells;
};

/// Whether every object is within its cell, and in one only.
bool isField(const Field& field);

} // namespace osgPMObjects::core
