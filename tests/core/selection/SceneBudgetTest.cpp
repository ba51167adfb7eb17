// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include <osgPMObjects/core/selection/SceneBudget.h>

#include "SelectionScenes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::Random;

struct Scene
{
    std::vector<BenefitCurve> curves;
    std::vector<BudgetedObject> objects;
    std::vector<std::uint32_t> points;

    std::uint64_t cost() const
    {
        std::uint64_t sum = 0;
        for (std::size_t i = 0; i < objects.size(); ++i)
            sum += objects[i].curve->points[points[i]].cost;
        return sum;
    }
    double benefit() const
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < objects.size(); ++i)
            sum += objects[i].curve->points[points[i]].gain * objects[i].weight;
        return sum;
    }
    std::uint64_t coarsest() const
    {
        return std::accumulate(objects.begin(), objects.end(), std::uint64_t{0},
                               [](std::uint64_t sum, const BudgetedObject& o)
                               { return sum + o.curve->points[0].cost; });
    }
    std::uint64_t finest() const
    {
        return std::accumulate(objects.begin(), objects.end(), std::uint64_t{0},
                               [](std::uint64_t sum, const BudgetedObject& o)
                               { return sum + o.curve->points[std::min(o.finest, o.curve->last())].cost; });
    }
};

Scene scene(Random& random, std::size_t objects, std::uint32_t levels, std::uint32_t mostCost)
{
    Scene made;
    for (int model = 0; model < 5; ++model)
    {
        std::vector<BenefitPoint> points;
        for (std::uint32_t level = 0; level < levels; ++level)
            points.push_back({levels - level, 1 + random.below(mostCost), random.unit()});
        made.curves.push_back(BenefitCurve::hullOf(points));
    }
    for (std::size_t i = 0; i < objects; ++i)
        made.objects.push_back(
            {nullptr, 0.1 + 10.0 * random.unit() * random.unit(), random.below(levels + 2)});
    for (BudgetedObject& object : made.objects)
        object.curve = &made.curves[random.below(5)];
    made.points.assign(objects, 0);
    return made;
}

/// Returns the largest possible benefit within a budget, by dynamic programming over all costs.
double mostBenefit(const Scene& scene, std::uint64_t budget)
{
    constexpr double kNone = -1.0;
    std::vector<double> best(budget + 1, kNone);
    best[0] = 0.0;
    for (const BudgetedObject& object : scene.objects)
    {
        std::vector<double> next(budget + 1, kNone);
        const std::uint32_t last = std::min(object.finest, object.curve->last());
        for (std::uint32_t point = 0; point <= last; ++point)
        {
            const BenefitPoint& p = object.curve->points[point];
            for (std::uint64_t before = 0; before + p.cost <= budget; ++before)
                if (best[before] != kNone)
                    next[before + p.cost] =
                        std::max(next[before + p.cost], best[before] + p.gain * object.weight);
        }
        best = std::move(next);
    }
    return *std::max_element(best.begin(), best.end());
}

/// Returns the largest cost of a step, which bounds the error of the greedy choice.
std::uint64_t dearestStep(const Scene& scene)
{
    std::uint64_t most = 0;
    for (const BenefitCurve& curve : scene.curves)
        for (std::size_t i = 1; i < curve.points.size(); ++i)
            most = std::max(most, curve.points[i].cost - curve.points[i - 1].cost);
    return most;
}

TEST(SceneBudget, OfTwoObjectsByHand)
{
    const BenefitCurve curve{{{2, 10, 0.0}, {1, 20, 0.6}, {0, 40, 1.0}}};
    const std::vector<BudgetedObject> objects = {{&curve, 1.0, 9}, {&curve, 5.0, 9}};
    // Steps' worth a cost: 0.06, 0.02 of the first; 0.3, 0.1 of the second.
    const auto choose = [&](std::uint64_t budget)
    {
        std::vector<std::uint32_t> points(2, 0);
        const BudgetResult result = SceneBudget().choose(objects, points, budget);
        EXPECT_TRUE(result.fits);
        EXPECT_LE(result.cost, budget);
        return points;
    };
    using Points = std::vector<std::uint32_t>;
    EXPECT_EQ(choose(20), (Points{0, 0}));
    EXPECT_EQ(choose(29), (Points{0, 0}));
    EXPECT_EQ(choose(30), (Points{0, 1}));
    EXPECT_EQ(choose(40), (Points{1, 1})); // the second's next does not fit, the first's does
    EXPECT_EQ(choose(50), (Points{0, 2}));
    EXPECT_EQ(choose(60), (Points{1, 2}));
    EXPECT_EQ(choose(1000), (Points{2, 2}));
}

