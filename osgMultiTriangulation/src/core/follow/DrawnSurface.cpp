// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <osgMultiTriangulation/core/follow/DrawnSurface.h>

namespace osgMultiTriangulation::core
{

DrawnFrame::DrawnFrame(const MtInfo& info, double vertexStepOfFrame)
    : step(info.frame.stepX, info.frame.stepY), vertexStep(vertexStepOfFrame)
{
    for (int axis = 0; axis < 2; ++axis)
    {
        low[axis] = info.trees[0].low[axis];
        high[axis] = std::max(info.trees[0].high[axis], low[axis] + 1);
    }
}

std::uint32_t SurfaceWriter::cellOf(const MultiTriangulation& tree, std::uint32_t triangle) const
{
    const Triangle& corners = tree.corners[triangle];
    std::uint32_t cell = 0;
    for (int axis = 1; axis >= 0; --axis)
    {
        double middle = 0.0;
        for (const std::uint32_t corner : corners)
            middle += (axis == 0 ? tree.points[corner].x : tree.points[corner].y) / 3.0;
        const double share = (middle - _frame.low[axis]) / (double(_frame.high[axis]) - _frame.low[axis]);
        cell = cell * kCells + static_cast<std::uint32_t>(std::clamp(share * kCells, 0.0, kCells - 1.0));
    }
    return cell;
}

std::uint32_t SurfaceWriter::vertexOf(const Extraction& extraction, std::uint32_t tree, std::uint32_t point,
                                      DrawnSurface& surface)
{
    std::uint32_t& vertex = _vertices[tree][point];
    if (vertex != kNone) return vertex;
    vertex = static_cast<std::uint32_t>(surface.vertices.size());
    const glm::dvec3 steps = _frame.place(extraction.part(tree).points[point]) / _frame.vertexStep;
    surface.vertices.push_back({static_cast<std::int32_t>(std::lround(steps.x)),
                                static_cast<std::int32_t>(std::lround(steps.y)),
                                static_cast<std::int32_t>(std::lround(steps.z))});
    _written.push_back({tree, point});
    return vertex;
}

void SurfaceWriter::write(const Extraction& extraction, DrawnSurface& surface)
{
    surface.vertices.clear();
    surface.triangles.resize(extraction.active().size());
    surface.cells.clear();
    surface.errors.resize(surface.triangles.size());
    _first.assign(kCells * kCells + 1, 0);
    _cells.clear();
    for (const InTree& at : extraction.active())
    {
        _cells.push_back(cellOf(extraction.part(at.tree), at.number));
        ++_first[_cells.back() + 1];
        if (_vertices.size() <= at.tree) _vertices.resize(at.tree + 1);
        const std::size_t points = extraction.part(at.tree).points.size();
        if (_vertices[at.tree].size() < points) _vertices[at.tree].resize(points, kNone);
    }
    for (std::size_t c = 1; c < _first.size(); ++c)
        _first[c] += _first[c - 1];
    std::vector<std::uint32_t> slots(_first.begin(), _first.end() - 1);
    std::size_t i = 0;
    for (const InTree& at : extraction.active())
        surface.triangles[slots[_cells[i++]]++] = {at.tree, at.number, 0};
    const auto inUnits = [this](const DrawnSurface::Vertex& v)
    { return glm::dvec3(v[0], v[1], v[2]) * _frame.vertexStep; };
    for (std::size_t c = 0; c + 1 < _first.size(); ++c)
    {
        if (_first[c] == _first[c + 1]) continue;
        DrawnSurface::Cell& cell = surface.cells.emplace_back();
        cell = {_first[c], _first[c + 1] - _first[c], glm::dvec3(1e30), glm::dvec3(-1e30)};
        for (std::uint32_t t = _first[c]; t < _first[c + 1]; ++t)
        {
            const InTree at{surface.triangles[t][0], surface.triangles[t][1]};
            const MultiTriangulation& tree = extraction.part(at.tree);
            surface.errors[t] = tree.errors[at.number];
            for (int corner = 0; corner < 3; ++corner)
            {
                const std::uint32_t vertex =
                    vertexOf(extraction, at.tree, tree.corners[at.number][corner], surface);
                surface.triangles[t][corner] = vertex;
                cell.low = glm::min(cell.low, inUnits(surface.vertices[vertex]));
                cell.high = glm::max(cell.high, inUnits(surface.vertices[vertex]));
            }
        }
    }
    for (const InTree& written : _written)
        _vertices[written.tree][written.number] = kNone;
    _written.clear();
}

} // namespace osgMultiTriangulation::core
