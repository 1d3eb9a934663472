#include "fourwis_navigation/can/bridge/faults.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace fourwis::can
{
namespace
{

TEST(Faults, EachHasANameOfItsOwn)
{
  std::set<std::string> names;
  for (int i = 0; i < static_cast<int>(Fault::count); ++i) names.insert(to_string(static_cast<Fault>(i)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(Fault::count));
  EXPECT_EQ(names.count("none"), 0u);
}

TEST(Faults, ARecordSaysWhoWhatAndTheDetail)
{
  EXPECT_EQ(text_of({Fault::emergency_message, 6, 0x8130, 0, 1.0}), "driving rear_left: emergency_message 0x8130");
  EXPECT_EQ(text_of({Fault::link_down, kNoAxis, 0, 0, 1.0}), "base: link_down");
  EXPECT_EQ(text_of({Fault::sdo_abort, 0, 0x06040041, 0x160001, 1.0}),
            "steering front_left: sdo_abort 0x6040041 (the object cannot be mapped) at 1600:01");
  EXPECT_EQ(text_of({}), "");
}

TEST(FaultLog, TellsAFaultOfAnAxisOnceUntilItIsCleared)
{
  FaultLog log;
  log.report(Fault::heartbeat_lost, 3, 0, 1.0);
  EXPECT_EQ(log.take_reaction(), Reaction::latch);
  log.report(Fault::heartbeat_lost, 3, 0, 2.0);
  EXPECT_EQ(log.take_reaction(), Reaction::note);
  log.report(Fault::heartbeat_lost, 4, 0, 2.0);
  EXPECT_EQ(log.take_reaction(), Reaction::latch);
  log.clear();
  log.report(Fault::heartbeat_lost, 3, 0, 3.0);
  EXPECT_EQ(log.take_reaction(), Reaction::latch);
}

TEST(FaultLog, TellsEachTimeThatTheBusIsLost)
{
  FaultLog log;
  for (const Fault lost : {Fault::link_down, Fault::bus_off, Fault::link_down})
  {
    log.report(lost, kNoAxis, 0, 1.0);
    EXPECT_EQ(log.take_reaction(), Reaction::restart);
  }
}

TEST(FaultLog, TheCauseIsTheFirstOfTheStrongestAndTheHistoryHasTheNewestFirst)
{
  FaultLog log;
  log.report(Fault::receive_overflow, kNoAxis, 0, 1.0);
  log.report(Fault::command_timeout, kNoAxis, 0, 2.0);
  log.report(Fault::drive_fault, 1, 0x38, 3.0);
  log.report(Fault::drive_fault, 2, 0x38, 4.0);
  EXPECT_EQ(log.cause().axis, 1);
  EXPECT_EQ(log.cause().fault, Fault::drive_fault);
  EXPECT_EQ(log.history()[0].axis, 2);
  EXPECT_EQ(log.history()[3].fault, Fault::receive_overflow);
  EXPECT_FALSE(log.history()[4].exists());
  log.clear();
  EXPECT_FALSE(log.cause().exists());
  EXPECT_EQ(log.history()[0].axis, 2);
}

}  // namespace
}  // namespace fourwis::can