TEST(SceneBudget, SaysWhenNotEvenTheCoarsestLevelsFit)
{
    const BenefitCurve curve{{{1, 10, 0.0}, {0, 40, 1.0}}};
    const std::vector<BudgetedObject> objects(3, {&curve, 1.0, 9});
    std::vector<std::uint32_t> points(3, 1);
    const BudgetResult result = SceneBudget().choose(objects, points, 29);
    EXPECT_FALSE(result.fits);
    EXPECT_EQ(result.cost, 30u);
    EXPECT_EQ(points, std::vector<std::uint32_t>(3, 0));
    EXPECT_TRUE(SceneBudget().choose(objects, points, 30).fits);
    EXPECT_TRUE(SceneBudget().choose({}, {}, 0).fits);
}

TEST(SceneBudget, DetailBeyondTheToleranceIsNotBought)
{
    const BenefitCurve curve{{{2, 10, 0.0}, {1, 20, 0.6}, {0, 40, 1.0}}};
    const std::vector<BudgetedObject> objects = {{&curve, 1.0, 1}};
    std::vector<std::uint32_t> points = {2};
    EXPECT_EQ(SceneBudget().choose(objects, points, 1000).cost, 20u);
    EXPECT_EQ(points[0], 1u);
}

/// Returns the largest difference to the best benefit over the documented bound, for many small scenes that
/// start from nothing and from the last choices; above 1 the bound is broken. `choose(budget, scene, money,
/// band)`.
template<class Choose>
double worstShortfall(double band, const Choose& choose)
{
    Random random(15);
    double worst = 0.0;
    for (int round = 0; round < 150; ++round)
    {
        Scene small = scene(random, 2 + random.below(7), 2 + random.below(6), 40);
        SceneBudget budget;
        for (int frame = 0; frame < 6; ++frame)
        {
            const std::uint64_t money = small.coarsest() + random.below(150);
            const BudgetResult result = choose(budget, small, money, band);
            EXPECT_TRUE(result.fits);
            EXPECT_LE(small.cost(), money);
            EXPECT_EQ(result.cost, small.cost());
            EXPECT_NEAR(result.benefit, small.benefit(), 1e-9);
            const double most = mostBenefit(small, money);
            const double promised =
                result.refusedRate * (static_cast<double>(dearestStep(small)) +
                                      static_cast<double>(result.cost) * (1.0 - 1.0 / band));
            EXPECT_LE(small.benefit(), most + 1e-9);
            worst = std::max(worst, (most - small.benefit() - 1e-9) / std::max(promised, 1e-12));
            for (BudgetedObject& object : small.objects)
                object.weight *= testsupport::between(random, 0.7, 1.4);
        }
    }
    return worst;
}

BudgetResult byBudget(SceneBudget& budget, Scene& scene, std::uint64_t money, double band)
{
    return budget.choose(scene.objects, scene.points, money, band);
}

TEST(SceneBudget, IsWithinOneStepOfTheBestOnSmallScenes)
{
    EXPECT_LE(worstShortfall(1.0, byBudget), 1.0);
    EXPECT_LE(worstShortfall(SceneBudget::kDefaultBand, byBudget), 1.0);
}

TEST(SceneBudget, TheBestTellsAChoiceInTheWrongOrder)
{
    EXPECT_GT(worstShortfall(1.0,
                             [](SceneBudget& budget, Scene& scene, std::uint64_t money,
                                double band) { // as if every object were worth the same
                                 auto equal = scene.objects;
                                 for (BudgetedObject& object : equal)
                                     object.weight = 1.0;
                                 BudgetResult result = budget.choose(equal, scene.points, money, band);
                                 result.benefit = scene.benefit();
                                 return result;
                             }),
              1.0);
}

