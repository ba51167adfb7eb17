// SPDX-License-Identifier: Apache-2.0
// Steps an OpenSCENARIO file without graphics, tells its events, and where entities are at the end:
//   stepped_scenario FILE.xosc [SECONDS]
#include <cstdio>
#include <cstdlib>

#include <osgSession/core/Play.h>

int main(int argc, char** argv)
{
    if (argc < 2) return std::fprintf(stderr, "usage: stepped_scenario FILE.xosc [SECONDS]\n"), 2;
    const auto play = osgSession::core::Play::open({.scenario = argv[1]});
    if (!play)
    {
        std::fprintf(stderr, "stepped_scenario: %s\n", play.error().message().c_str());
        return 1;
    }
    const double endS = argc > 2 ? std::atof(argv[2]) : 60.0;
    while ((*play)->timeS() < endS && (*play)->step())
        for (const osgSession::core::Event& event : (*play)->takeEvents())
            std::printf("%.2f s: %s, %s\n", event.timeS, event.element.c_str(), event.transition.c_str());
    for (const osgSession::core::Entity& entity : (*play)->entities())
        std::printf("%s: %.2f m east, %.2f m north, %.1f m/s\n", entity.name.c_str(), entity.position.x,
                    entity.position.y, entity.speedMps);
    return 0;
}
