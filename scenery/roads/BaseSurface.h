// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <foundation/Heights.h>
#include <glm/glm.hpp>

namespace scenery
{

/// The ground without its small forms: heights smoothed by a Gaussian, as a surface with continuous
/// curvature. Roads whose file knows no ground are fitted to it (GroundProfiles.h).
/// Frame: the network's plan. Units: metres. Memory: 4 B for each square of kCellM, 4 million squares at most
/// (coarser then).
/// Source: uniform cubic B-splines (Farin, *Curves and Surfaces for CAGD*, 2002, chapter 8) over normalised
/// Gaussian means.
class BaseSurface
{
public:
    static constexpr double kSigmaM = 100.0, kCellM = 40.0;

    /// Covers the box from `low` to `high`; beyond the data heights are those of the nearest data.
    BaseSurface(const glm::dvec2& low, const glm::dvec2& high, const foundation::HeightInPlan& ground);

    double heightM(const glm::dvec2& plan) const;

private:
    glm::dvec2 _low{0.0};
    double _cellM = kCellM;
    int _columns = 0, _rows = 0;
    std::vector<float> _heightsM; ///< row-major, coefficients of the spline
};

} // namespace scenery
