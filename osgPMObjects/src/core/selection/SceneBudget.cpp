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

/// Returns the step from the point before it.
SceneBudget::Step SceneBudget::stepTo(std::uint32_t object, std::uint32_t point) const
{
    const BenefitPoint* p = &_objects[object].curve->points[point];
    return {(p[0].gain - p[-1].gain) * _objects[object].weight, p[0].cost - p[-1].cost};
}

LevelCandidate SceneBudget::finerCandidate(std::uint32_t object) const
{
    const Step step = stepTo(object, _points[object] + 1);
    return {step.benefit / static_cast<double>(step.cost), object, _points[object]};
}

LevelCandidate SceneBudget::coarserCandidate(std::uint32_t object) const
{
    const Step step = stepTo(object, _points[object]);
    return {step.benefit / static_cast<double>(step.cost), object, _points[object]};
}

/// Collects the candidates of all objects and sums their costs.
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
        if (_points[object] < last(object)) _finer.push(finerCandidate(object));
        if (_points[object] > 0) _coarser.push(coarserCandidate(object));
    }
}

void SceneBudget::refine(std::uint32_t object)
{
    _result.cost += stepTo(object, ++_points[object]).cost;
    ++_result.refined;
    _coarser.push(coarserCandidate(object));
    if (_points[object] < last(object)) _finer.push(finerCandidate(object));
}

void SceneBudget::coarsen(std::uint32_t object)
{
    _result.cost -= stepTo(object, _points[object]--).cost;
    ++_result.coarsened;
    _finer.push(finerCandidate(object));
    if (_points[object] > 0) _coarser.push(coarserCandidate(object));
}

void SceneBudget::coarsenToFit()
{
    while (_result.cost > _budget)
    {
        const LevelCandidate* least = _coarser.top(_points);
        if (!least) break;
        coarsen(least->object);
    }
    _result.fits = _result.cost <= _budget;
}

/// Undoes steps that are worth less than the wanted step by more than the band, until the wanted step fits;
/// none if all of them together are not enough. In that case `_reach` becomes the budget that they would
/// free: later candidates are worth less, so they can free no more.
bool SceneBudget::makeRoom(const LevelCandidate& wanted, double band)
{
    const std::uint64_t needed = stepTo(wanted.object, wanted.point + 1).cost;
    std::uint64_t room = _budget - _result.cost;
    _asked.clear();
    for (const LevelCandidate* least = nullptr;
         room < needed && (least = _coarser.top(_points)) && least->rate * band < wanted.rate;)
    {
        _asked.push_back(*least);
        room += stepTo(least->object, _points[least->object]--).cost;
        _coarser.pop();
        const std::uint32_t object = _asked.back().object;
        if (_points[object] > 0) _coarser.push(coarserCandidate(object));
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
    for (const LevelCandidate& asked : _asked)
        if (_points[asked.object] + 1 == asked.point) _finer.push(finerCandidate(asked.object));
    return true;
}

void SceneBudget::refineByWorth(double band)
{
    // Candidates that cost too much are dropped together once they are many, not one by one.
    std::uint64_t dropped = std::numeric_limits<std::uint64_t>::max();
    while (const LevelCandidate* top = _finer.top(_points))
    {
        const LevelCandidate wanted = *top;
        _finer.pop();
        if (_result.cost + stepTo(wanted.object, wanted.point + 1).cost <= _budget || makeRoom(wanted, band))
        {
            refine(wanted.object);
            continue;
        }
        if (_result.refusedRate == 0.0) _result.refusedRate = wanted.rate;
        if (_reach > dropped / 2) continue;
        dropped = _reach;
        _finer.drop([&](const LevelCandidate& o)
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
