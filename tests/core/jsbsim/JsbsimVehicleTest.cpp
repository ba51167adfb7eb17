// SPDX-License-Identifier: Apache-2.0
// The stand-in flies straight at its begin's speed, sinks by 5 m/s for each unit of the elevator's command
// and goes with the wind.
#include <fstream>

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include "JsbsimSupport.h"

namespace
{

using namespace simulation;
using namespace testsupport;

const LevelGround kGround;

class JsbsimStandIn : public ::testing::Test
{
protected:
    /// A vehicle that flies eastwards.
    std::unique_ptr<JsbsimVehicle> flying(const std::string& mode, const Air& air = WeatherAir())
    {
        auto vehicle = std::make_unique<JsbsimVehicle>(standIn(mode, _folder / ""), earthOfJsbsim());
        const auto begun = vehicle->begin(eastwards(), kGround, air);
        EXPECT_TRUE(begun) << begun.error().message();
        return vehicle;
    }

    void fly(JsbsimVehicle& vehicle, int steps, const Air& air = WeatherAir())
    {
        for (int i = 0; i < steps; ++i)
            vehicle.step(kGround, air);
    }

    TestFolder _folder{"jsbsim"};
};

TEST_F(JsbsimStandIn, FliesAsFarAsItsSpeedSays)
{
    const auto vehicle = flying("normal");
    EXPECT_EQ(vehicle->state().position, glm::dvec3(0.0, 0.0, 300.0));
    fly(*vehicle, 240);
    const VehicleState state = vehicle->state();
    EXPECT_EQ(vehicle->status().condition, VehicleCondition::sound);
    EXPECT_DOUBLE_EQ(state.timeS, 2.0);
    EXPECT_NEAR(state.position.x, 100.0, 1e-6);
    EXPECT_NEAR(state.position.z, 300.0 - 100.0 * 100.0 / (2.0 * 6.378e6), 1e-4); // the Earth bends away
    EXPECT_NEAR(glm::length(state.velocity), 50.0, 1e-6);
    EXPECT_NEAR((state.bodyToScene * glm::dvec3(1.0, 0.0, 0.0)).x, 1.0, 1e-9); // the nose looks east
    EXPECT_NEAR((state.bodyToScene * glm::dvec3(0.0, 0.0, 1.0)).z, 1.0, 1e-9);
}

TEST_F(JsbsimStandIn, TakesInputsWithTheNextStep)
{
    const auto vehicle = flying("normal");
    vehicle->inputs()[static_cast<std::size_t>(FlightInput::elevator)] = 0.4; // 2 m/s down
    fly(*vehicle, 1);
    EXPECT_NEAR(vehicle->state().position.z, 300.0, 1e-6);
    fly(*vehicle, 120);
    EXPECT_NEAR(vehicle->state().position.z, 300.0 - 2.0, 2e-3);
    vehicle->inputs()[static_cast<std::size_t>(FlightInput::elevator)] = std::nan("");
    fly(*vehicle, 2);
    EXPECT_NEAR(vehicle->state().velocity.z, 0.0, 1e-3);
}

TEST_F(JsbsimStandIn, GetsTheWind)
{
    WeatherSettings weather;
    fly(*flying("normal"), 1);
    const auto vehicle = flying("normal");
    weather.windMps = {3.0, -4.0, 0.0};
    fly(*vehicle, 121, WeatherAir(weather));
    EXPECT_NEAR(vehicle->state().position.x, 50.0 * 121.0 / 120.0 + 3.0, 1e-3);
    EXPECT_NEAR(vehicle->state().position.y, -4.0, 2e-3);
}

TEST_F(JsbsimStandIn, StandsOnTheGroundThatItIsHanded)
{
    const LevelGround hill(250.0);
    JsbsimVehicle vehicle(standIn("normal", _folder / ""), earthOfJsbsim());
    ASSERT_TRUE(vehicle.begin({{10.0, 20.0, 250.0}, 0.5, 0.0, false}, hill, WeatherAir()));
    for (int i = 0; i < 30; ++i)
        vehicle.step(hill, WeatherAir());
    // Its wheels are 48 inches below its middle: 4 feet, at which the stand-in stands.
    EXPECT_NEAR(vehicle.state().position.z, 250.0 + 48.0 * 0.0254, 1e-6);
    EXPECT_NEAR(vehicle.referencePoint().z, -48.0 * 0.0254, 1e-9);
    EXPECT_NEAR(vehicle.referencePoint().x, -20.0 * 0.0254, 1e-9);
    EXPECT_TRUE(vehicle.state().isOnGround);
    const glm::dvec3 wheels =
        vehicle.state().position + vehicle.state().bodyToScene * vehicle.referencePoint();
    EXPECT_NEAR(wheels.x, 10.0, 0.05);
    EXPECT_NEAR(wheels.y, 20.0, 0.05);
}

TEST_F(JsbsimStandIn, RepeatsAFlightToTheLastBit)
{
    const auto once = flying("normal"), again = flying("normal");
    for (int i = 0; i < 60; ++i)
        for (const auto& vehicle : {once.get(), again.get()})
        {
            vehicle->inputs()[0] = 0.01 * i;
            vehicle->step(kGround, WeatherAir());
        }
    EXPECT_EQ(once->state().position, again->state().position);
    EXPECT_EQ(once->state().velocity, again->state().velocity);
}

TEST_F(JsbsimStandIn, SaysThatItCouldNotBeTrimmed)
{
    const auto vehicle = flying("notrim");
    EXPECT_THAT(vehicle->note(), testing::HasSubstr("no steady flight"));
    EXPECT_THAT(vehicle->note(), testing::HasSubstr("Trim failed"));
    fly(*vehicle, 12);
    EXPECT_EQ(vehicle->status().condition, VehicleCondition::sound);
    EXPECT_EQ(flying("normal")->note(), "");
}

TEST_F(JsbsimStandIn, TriesAnotherPortWhereOneWasTaken)
{
    const auto vehicle = flying("port");
    fly(*vehicle, 5);
    EXPECT_EQ(vehicle->status().condition, VehicleCondition::sound);
    EXPECT_TRUE(std::filesystem::exists(_folder / "port-was-lost"));
}

struct Fault
{
    const char* mode;
    const char* reason;
};

class JsbsimFaults : public JsbsimStandIn, public ::testing::WithParamInterface<Fault>
{
};

TEST_P(JsbsimFaults, EndInAStatusAndTheFrameGoesOn)
{
    const auto vehicle = flying(GetParam().mode);
    const pid_t process = vehicle->processId();
    EXPECT_TRUE(isProcess(process));
    fly(*vehicle, 50);
    EXPECT_EQ(vehicle->status().condition, VehicleCondition::sound);
    fly(*vehicle, 70);
    EXPECT_EQ(vehicle->status().condition, VehicleCondition::failed);
    EXPECT_EQ(vehicle->status().reason, GetParam().reason);
    EXPECT_DOUBLE_EQ(vehicle->state().timeS, 1.0);
    EXPECT_EQ(vehicle->state().velocity, glm::dvec3(0.0));
    EXPECT_NEAR(vehicle->state().position.x, 25.0, 1.0); // where it was when it was lost
    EXPECT_NEAR(vehicle->state().position.z, 300.0, 0.01);
    EXPECT_EQ(vehicle->processId(), -1);
    EXPECT_FALSE(isProcess(process));
}

INSTANTIATE_TEST_SUITE_P(Each, JsbsimFaults,
                         ::testing::Values(Fault{"hang", "JSBSim did not answer in time"},
                                           Fault{"dies", "JSBSim ended"}, Fault{"signal", "JSBSim ended"},
                                           Fault{"garbage", "JSBSim answered what cannot be read"},
                                           Fault{"nan", "JSBSim's motion cannot be computed any further"},
                                           Fault{"leap", "JSBSim's motion leaps"},
                                           Fault{"clock", "JSBSim's clock is out of step"}),
                         [](const auto& fault) { return fault.param.mode; });

TEST_F(JsbsimStandIn, MayBeSlowWithinItsTime)
{
    const auto vehicle = flying("slow"); // 20 ms a step, 500 allowed
    fly(*vehicle, 10);
    EXPECT_EQ(vehicle->status().condition, VehicleCondition::sound);
    auto hasty = standIn("slow", _folder / "");
    hasty->answersWithinS = 0.005;
    JsbsimVehicle impatient(hasty, earthOfJsbsim());
    if (impatient.begin(eastwards(), kGround, WeatherAir())) fly(impatient, 3);
    EXPECT_EQ(impatient.status().condition, VehicleCondition::failed);
}

TEST_F(JsbsimStandIn, TellsWhyItCannotBegin)
{
    const auto refused = [&](std::shared_ptr<JsbsimData> data, VehicleStart start, const char* word)
    {
        data->beginsWithinS = 0.4;
        JsbsimVehicle vehicle(data, earthOfJsbsim());
        const auto begun = vehicle.begin(start, kGround, WeatherAir());
        ASSERT_FALSE(begun) << word;
        EXPECT_THAT(begun.error().message(), testing::HasSubstr(word));
        EXPECT_EQ(vehicle.processId(), -1);
        vehicle.step(kGround, WeatherAir()); // the frame goes on
        EXPECT_EQ(vehicle.status().condition, VehicleCondition::failed);
    };
    auto missing = standIn("normal", _folder / "");
    missing->program = "no-such-program";
    refused(missing, eastwards(), "cannot be started: No such file or directory");
    auto other = standIn("normal", _folder / "");
    other->aircraft = "glider";
    refused(other, eastwards(), "no such aircraft");
    auto nothing = standIn("normal", _folder / "");
    nothing->program = "/bin/true";
    refused(nothing, eastwards(), "JSBSim ended with exit code 0");
    refused(standIn("mute", _folder / ""), eastwards(), "did not open its port");
    refused(standIn("silent", _folder / ""), eastwards(), "does not greet");
    refused(standIn("normal", _folder / ""), {{0.0, 0.0, -30.0}, 0.0, 50.0, true}, "30 m inside the ground");
    refused(standIn("normal", _folder / ""), {{0.0, 0.0, -30.0}, 0.0, 0.0, false}, "30 m inside the ground");
}

TEST_F(JsbsimStandIn, LeavesNothingBehind)
{
    const auto folders = []
    {
        int count = 0;
        for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::temp_directory_path()))
            count += entry.path().filename().string().starts_with("osgtrainer-jsbsim-") ? 1 : 0;
        return count;
    };
    const TestFolder temporary("jsbsim-temporary");
    setenv("TMPDIR", (temporary / "").c_str(), 1);
    pid_t process = -1;
    {
        const auto vehicle = flying("normal");
        process = vehicle->processId();
        EXPECT_EQ(folders(), 1);
        EXPECT_TRUE(isProcess(process));
    }
    EXPECT_EQ(folders(), 0);
    EXPECT_FALSE(isProcess(process));
    unsetenv("TMPDIR");
}

