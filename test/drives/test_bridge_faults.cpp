#include "bridge_fault_cases.h"
#include "bridge_fixture.h"

namespace fourwis
{
namespace
{

class BridgeFaults : public BridgeFixture, public testing::WithParamInterface<FaultCase>
{};

TEST_P(BridgeFaults, StopTheBaseInTimeAndHaveTheirName)
{
  expect_stop(*this, GetParam());
}

INSTANTIATE_TEST_SUITE_P(All, BridgeFaults, testing::ValuesIn(kFaultCases));

}  // namespace
}  // namespace fourwis
