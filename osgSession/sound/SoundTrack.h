// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "request/PlayRequest.h"
#include "simulation/sound/Synthesiser.h"
#include "simulation/sound/WaveFile.h"
#include "sound/SceneSound.h"

namespace trainer
{

/// Writes what is heard in a play, picture by picture: their times together are as long as the sound.
/// Deterministic. Threads: one.
class SoundTrack
{
public:
    /// `listener`: index of the entity whose ears these are.
    SoundTrack(const SoundRequest& request, const simulation::Scenario& scenario, std::size_t listener,
               int picturesPerSecond);

    /// The time of one picture, which ends with this state. `motion`: what moves the listener; null: the
    /// player.
    /// Errors: those of WaveFile.
    foundation::Outcome add(const std::vector<simulation::EntityState>& entities,
                            const simulation::ExternalMotion* motion);

    foundation::Outcome finish() { return _file.finish(); }

private:
    SceneSound _scene;
    simulation::Synthesiser _synthesiser;
    simulation::WaveFile _file;
    bool _isMuted;
    long _pictures = 0;
    int _perSecond;
};

} // namespace trainer
