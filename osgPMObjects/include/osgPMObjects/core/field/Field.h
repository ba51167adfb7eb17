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

/// The data that all instances of one model share. The caller owns the tables.
/// Frame: the model's; `sphere` and `box` are relative to `origin`, the point at 0 in the vertex buffer.
struct FieldModel
{
    const LevelTable* table = nullptr;
    const LevelLadder* ladder = nullptr;
    const FacingBins* facing = nullptr; ///< in the frame of the model's axes
    BoundingSphere sphere;
    OrientedBox box;
    glm::dvec3 origin{0.0};
    SelectionSettings selection;
    SwitchSettings switching;
};

/// One instance of a model. Frame: the field's. Units: the field's; `scale` turns the model's units into the
/// field's.
struct FieldObject
{
    glm::dvec3 position{0.0}; ///< of the model's point 0
    glm::dquat attitude{1.0, 0.0, 0.0, 0.0};
    double scale = 1.0;
    std::uint32_t model = 0;
    Priority priority;
};

/// Neighbouring objects that are culled together.
struct FieldCell
{
    BoundingSphere sphere;
    std::uint32_t first = 0, end = 0; ///< range of objects
    double goneM =
        0.0; ///< distance from which on none of them is drawn, unless it is attended; metres of AlphaRange
};

/// A set of many static instances of a few models, sorted into the cells of a grid over x and y for culling.
/// A field never changes; FieldView holds the state of one view of it. Invariant: isField().
/// Memory: some 200 B an object. Threads: any number may read it.
class Field
{
public:
    /// Mean number of objects in a cell. The test of a cell's sphere costs as much as that of an object's.
    static constexpr std::uint32_t kObjectsPerCell = 48;

    Field() = default;
    /// The objects' models must be in range and their scales above 0.
    Field(std::vector<FieldModel> models, std::vector<FieldObject> objects);

    std::span<const FieldModel> models() const { return _models; }
    std::span<const FieldObject> objects() const { return _objects; } ///< sorted by cell
    std::span<const BoundingSphere> spheres() const { return _spheres; }
    std::span<const FieldCell> cells() const { return _cells; }
    /// Returns the rungs of a model's ladder that SelectionSettings::leastFaces allows, in steps.
    std::span<const std::uint32_t> allowedRungs(std::uint32_t model) const { return _allowedRungs[model]; }
    /// Returns the index that an object had in the list given to the constructor.
    std::uint32_t numberOf(std::uint32_t object) const { return _numbers[object]; }

    /// Returns an object for LevelSelector, without its benefit curve, which depends on the cost of drawing.
    /// `metresPerUnit`: of the field's units.
    SelectableObject selectable(std::uint32_t object, double metresPerUnit) const;

private:
    void sortIntoCells();

    std::vector<FieldModel> _models;
    std::vector<std::span<const std::uint32_t>> _allowedRungs; ///< by model; spans of the callers' ladders
    std::vector<FieldObject> _objects;
    std::vector<BoundingSphere> _spheres;
    std::vector<std::uint32_t> _numbers;
    std::vector<FieldCell> _cells;
};

/// Tells whether every object lies within its cell, and in one cell only.
bool isField(const Field& field);

} // namespace osgPMObjects::core
