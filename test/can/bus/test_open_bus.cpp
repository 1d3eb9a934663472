#include <gtest/gtest.h>

#include <stdexcept>

#include "fourwis_navigation/can/bus/bus.h"

namespace fourwis::can
{
namespace
{

TEST(OpenBus, RejectsInvalidNamesAndSaysWhichAreValid)
{
  for (const std::string name : {"", "unix:", "unix:a/b", "unix:..", "unix:with space", "can 0", "../can0", "tcp:can0",
                                 "an_interface_of_17", "unix:123456789012345678901234567890123"})
    try
    {
      open_bus(name);
      ADD_FAILURE() << "accepted '" << name << "'";
    }
    catch (const std::invalid_argument& error)
    {
      const std::string text = error.what();
      EXPECT_NE(text.find('\'' + name + '\''), std::string::npos) << text;
      EXPECT_NE(text.find("unix:NAME"), std::string::npos) << text;
      EXPECT_NE(text.find("can0"), std::string::npos) << text;
    }
}

TEST(OpenBus, AnInterfaceThatIsNotThereIsDown)
{
  const auto bus = open_bus("nocan77");
  Frame frame;
  EXPECT_EQ(bus->receive(frame), BusStatus::down);
  EXPECT_EQ(bus->send(frame), BusStatus::down);
  EXPECT_FALSE(bus->recover());
  EXPECT_EQ(bus->descriptor(), -1);
  EXPECT_NE(bus->last_error().find("nocan77: "), std::string::npos) << bus->last_error();
}

}  // namespace
}  // namespace fourwis::can
