// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/SmoothGround.h"

#include <Eigen/SparseCholesky>

namespace worldmaking
{

namespace
{

constexpr double kBending = 20.0;   ///< weight of second differences: bends of some 25 m are smoothed
constexpr double kStretching = 1.0; ///< weight of first differences where there is no ground
constexpr double kLittle = 1e-6;    ///< keeps the system regular where no ground is near

/// The normal equations of a sum of squares.
class SquareSum
{
public:
    explicit SquareSum(std::size_t nodes) : _right(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(nodes))) {}

    /// Adds weight · (height - wish)².
    void addWish(std::size_t node, double weight, double wishM)
    {
        add(node, node, weight);
        _right[static_cast<Eigen::Index>(node)] += weight * wishM;
    }

    /// Adds weight · (difference of two heights)².
    void addStretch(std::size_t i, std::size_t j, double weight)
    {
        add(i, i, weight), add(j, j, weight);
        add(i, j, -weight), add(j, i, -weight);
    }

    /// Adds weight · (second difference of the heights of a node and the two before it)².
    void addBend(std::size_t node, double weight)
    {
        constexpr double kSecond[] = {1.0, -2.0, 1.0};
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = 0; b < 3; ++b)
                add(node - a, node - b, weight * kSecond[a] * kSecond[b]);
    }

    /// Adds weight · (height - that of a place between two other nodes)².
    void addTie(const StreetTie& tie)
    {
        const std::size_t nodes[] = {tie.node, tie.before, tie.after};
        const double shares[] = {1.0, tie.share - 1.0, -tie.share};
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = 0; b < 3; ++b)
                add(nodes[a], nodes[b], tie.weight * shares[a] * shares[b]);
    }

    std::vector<double> least() const
    {
        Eigen::SparseMatrix<double> matrix(_right.size(), _right.size());
        matrix.setFromTriplets(_entries.begin(), _entries.end());
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
        const Eigen::VectorXd heights = solver.solve(_right);
        return {heights.begin(), heights.end()};
    }

private:
    void add(std::size_t i, std::size_t j, double value)
    {
        _entries.emplace_back(static_cast<int>(i), static_cast<int>(j), value);
    }

    std::vector<Eigen::Triplet<double>> _entries;
    Eigen::VectorXd _right;
};

} // namespace

std::vector<double> smoothGround(const HeightNodes& nodes, const foundation::HeightInPlan& ground,
                                 std::span<const StreetTie> ties)
{
    SquareSum sum(nodes.count);
    const auto wish = [&](std::size_t node, const glm::dvec2& plan, bool isFree)
    {
        const auto heightM = ground(plan);
        sum.addWish(node, isFree || !heightM ? kLittle : 1.0, heightM.value_or(0.0));
    };
    for (std::size_t i = 0; i < nodes.areas.size(); ++i)
    {
        wish(i, nodes.areas[i].middle, nodes.areas[i].isFree);
        for (const StreetArm& arm : nodes.areas[i].arms)
            sum.addStretch(i, nodes.rows[arm.chain].first + nodes.mouth(arm), kStretching);
    }
    for (const HeightRow& row : nodes.rows)
        for (std::size_t k = 0; k <= row.last(); ++k)
        {
            const bool isFree = row.isFree[k] != 0;
            wish(row.first + k, row.points[k].position, isFree);
            if (k > 0 && (isFree || row.isFree[k - 1] != 0))
                sum.addStretch(row.first + k - 1, row.first + k, kStretching);
            if (k > 1) sum.addBend(row.first + k, kBending);
        }
    for (const StreetTie& tie : ties)
        sum.addTie(tie);
    return sum.least();
}

} // namespace worldmaking
