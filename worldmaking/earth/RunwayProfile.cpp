// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/earth/RunwayProfile.h"

#include <algorithm>
#include <cmath>

#include <Eigen/SparseCholesky>

namespace worldmaking
{

namespace
{

std::vector<double> smoothed(std::span<const double> groundM, double penalty)
{
    return smoothedHeights(groundM, std::vector<double>(groundM.size(), 1.0), penalty);
}

bool isWithin(const std::vector<double>& heightsM, double stationM, const RunwayLimits& limits)
{
    const std::size_t last = heightsM.size() - 1;
    for (std::size_t i = 0; i < last; ++i)
    {
        const bool isEnd = 4 * i < last || 4 * (i + 1) > 3 * last;
        const double slope = std::abs(heightsM[i + 1] - heightsM[i]) / stationM;
        if (slope > (isEnd ? limits.endSlope : limits.slope)) return false;
    }
    for (std::size_t i = 1; i < last; ++i)
        if (std::abs(heightsM[i - 1] - 2.0 * heightsM[i] + heightsM[i + 1]) * limits.leastRadiusM >
            stationM * stationM)
            return false;
    return true;
}

/// The straight line of least squares.
RunwayProfile straight(std::span<const double> groundM, double stationM, const RunwayLimits& limits)
{
    const auto n = static_cast<double>(groundM.size());
    const double middle = 0.5 * (n - 1.0);
    double mean = 0.0, product = 0.0, squares = 0.0;
    for (const double height : groundM)
        mean += height / n;
    for (std::size_t i = 0; i < groundM.size(); ++i)
    {
        const double from = static_cast<double>(i) - middle;
        product += from * (groundM[i] - mean);
        squares += from * from;
    }
    const double fitted = product / std::max(squares, 1.0) / stationM;
    const double most = std::min(limits.slope, limits.endSlope);
    const double allowed = std::clamp(fitted, -most, most);
    const bool isSteep = std::abs(fitted - allowed) * middle * stationM > kMostEarthM;
    RunwayProfile profile{{}, isSteep};
    for (std::size_t i = 0; i < groundM.size(); ++i)
        profile.heightsM.push_back(mean + (isSteep ? fitted : allowed) * stationM *
                                              (static_cast<double>(i) - middle));
    return profile;
}

} // namespace

std::vector<double> smoothedHeights(std::span<const double> groundM, std::span<const double> weights,
                                    double penalty)
{
    const auto n = static_cast<Eigen::Index>(groundM.size());
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index i = 0; i < n; ++i)
        entries.emplace_back(i, i, weights[static_cast<std::size_t>(i)]);
    constexpr double kDifference[] = {1.0, -2.0, 1.0};
    for (Eigen::Index i = 0; i + 2 < n; ++i)
        for (Eigen::Index a = 0; a < 3; ++a)
            for (Eigen::Index b = 0; b < 3; ++b)
                entries.emplace_back(i + a, i + b, penalty * kDifference[a] * kDifference[b]);
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::Map<const Eigen::VectorXd> heights(groundM.data(), n);
    const Eigen::Map<const Eigen::VectorXd> weight(weights.data(), n);
    const Eigen::VectorXd solution =
        Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(heights.cwiseProduct(weight));
    return {solution.begin(), solution.end()};
}

RunwayLimits runwayLimits(double lengthM)
{
    RunwayLimits limits;
    limits.code = lengthM < 800.0 ? 1 : lengthM < 1200.0 ? 2 : lengthM < 1800.0 ? 3 : 4;
    if (limits.code == 2) limits.stripHalfM = 40.0;
    if (limits.code >= 3)
    {
        limits.slope = limits.code == 3 ? 0.015 : 0.0125;
        limits.endSlope = limits.code == 3 ? 0.015 : 0.008;
        limits.leastRadiusM = limits.code == 3 ? 15000.0 : 30000.0;
        limits.stripHalfM = 75.0;
    }
    else
        limits.stripEndM = limits.code == 1 ? 30.0 : 60.0;
    return limits;
}

RunwayProfile runwayProfile(std::span<const double> groundM, double stationM, const RunwayLimits& limits)
{
    if (groundM.size() < 3) return straight(groundM, stationM, limits);
    constexpr double kLeast = 1.0, kMost = 1e9; // of the penalty
    double low = std::log(kLeast), high = std::log(kMost);
    if (!isWithin(smoothed(groundM, kMost), stationM, limits)) return straight(groundM, stationM, limits);
    for (int i = 0; i < 24; ++i)
    {
        const double middle = 0.5 * (low + high);
        (isWithin(smoothed(groundM, std::exp(middle)), stationM, limits) ? high : low) = middle;
    }
    return {smoothed(groundM, std::exp(high)), false};
}

} // namespace worldmaking
