// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

namespace simulation
{

/// Random numbers that are the same on every machine for a seed, a name and a number of a run.
class RandomDraw
{
public:
    RandomDraw(std::uint64_t seed, std::string_view name, std::uint64_t run);

    double uniform(double lower, double upper);  ///< in [lower, upper)
    double normal(double mean, double variance); ///< by Box and Muller
    /// A number whose logarithm is normal; mean and variance are those of the number itself. `mean` above 0.
    double logNormal(double mean, double variance);
    /// A whole number, by inversion of the distribution. `mean` from 0 to 700.
    double poisson(double mean);
    /// An index, each as often as its weight says. The weights are not negative, and one is above 0.
    std::size_t index(const std::vector<double>& weights);

private:
    std::mt19937_64 _engine;
};

} // namespace simulation
