// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/mesh/EdgeTable.h>
#include <osgPMObjects/core/simplify/VertexClustering.h>

namespace osgPMObjects::core
{

namespace
{

/// The most edges whose angles are compared pair by pair.
constexpr std::size_t kMostEdgesInPairs = 64;

double angleBetween(const glm::dvec3& a, const glm::dvec3& b)
{
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Returns the largest angle between two of the directions; for many, twice the largest from their mean,
/// which is no less.
double largestAngle(const std::vector<glm::dvec3>& edges)
{
    double largest = 0.0;
    if (edges.size() <= kMostEdgesInPairs)
    {
        for (std::size_t i = 0; i < edges.size(); ++i)
            for (std::size_t j = i + 1; j < edges.size(); ++j)
                largest = std::max(largest, angleBetween(edges[i], edges[j]));
        return largest;
    }
    glm::dvec3 mean(0.0);
    for (const glm::dvec3& edge : edges)
        mean += edge;
    for (const glm::dvec3& edge : edges)
        largest = std::max(largest, 2.0 * angleBetween(edge, mean));
    return std::min(largest, std::numbers::pi);
}

} // namespace

std::vector<double> clusterGrades(const Mesh& mesh)
{
    std::vector<std::uint32_t> first(mesh.positions.size() + 1, 0), neighbours(6 * mesh.faces.size());
    const std::vector<Triangle> triangles = positionTriangles(mesh);
    for (const Triangle& t : triangles)
        for (const std::uint32_t p : t)
            first[p] += 2;
    for (std::size_t p = 1; p < first.size(); ++p)
        first[p] += first[p - 1];
    for (const Triangle& t : triangles)
        for (int c = 0; c < 3; ++c)
            for (const int other : {1, 2})
                neighbours[--first[t[c]]] = t[(c + other) % 3];
    std::vector<double> grades(mesh.positions.size(), 0.0);
    std::vector<glm::dvec3> edges;
    for (std::size_t p = 0; p < grades.size(); ++p)
    {
        std::sort(neighbours.begin() + first[p], neighbours.begin() + first[p + 1]);
        edges.clear();
        double longest = 0.0;
        for (std::uint32_t i = first[p]; i < first[p + 1]; ++i)
        {
            if (i > first[p] && neighbours[i] == neighbours[i - 1]) continue;
            edges.push_back(mesh.positions[neighbours[i]] - mesh.positions[p]);
            longest = std::max(longest, glm::length(edges.back()));
        }
        const double angle = largestAngle(edges);
        grades[p] = angle > 0.0 ? longest / angle : 0.0;
    }
    return grades;
}

} // namespace osgPMObjects::core
