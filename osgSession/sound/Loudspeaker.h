// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "simulation/sound/SoundState.h"

namespace trainer
{

/// Plays what is heard through OpenAL's usual device, from a thread of its own: pictures that take long do
/// not interrupt it. Threads: all calls from one.
class Loudspeaker
{
public:
    /// It begins to play. Without a device, or in a build without OpenAL, it is silent, and fault() says why.
    Loudspeaker();
    ~Loudspeaker();
    Loudspeaker(const Loudspeaker&) = delete;
    Loudspeaker& operator=(const Loudspeaker&) = delete;

    /// What is to be heard from now on.
    void set(const simulation::SoundState& state);

    /// Time stands: nothing is heard until set() again.
    void pause();

    const std::string& fault() const { return _fault; }

private:
    struct Player;
    std::shared_ptr<Player> _player; ///< null: silent
    std::string _fault;
};

} // namespace trainer
