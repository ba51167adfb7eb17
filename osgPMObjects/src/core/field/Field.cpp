// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/glm.hpp>

#include <osgPMObjects/core/field/Field.h>
#include <osgPMObjects/core/selection/DrawableRows.h>

namespace osgPMObjects::core
{

namespace
{

BoundingSphere placed(const FieldModel& model, const FieldObject& object)
{
    const glm::dvec3 centre = model.origin + model.sphere.centre;
    return {object.position + object.attitude * (object.scale * centre), object.scale * model.sphere.radius};
}

/// Puts values into an order where they lie, cycle by cycle: a copy of a million objects takes longer.
/// `order`: of each place, from where its value comes.
template<class Value>
void arrange(std::vector<Value>& values, const std::vector<std::uint32_t>& order)
{
    std::vector<bool> isDone(values.size());
    for (std::uint32_t first = 0; first < order.size(); ++first)
    {
        if (isDone[first]) continue;
        Value out = std::move(values[first]);
        std::uint32_t place = first;
        for (; order[place] != first; place = order[place])
        {
            values[place] = std::move(values[order[place]]);
            isDone[place] = true;
        }
        values[place] = std::move(out);
        isDone[place] = true;
    }
}

/// A grid of square cells over x and y, in row order.
class Grid
{
public:
    Grid(std::span<const BoundingSphere> spheres, std::uint32_t objectsPerCell)
    {
        glm::dvec2 low(spheres.front().centre), high = low;
        for (const BoundingSphere& sphere : spheres)
        {
            low = glm::min(low, glm::dvec2(sphere.centre));
            high = glm::max(high, glm::dvec2(sphere.centre));
        }
        const glm::dvec2 size = glm::max(high - low, glm::dvec2(1e-9));
        const double cells = std::max(1.0, static_cast<double>(spheres.size()) / objectsPerCell);
        // Objects in a row span no area: then the length of the row decides.
        _side = std::max(std::sqrt(size.x * size.y / cells), std::max(size.x, size.y) / cells);
        _low = low;
        _columns = static_cast<std::uint64_t>(size.x / _side) + 1;
    }

    std::uint64_t cellOf(const BoundingSphere& sphere) const
    {
        const glm::dvec2 at = (glm::dvec2(sphere.centre) - _low) / _side;
        return static_cast<std::uint64_t>(at.y) * _columns + static_cast<std::uint64_t>(at.x);
    }

private:
    glm::dvec2 _low{0.0};
    double _side = 1.0;
    std::uint64_t _columns = 1;
};

/// Returns a bounding sphere about the centre of the box; it is not the smallest one.
BoundingSphere around(std::span<const BoundingSphere> spheres)
{
    glm::dvec3 low(spheres.front().centre - spheres.front().radius), high = low;
    for (const BoundingSphere& sphere : spheres)
    {
        low = glm::min(low, sphere.centre - sphere.radius);
        high = glm::max(high, sphere.centre + sphere.radius);
    }
    BoundingSphere result{0.5 * (low + high), 0.0};
    for (const BoundingSphere& sphere : spheres)
        result.radius = std::max(result.radius, glm::distance(result.centre, sphere.centre) + sphere.radius);
    return result;
}

} // namespace

Field::Field(std::vector<FieldModel> models, std::vector<FieldObject> objects)
    : _models(std::move(models)), _objects(std::move(objects))
{
    for (const FieldModel& model : _models)
    {
        const std::span<const std::uint32_t> rungs(model.ladder->steps);
        const std::uint32_t coarsest = model.table->coarsestWith(model.selection.leastFaces);
        _allowedRungs.push_back(rungs.first(drawableRowOf(rungs, coarsest) + 1));
    }
    _spheres.reserve(_objects.size());
    for (const FieldObject& object : _objects)
        _spheres.push_back(placed(_models[object.model], object));
    _numbers.resize(_objects.size());
    std::iota(_numbers.begin(), _numbers.end(), 0u);
    if (!_objects.empty()) sortIntoCells();
}

void Field::sortIntoCells()
{
    const Grid grid(_spheres, kObjectsPerCell);
    std::vector<std::uint64_t> cellOf;
    cellOf.reserve(_spheres.size());
    for (const BoundingSphere& sphere : _spheres)
        cellOf.push_back(grid.cellOf(sphere));
    std::stable_sort(_numbers.begin(), _numbers.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return cellOf[a] < cellOf[b]; });
    arrange(_objects, _numbers);
    arrange(_spheres, _numbers);
    const auto count = static_cast<std::uint32_t>(_objects.size());
    for (std::uint32_t first = 0, end = 0; first < count; first = end)
    {
        while (end < count && cellOf[_numbers[end]] == cellOf[_numbers[first]])
            ++end;
        FieldCell cell{around(std::span(_spheres).subspan(first, end - first)), first, end, 0.0};
        for (std::uint32_t i = first; i < end; ++i)
            cell.goneM = std::max(cell.goneM, _models[_objects[i].model].selection.alpha.goneM *
                                                  _objects[i].priority.importance);
        _cells.push_back(cell);
    }
}

SelectableObject Field::selectable(std::uint32_t object, double metresPerUnit) const
{
    const FieldObject& placement = _objects[object];
    const FieldModel& model = _models[placement.model];
    SelectableObject result;
    result.sphere = {_spheres[object].centre * metresPerUnit, _spheres[object].radius * metresPerUnit};
    result.table = model.table;
    result.settings = &model.selection;
    result.metresPerUnit = placement.scale * metresPerUnit;
    result.priority = placement.priority;
    result.facing = model.facing;
    result.drawable = _allowedRungs[placement.model];
    const glm::dvec3 centre = model.origin + model.box.centre;
    result.box.centre =
        (placement.position + placement.attitude * (placement.scale * centre)) * metresPerUnit;
    result.box.axes = glm::mat3_cast(placement.attitude);
    result.box.halfSizes = model.box.halfSizes * result.metresPerUnit;
    return result;
}

bool isField(const Field& field)
{
    std::uint32_t next = 0;
    for (const FieldCell& cell : field.cells())
    {
        if (cell.first != next || cell.end <= cell.first) return false;
        next = cell.end;
        for (std::uint32_t i = cell.first; i < cell.end; ++i)
        {
            const BoundingSphere& sphere = field.spheres()[i];
            const double reach = glm::distance(sphere.centre, cell.sphere.centre) + sphere.radius;
            if (reach > cell.sphere.radius * (1.0 + 1e-12)) return false;
        }
    }
    return next == field.objects().size() && field.spheres().size() == next;
}

} // namespace osgPMObjects::core
