// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/simplify/AreaCurve.h>

namespace osgPMObjects::core
{

namespace
{

constexpr int kDeviationSamples = 512;

double areaOf(const Mesh& mesh, const Face& face)
{
    const glm::dvec3& a = mesh.at(face, 0);
    return 0.5 * glm::length(glm::cross(mesh.at(face, 1) - a, mesh.at(face, 2) - a));
}

} // namespace

Mesh shapeOf(const Mesh& mesh)
{
    Mesh shape;
    shape.positions = mesh.positions;
    shape.wedgePositions.resize(mesh.positions.size());
    std::iota(shape.wedgePositions.begin(), shape.wedgePositions.end(), 0u);
    for (const Face& face : mesh.faces)
        shape.faces.push_back(
            {{mesh.positionOf(face, 0), mesh.positionOf(face, 1), mesh.positionOf(face, 2)}, 0, 0});
    shape.materials.emplace_back();
    shape.parts.emplace_back();
    return shape;
}

std::size_t AreaCurve::levelOf(std::size_t count) const
{
    const auto level = std::lower_bound(faces.begin(), faces.end(), count, std::greater<>());
    return std::min<std::size_t>(static_cast<std::size_t>(level - faces.begin()), faces.size() - 1);
}

double AreaCurve::meanDeviation(std::size_t fewest) const
{
    const double all = static_cast<double>(faces.front()), ratio = static_cast<double>(fewest) / all;
    double sum = 0.0;
    for (int i = 0; i < kDeviationSamples; ++i)
    {
        const double count = all * std::pow(ratio, (i + 0.5) / kDeviationSamples);
        const std::size_t level = levelOf(static_cast<std::size_t>(count));
        sum += std::abs(areas[level] / areas.front() - 1.0);
    }
    return sum / kDeviationSamples;
}

AreaCurve areaCurve(const Mesh& mesh, const RemovalSequence& sequence)
{
    AreaCurve curve;
    std::vector<double> ofFaces; // by face number
    for (const Face& face : mesh.faces)
        ofFaces.push_back(areaOf(mesh, face));
    for (const Face& face : sequence.addedFaces)
        ofFaces.push_back(areaOf(mesh, face));
    double area = std::accumulate(ofFaces.begin(),
                                  ofFaces.begin() + static_cast<std::ptrdiff_t>(mesh.faces.size()), 0.0);
    curve.faces.push_back(sequence.facesAfter(0));
    curve.areas.push_back(area);
    for (std::size_t step = 0; step < sequence.steps.size(); ++step)
    {
        for (const std::uint32_t face : sequence.removedBy(step))
            area -= ofFaces[face];
        const std::size_t first = mesh.faces.size() + sequence.steps[step].firstAdded;
        for (std::size_t i = 0; i < sequence.addedBy(step).size(); ++i)
            area += ofFaces[first + i];
        curve.faces.push_back(sequence.facesAfter(step + 1));
        curve.areas.push_back(area);
    }
    return curve;
}

} // namespace osgPMObjects::core
