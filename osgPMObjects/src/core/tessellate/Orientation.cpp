// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <osgPMObjects/core/tessellate/Orientation.h>

namespace osgPMObjects::core
{

namespace
{

/// An exact sum of doubles: components that do not overlap, smallest first.
class ExactSum
{
public:
    void addProduct(double a, double b)
    {
        const double product = a * b;
        add(std::fma(a, b, -product)); // the rounding error of the product, exactly
        add(product);
    }

    /// Returns the largest component, which has the sign of the sum.
    double leading() const
    {
        for (std::size_t i = _count; i-- > 0;)
            if (_parts[i] != 0.0) return _parts[i];
        return 0.0;
    }

private:
    void add(double term)
    {
        for (std::size_t i = 0; i < _count; ++i)
        { // Knuth's two-sum: the sum and its rounding error
            const double sum = term + _parts[i];
            const double partInSum = sum - term;
            _parts[i] = (term - (sum - partInSum)) + (_parts[i] - partInSum);
            term = sum;
        }
        _parts[_count++] = term;
    }

    std::array<double, 12> _parts{};
    std::size_t _count = 0;
};

double exactOrientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    ExactSum sum;
    sum.addProduct(a.x, b.y);
    sum.addProduct(-a.x, c.y);
    sum.addProduct(b.x, c.y);
    sum.addProduct(-b.x, a.y);
    sum.addProduct(c.x, a.y);
    sum.addProduct(-c.x, b.y);
    return sum.leading();
}

} // namespace

double orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    constexpr double kHalfUlp = std::numeric_limits<double>::epsilon() / 2.0;
    constexpr double kBound = (3.0 + 16.0 * kHalfUlp) * kHalfUlp;
    const double left = (a.x - c.x) * (b.y - c.y), right = (a.y - c.y) * (b.x - c.x);
    const double difference = left - right;
    if (std::abs(difference) > kBound * (std::abs(left) + std::abs(right))) return difference;
    return exactOrientation(a, b, c);
}

bool isInSector(const glm::dvec2& before, const glm::dvec2& corner, const glm::dvec2& behind,
                const glm::dvec2& target)
{
    if (orientation(before, corner, behind) > 0.0)
        return orientation(corner, behind, target) > 0.0 && orientation(corner, target, before) > 0.0;
    return orientation(corner, before, target) < 0.0 || orientation(corner, target, behind) < 0.0;
}

} // namespace osgPMObjects::core
