#include "fourwis_navigation/can/bus/request_slot.h"

#include <thread>

#include <gtest/gtest.h>

namespace fourwis::can
{
namespace
{

using Request = RequestSlot::Request;

TEST(RequestSlot, WhatIsNotAnsweredInTimeIsWithdrawn)
{
  SignalEvent wake;
  RequestSlot slot(wake, 0.0);
  EXPECT_EQ(slot.ask(Request::enable), "the bridge does not answer");
  EXPECT_EQ(slot.take(), Request::none) << "it would be carried out later, unexpectedly";
}

TEST(RequestSlot, EachOneGetsItsOwnAnswer)
{
  SignalEvent wake;
  RequestSlot slot(wake);
  std::thread asked([&] {
    for (int answers = 0; answers < 100;)
    {
      const Request request = slot.take();
      if (request == Request::none) continue;
      slot.answer(request == Request::enable ? nullptr : "no");
      ++answers;
    }
  });
  for (int i = 0; i < 50; ++i)
  {
    EXPECT_EQ(slot.ask(Request::enable), "");
    EXPECT_EQ(slot.ask(Request::disable), "no");
  }
  asked.join();
}

}  // namespace
}  // namespace fourwis::can
