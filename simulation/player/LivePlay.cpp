// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/LivePlay.h"

#include "simulation/player/StateBetween.h"

namespace simulation
{

LivePlay::LivePlay(std::unique_ptr<ScenarioPlayer> player, Observer observer)
    : _player(std::move(player)), _observer(std::move(observer)), _pace(_player->clock().stepS())
{
    begin();
}

void LivePlay::begin()
{
    _before = _player->entities();
    if (_observer) _observer(*_player);
    show();
}

void LivePlay::advance(double wallS)
{
    for (std::int64_t due = _pace.advance(wallS); due > 0 && !isOver(); --due)
    {
        _before = _player->entities();
        _player->step();
        if (_observer) _observer(*_player);
    }
    if (isOver()) _pace.setPaused(true);
    show();
}

void LivePlay::restart(std::unique_ptr<ScenarioPlayer> player)
{
    _player = std::move(player);
    _pace.reset();
    begin();
}

void LivePlay::show()
{
    const std::vector<EntityState>& now = _player->entities();
    _shown.resize(now.size());
    for (std::size_t i = 0; i < now.size(); ++i)
        _shown[i] = stateBetween(_before[i], now[i], _pace.share(), _player->clock().stepS());
}

} // namespace simulation
