// SPDX-License-Identifier: Apache-2.0
// Drives a car along a road of a world, and saves a picture from behind it each second:
//   driven_car WORLD CAR.xml FOLDER [SECONDS]      world: .roam, elevation raster or .xodr
#include <cstdio>
#include <cstdlib>

#include <osgSession/Session>

static int failed(const foundation::Error& error)
{
    std::fprintf(stderr, "driven_car: %s\n", error.message().c_str());
    return 1;
}

int main(int argc, char** argv)
{
    if (argc < 4) return std::fprintf(stderr, "usage: driven_car WORLD CAR.xml FOLDER [SECONDS]\n"), 2;
    osgSession::SessionSettings settings;
    settings.world = argv[1], settings.vehicle = argv[2];
    settings.picture.widthPx = 640, settings.picture.heightPx = 360;
    const auto session = osgSession::Session::open(settings);
    if (!session) return failed(session.error());
    osgSession::core::Play& play = (*session)->play();
    if (const auto seen = (*session)->look({osgSession::EyeFrom::behind}); !seen) return failed(seen.error());
    if (const auto put = play.set("Ego", "throttle", 0.4); !put) return failed(put.error());
    const int seconds = argc > 4 ? std::atoi(argv[4]) : 5;
    for (int second = 0; second <= seconds; ++second)
    {
        while (play.timeS() < second && play.step())
            continue;
        const std::filesystem::path file = argv[3] / std::filesystem::path(std::to_string(second) + ".png");
        if (const auto saved = (*session)->savePicture(file); !saved) return failed(saved.error());
        const osgSession::core::Entity car = *play.entity("Ego");
        std::printf("%d s: %.1f m east, %.1f m north, %.1f m/s\n", second, car.position.x, car.position.y,
                    car.speedMps);
    }
    return 0;
}
