// SPDX-License-Identifier: Apache-2.0
// The engine is the Mersenne Twister of the C++ standard, whose bits are the same everywhere; the
// distributions of the standard library are not, so they stand here. Source: Box and Muller, "A note on the
// generation of random normal deviates", 1958; Devroye, "Non-uniform random variate generation", 1986, X.3.3
// (Poisson by inversion).
#include "simulation/parser/RandomDraw.h"

#include <cmath>
#include <numbers>
#include <numeric>

#include <foundation/Fnv1a.h>

namespace simulation
{
namespace
{

std::mt19937_64 engineFor(std::uint64_t seed, std::string_view name, std::uint64_t run)
{
    foundation::Fnv1a hash;
    hash.add(name);
    const auto low = [](std::uint64_t value) { return static_cast<std::uint32_t>(value); };
    const auto high = [](std::uint64_t value) { return static_cast<std::uint32_t>(value >> 32); };
    std::seed_seq sequence{low(seed), high(seed), low(hash.value()), high(hash.value()), low(run), high(run)};
    return std::mt19937_64(sequence);
}

} // namespace

RandomDraw::RandomDraw(std::uint64_t seed, std::string_view name, std::uint64_t run)
    : _engine(engineFor(seed, name, run))
{
}

double RandomDraw::uniform(double lower, double upper)
{
    const double share = static_cast<double>(_engine() >> 11) * 0x1p-53;
    return lower + share * (upper - lower);
}

double RandomDraw::normal(double mean, double variance)
{
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform(0.0, 1.0)));
    const double angle = uniform(0.0, 2.0 * std::numbers::pi);
    return mean + std::sqrt(variance) * radius * std::cos(angle);
}

double RandomDraw::logNormal(double mean, double variance)
{
    const double ofLogarithm = std::log1p(variance / (mean * mean));
    return std::exp(normal(std::log(mean) - 0.5 * ofLogarithm, ofLogarithm));
}

double RandomDraw::poisson(double mean)
{
    const double wanted = uniform(0.0, 1.0);
    double term = std::exp(-mean), sum = term, value = 0.0;
    while (wanted >= sum && value < 10.0 * mean + 100.0)
    {
        value += 1.0;
        term *= mean / value;
        sum += term;
    }
    return value;
}

std::size_t RandomDraw::index(const std::vector<double>& weights)
{
    double left = uniform(0.0, std::accumulate(weights.begin(), weights.end(), 0.0));
    for (std::size_t i = 0; i + 1 < weights.size(); ++i)
    {
        if (left < weights[i]) return i;
        left -= weights[i];
    }
    return weights.size() - 1;
}

} // namespace simulation