/// A program that dies takes its JSBSim with it, even one that is killed.
TEST_F(JsbsimStandIn, DiesWithItsParent)
{
    int pipes[2];
    ASSERT_EQ(pipe(pipes), 0);
    const pid_t parent = fork();
    if (parent == 0)
    {
        JsbsimVehicle vehicle(standIn("normal", _folder / ""), earthOfJsbsim());
        pid_t child = -1;
        if (vehicle.begin(eastwards(), kGround, WeatherAir())) child = vehicle.processId();
        [[maybe_unused]] const ssize_t written = write(pipes[1], &child, sizeof child);
        for (;;)
            pause();
    }
    pid_t child = -1;
    ASSERT_EQ(read(pipes[0], &child, sizeof child), static_cast<ssize_t>(sizeof child));
    ASSERT_GT(child, 0);
    kill(parent, SIGKILL);
    waitpid(parent, nullptr, 0);
    const auto isGone = [&]
    {
        // Nobody waits for an orphan in some containers: it may stay as a name without a program.
        std::ifstream stream("/proc/" + std::to_string(child) + "/stat");
        std::string id, name, state;
        stream >> id >> name >> state;
        return !stream || state == "Z" || state == "X";
    };
    for (int i = 0; i < 200 && !isGone(); ++i)
        usleep(10'000);
    EXPECT_TRUE(isGone());
    close(pipes[0]);
    close(pipes[1]);
}

} // namespace