/// Returns the greedy choice from the coarsest points, without heaps.
std::vector<std::uint32_t> greedily(const Scene& scene, std::uint64_t money)
{
    std::vector<std::uint32_t> points(scene.objects.size(), 0);
    std::vector<bool> isRefused(points.size(), false);
    std::uint64_t cost = scene.coarsest();
    for (;;)
    {
        std::size_t best = points.size();
        double bestRate = -1.0;
        std::uint64_t bestCost = 0;
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const BudgetedObject& o = scene.objects[i];
            if (isRefused[i] || points[i] >= std::min(o.finest, o.curve->last())) continue;
            const BenefitPoint *p = &o.curve->points[points[i]], *q = p + 1;
            const double rate = (q->gain - p->gain) * o.weight / static_cast<double>(q->cost - p->cost);
            if (rate <= bestRate) continue;
            best = i;
            bestRate = rate;
            bestCost = q->cost - p->cost;
        }
        if (best == points.size()) return points;
        if (cost + bestCost > money)
            isRefused[best] = true;
        else
        {
            ++points[best];
            cost += bestCost;
        }
    }
}

TEST(SceneBudget, WithoutABandIsTheGreedyChoiceWhateverWasChosenBefore)
{
    Random random(16);
    for (int round = 0; round < 60; ++round)
    {
        Scene some = scene(random, 60, 12, 1000);
        SceneBudget budget;
        for (int frame = 0; frame < 8; ++frame)
        {
            const std::uint64_t money = some.coarsest() + random.below(40'000);
            budget.choose(some.objects, some.points, money, 1.0);
            EXPECT_EQ(some.points, greedily(some, money));
            for (BudgetedObject& object : some.objects)
                object.weight *= testsupport::between(random, 0.5, 2.0);
        }
    }
}

TEST(SceneBudget, NeverExceedsTheBudgetAndIsAtRestWhenNothingMoves)
{
    Random random(17);
    Scene large = scene(random, 10'000, 24, 5000);
    SceneBudget budget;
    for (const double share : {1.5, 0.6, 0.2, 0.05, 0.4, 0.0})
    {
        const auto money =
            large.coarsest() + static_cast<std::uint64_t>(share * (large.finest() - large.coarsest()));
        const BudgetResult first = budget.choose(large.objects, large.points, money);
        EXPECT_TRUE(first.fits);
        EXPECT_LE(large.cost(), money);
        EXPECT_EQ(first.refused == 0, share > 1.0);
        const auto before = large.points;
        const BudgetResult second = budget.choose(large.objects, large.points, money);
        EXPECT_EQ(large.points, before) << share;
        EXPECT_EQ(second.refined, 0u) << share;
        EXPECT_EQ(second.coarsened, 0u) << share;
    }
}

/// Returns the most changes of an object while weights vary as distances do by ±5 %, each in its own rhythm.
int mostChanges(double band)
{
    Random random(18);
    Scene some = scene(random, 300, 12, 1000);
    const auto weights = some.objects;
    const std::uint64_t money = some.coarsest() + (some.finest() - some.coarsest()) / 3;
    SceneBudget budget;
    budget.choose(some.objects, some.points, money, band);
    std::vector<int> changes(some.objects.size(), 0);
    for (int frame = 0; frame < 400; ++frame)
    {
        for (std::size_t i = 0; i < some.objects.size(); ++i)
        {
            const double share = 0.05 * std::sin(0.2 * frame + static_cast<double>(i));
            some.objects[i].weight = weights[i].weight / ((1.0 + share) * (1.0 + share));
        }
        const auto before = some.points;
        budget.choose(some.objects, some.points, money, band);
        for (std::size_t i = 0; i < some.points.size(); ++i)
            changes[i] += some.points[i] != before[i];
    }
    return *std::max_element(changes.begin(), changes.end());
}

TEST(SceneBudget, ObjectsThatTrembleByFivePerCentChangeAtMostOnce)
{
    EXPECT_LE(mostChanges(SceneBudget::kDefaultBand), 1);
    EXPECT_GT(mostChanges(1.0), 5); // the mutation: without the band
}

} // namespace
