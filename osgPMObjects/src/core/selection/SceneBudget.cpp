// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>
#include <limits>

#include <osgPMObjects/core/selection/SceneBudget.h>

namespace osgPMObjects::core
{

std::uint32_t SceneBudget::last(std::uint32_t object) const
{
    const BudgetedObject& budgeted = _objects[object];
    return std::min(budgeted.finest, budgeted.curve->last());
}

/// From the point before it.
SceneBudget::Step SceneBudget::stepTo(std::uint32_t object, std::uint32_t point) const
{
    const BenefitPoint* p = &_objects[object].curve->points[point];
    return {(p[0].gain - p[-1].gain) * _objects[object].weight, p[0].cost - p[-1].cost};
}

Offer SceneBudget::finerOffer(std::uint32_t object) const
{
    const Step step = stepTo(object, _points[object] + 1);
    return {step.benefit / static_cast<double>(step.cost), object, _points[object]};
}

Offer SceneBudget::coarserOffer(std::uint32_t object) const
{
    const Step step = stepTo(object, _points[object]);
    return {step.benefit / static_cast<double>(step.cost), object, _points[object]};
}

/// Gathers the offers of all objects, and adds up what they cost.
void SceneBudget::begin()
{
    _result = {};
    _finer.clear();
    _coarser.clear();
    _reach = std::numeric_limits<std::uint64_t>::max();
    for (std::uint32_t object = 0; object < _objects.size(); ++object)
    {
        assert(_objects[object].weight >= 0.0);
        _points[object] = std::min(_points[object], last(object));
        _result.cost += _objects[object].curve->points[_points[object]].cost;
        if (_points[object] < last(object)) _finer.push(finerOffer(object));
        if (_points[object] > 0) _coarser.push(coarserOffer(object));
    }
}

void SceneBudget::refine(std::uint32_t object)
{
    _result.cost += stepTo(object, ++_points[object]).cost;
    ++_result.refined;
    _coarser.push(coarserOffer(object));
    if (_points[object] < last(object)) _finer.push(finerOffer(object));
}

void SceneBudget::coarsen(std::uint32_t object)
{
    _result.cost -= stepTo(object, _points[object]--).cost;
    ++_result.coarsened;
    _finer.push(finerOffer(object));
    if (_points[object] > 0) _coarser.push(coarserOffer(object));
}

void SceneBudget::coarsenToFit()
{
    while (_result.cost > _budget)
    {
        const Offer* least = _coarser.top(_points);
        if (!least) break;
        coarsen(least->object);
    }
    _result.fits = _result.cost <= _budget;
}

/// Takes steps back that are worth less than the wanted one by more than the band, until that fits; none, if all of
/// them are not enough. Then `_reach` is what they and the rest of the budget come to: later offers are worth less still, so
/// none of them finds more.
bool SceneBudget::makeRoom(const Offer& wanted, double band)
{
    const std::uint64_t needed = stepTo(wanted.object, wanted.point + 1).cost;
    std::uint64_t room = _budget - _result.cost;
    _asked.clear();
    for (const Offer* least = nullptr;
         room < needed && (least = _coarser.top(_points)) && least->rate * band < wanted.rate;)
    {
        _asked.push_back(*least);
        room += stepTo(least->object, _points[least->object]--).cost;
        _coarser.pop();
        const std::uint32_t object = _asked.back().object;
        if (_points[object] > 0) _coarser.push(coarserOffer(object));
    }
    if (room < needed)
    {
        for (; !_asked.empty(); _asked.pop_back())
        {
            ++_points[_asked.back().object];
            _coarser.push(_asked.back());
        }
        _reach = std::min(_reach, room);
        return false;
    }
    _result.cost = _budget - room;
    _result.coarsened += static_cast<std::uint32_t>(_asked.size());
    for (const Offer& asked : _asked)
        if (_points[asked.object] + 1 == asked.point) _finer.push(finerOffer(asked.object));
    return true;
}

void SceneBudget::refineByWorth(double band)
{
    // Offers that cost more than can be had are dropped in one go when they have become many, not one by one.
    std::uint64_t dropped = std::numeric_limits<std::uint64_t>::max();
    while (const Offer* top = _finer.top(_points))
    {
        const Offer wanted = *top;
        _finer.pop();
        if (_result.cost + stepTo(wanted.object, wanted.point + 1).cost <= _budget || makeRoom(wanted, band))
        {
            refine(wanted.object);
            continue;
        }
        if (_result.refusedRate == 0.0) _result.refusedRate = wanted.rate;
        if (_reach > dropped / 2) continue;
        dropped = _reach;
        _finer.drop([&](const Offer& o)
                    { return o.point != _points[o.object] || stepTo(o.object, o.point + 1).cost > dropped; });
    }
}

void SceneBudget::addUp()
{
    for (std::uint32_t object = 0; object < _objects.size(); ++object)
    {
        const auto& points = _objects[object].curve->points;
        _result.benefit += points[_points[object]].gain * _objects[object].weight;
        if (_points[object] < last(object)) ++_result.refused;
    }
}

BudgetResult SceneBudget::choose(std::span<const BudgetedObject> objects, std::span<std::uint32_t> points,
                                 std::uint64_t budget, double band)
{
    assert(objects.size() == points.size() && band >= 1.0);
    _objects = objects;
    _points = points;
    _budget = budget;
    begin();
    coarsenToFit();
    if (_result.fits) refineByWorth(band);
    addUp();
    return _result;
}

} // namespace osgPMObjects::core
