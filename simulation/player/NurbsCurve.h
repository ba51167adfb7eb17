// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace simulation
{

/// A rational B-spline curve. Points are homogeneous: (x, y, z)·weight and weight.
/// Invariant: as many knots as points plus `degree` plus one, never falling.
/// Source: Piegl and Tiller, *The NURBS Book*, 2nd edition, 1997, chapters 2 to 4 (de Boor's algorithm,
/// derivatives).
class NurbsCurve
{
public:
    NurbsCurve(std::vector<glm::dvec4> points, std::vector<double> knots, int degree);

    double begin() const { return _knots[static_cast<std::size_t>(_degree)]; }
    double end() const { return _knots[_points.size()]; }

    glm::dvec3 at(double parameter) const;
    glm::dvec3 tangentAt(double parameter) const;

    /// Returns the value of the basis function of one point, without weights.
    double basis(std::size_t point, double parameter) const;

private:
    static glm::dvec4 value(const std::vector<glm::dvec4>& points, const std::vector<double>& knots,
                            int degree, double parameter);

    std::vector<glm::dvec4> _points;
    std::vector<double> _knots;
    int _degree;
    std::vector<glm::dvec4> _hodograph; ///< points of the derivative, with the inner knots
    std::vector<double> _innerKnots;
};

} // namespace simulation
