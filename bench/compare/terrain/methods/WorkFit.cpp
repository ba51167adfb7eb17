// SPDX-License-Identifier: Apache-2.0
#include "compare/terrain/methods/WorkFit.h"

#include <algorithm>
#include <array>

#include <glm/glm.hpp>

#include "compare/terrain/drivers/Measured.h"
#include "measurement/Percentile.h"

namespace terraintool
{

namespace
{

constexpr std::size_t kTerms = 3; // base, triangles, written

/// Solves the normal equations for the terms that `uses` names; nothing when they are singular.
std::optional<glm::dvec3> leastSquares(const std::vector<WorkSample>& samples,
                                       const std::array<bool, kTerms>& uses)
{
    glm::dmat3 left(0.0);
    glm::dvec3 right(0.0);
    for (const WorkSample& s : samples)
    {
        const glm::dvec3 row =
            glm::dvec3(uses[0], uses[1] ? 1e-3 * s.triangles : 0.0, uses[2] ? 1e-3 * s.written : 0.0) / s.us;
        left += glm::outerProduct(row, row);
        right += row; // every sample's share of itself is one
    }
    for (int i = 0; i < static_cast<int>(kTerms); ++i)
        if (!uses[static_cast<std::size_t>(i)]) left[i][i] = 1.0;
    if (glm::determinant(left) <= 1e-12 * left[0][0] * left[1][1] * left[2][2]) return std::nullopt;
    return glm::inverse(left) * right;
}

/// The mean work of one part of the flight, every `stride`th frame of it.
WorkSample workAt(const Rival& rival, const ComparedFlight& flight, double tolerancePx, std::size_t stride)
{
    constexpr std::size_t kMostFrames = 12;
    const auto mesh = rival.newMesh();
    std::vector<double> us;
    WorkSample sample;
    for (std::size_t frame = 0; frame < flight.views.size() && us.size() < kMostFrames; frame += stride)
    {
        osgTerrainROAM::core::RefineResult result;
        const double frameUs = microsecondsOf(
            [&] { result = mesh->refine(flight.views[frame], {.errorTolerancePx = tolerancePx}); });
        if (frame == 0) continue;
        us.push_back(frameUs);
        sample.triangles += result.leaves;
        sample.written += static_cast<double>(mesh->written().triangles);
    }
    if (us.empty()) return {};
    sample.triangles /= static_cast<double>(us.size());
    sample.written /= static_cast<double>(us.size());
    sample.us = measurement::percentile(us, 0.5);
    return sample;
}

} // namespace

std::optional<FitFigures> fitWork(const std::vector<WorkSample>& samples)
{
    if (samples.size() <= kTerms) return std::nullopt;
    std::array<bool, kTerms> uses{true, true, true};
    for (std::size_t attempt = 0; attempt < kTerms; ++attempt)
    {
        const auto found = leastSquares(samples, uses);
        if (!found) return std::nullopt;
        const int least = (*found)[0] <= std::min((*found)[1], (*found)[2]) ? 0
                          : (*found)[1] <= (*found)[2]                      ? 1
                                                                            : 2;
        if ((*found)[least] < 0.0)
        {
            uses[static_cast<std::size_t>(least)] = false;
            continue;
        }
        const WorkSample& own = samples.front();
        const double bySize = 1e-3 * (*found)[1] * own.triangles, byChange = 1e-3 * (*found)[2] * own.written;
        const double all = bySize + byChange;
        if (all <= 0.0) return FitFigures{(*found)[0], 0.0, 0.0, 0.0, 0.0};
        return FitFigures{(*found)[0], (*found)[1], (*found)[2], 100.0 * bySize / all,
                          100.0 * byChange / all};
    }
    return std::nullopt;
}

std::optional<FitFigures> measureWork(const Rival& rival, const ComparedFlight& flight, double tolerancePx)
{
    std::vector<WorkSample> samples;
    for (const double factor : {1.0, 4.0, 2.0, 0.5, 0.25}) // the first is what shares are told for
        for (const std::size_t stride : {1, 2, 4})
            if (const WorkSample sample = workAt(rival, flight, factor * tolerancePx, stride);
                sample.us > 0.0)
                samples.push_back(sample);
    return fitWork(samples);
}

} // namespace terraintool
