#include <atomic>
#include <limits>
#include <mutex>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <boost/make_shared.hpp>

#include "ros/map_store.h"

namespace fourwis
{
namespace
{

nav_msgs::OccupancyGrid map(unsigned width, unsigned height, double stamp)
{
  nav_msgs::OccupancyGrid map;
  map.header.frame_id = "map";
  map.header.stamp = ros::Time(stamp);
  map.info.width = width;
  map.info.height = height;
  map.info.resolution = 0.1f;
  map.info.origin.orientation.w = 1.0;
  map.data.assign(width * height, 0);
  return map;
}

map_msgs::OccupancyGridUpdate update(int x, int y, std::int8_t cell, double stamp)
{
  map_msgs::OccupancyGridUpdate update;
  update.header.frame_id = "map";
  update.header.stamp = ros::Time(stamp);
  update.x = x;
  update.y = y;
  update.width = update.height = 1;
  update.data = {cell};
  return update;
}

class MapStoreTest : public testing::Test
{
protected:
  MapStoreTest()
    : store_("map", Robot(), PlannerOptions(), [this](const std::string& message) {
        const std::lock_guard<std::mutex> lock(mutex_);
        refused_.push_back(message);
      })
  {}

  template <class Message>
  void add(const Message& message)
  {
    store_.add(boost::make_shared<const Message>(message));
  }

  MapStore::Snapshot newest()
  {
    const std::atomic<bool> cancelled{false};
    return store_.wait_for_newest(cancelled);
  }

  void expect_refused(const std::string& part)
  {
    newest();
    const std::lock_guard<std::mutex> lock(mutex_);
    ASSERT_EQ(refused_.size(), 1u) << "expected one refusal that says '" << part << "'";
    EXPECT_NE(refused_[0].find(part), std::string::npos) << "'" << refused_[0] << "' lacks '" << part << "'";
    refused_.clear();
  }

  void expect_none_refused()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    EXPECT_TRUE(refused_.empty()) << refused_[0];
  }

  std::mutex mutex_;
  std::vector<std::string> refused_;
  MapStore store_;
};

TEST_F(MapStoreTest, has_nothing_and_waits_for_nothing_before_the_first_map)
{
  EXPECT_FALSE(store_.newest());
  EXPECT_FALSE(newest());
}

TEST_F(MapStoreTest, a_wait_returns_what_was_added_before)
{
  for (unsigned size = 10; size < 40; ++size)
  {
    add(map(size, 5, size));
    const MapStore::Snapshot snapshot = newest();
    ASSERT_TRUE(snapshot);
    EXPECT_EQ(snapshot->world.grid.width, static_cast<int>(size));
    EXPECT_EQ(snapshot->stamp, ros::Time(size));
  }
  expect_none_refused();
}

TEST_F(MapStoreTest, updates_change_a_new_snapshot_and_leave_the_old_one_alone)
{
  add(map(20, 20, 1.0));
  const MapStore::Snapshot before = newest();
  add(update(3, 4, 100, 2.0));
  add(update(5, 6, 100, 3.0));
  const MapStore::Snapshot after = newest();
  EXPECT_EQ(before->world.grid.at(3, 4), 0);
  EXPECT_EQ(after->world.grid.at(3, 4), 100);
  EXPECT_EQ(after->world.grid.at(5, 6), 100);
  EXPECT_GT(before->world.obstacles.cell_distance(3, 4), 0.0);
  EXPECT_EQ(after->world.obstacles.cell_distance(3, 4), 0.0);
  EXPECT_EQ(before->stamp, ros::Time(1.0));
  EXPECT_EQ(after->stamp, ros::Time(3.0));
  expect_none_refused();
}

TEST_F(MapStoreTest, a_map_and_its_updates_that_arrive_together_are_all_in_the_snapshot)
{
  for (int round = 0; round < 20; ++round)
  {
    add(map(50, 50, 1.0));
    for (int i = 0; i < 50; ++i) add(update(i, i, 100, 2.0));
    const MapStore::Snapshot snapshot = newest();
    for (int i = 0; i < 50; ++i)
      EXPECT_EQ(snapshot->world.grid.at(i, i), 100) << "update " << i << " of round " << round;
    EXPECT_EQ(snapshot->world.grid.at(1, 0), 0);
  }
  expect_none_refused();
}

TEST_F(MapStoreTest, a_refused_map_leaves_the_last_good_one_in_place_and_its_updates_are_refused)
{
  add(map(20, 20, 1.0));
  nav_msgs::OccupancyGrid bad = map(30, 30, 2.0);
  bad.info.resolution = std::numeric_limits<float>::quiet_NaN();
  add(bad);
  expect_refused("resolution");
  EXPECT_EQ(newest()->world.grid.width, 20);

  add(update(3, 4, 100, 3.0));
  expect_refused("no usable map");
  EXPECT_EQ(newest()->world.grid.at(3, 4), 0);

  add(map(40, 20, 4.0));
  add(update(3, 4, 100, 5.0));
  EXPECT_EQ(newest()->world.grid.at(3, 4), 100);
  expect_none_refused();
}

TEST_F(MapStoreTest, a_map_or_update_in_another_frame_is_refused_by_name)
{
  nav_msgs::OccupancyGrid other = map(20, 20, 1.0);
  other.header.frame_id = "odom";
  add(other);
  expect_refused("header.frame_id is 'odom', expected the global_frame 'map'");
  EXPECT_FALSE(newest());
}

TEST_F(MapStoreTest, a_leading_slash_of_the_frame_makes_no_difference)
{
  nav_msgs::OccupancyGrid slashed = map(20, 20, 1.0);
  slashed.header.frame_id = "/map";
  add(slashed);
  expect_none_refused();
  EXPECT_TRUE(newest());
}

TEST_F(MapStoreTest, an_update_without_a_map_or_out_of_its_bounds_is_refused)
{
  add(update(0, 0, 100, 1.0));
  expect_refused("no usable map");
  add(map(20, 20, 1.0));
  const MapStore::Snapshot before = newest();
  add(update(20, 0, 100, 2.0));
  expect_refused("do not lie in the map");
  EXPECT_EQ(newest(), before);
}

TEST_F(MapStoreTest, a_cancelled_wait_returns_with_what_there_is)
{
  const std::atomic<bool> cancelled{true};
  EXPECT_FALSE(store_.wait_for_newest(cancelled));
  add(map(20, 20, 1.0));
  const MapStore::Snapshot first = newest();
  add(map(30, 20, 1.0));
  const MapStore::Snapshot second = store_.wait_for_newest(cancelled);
  EXPECT_TRUE(second == first || second->world.grid.width == 30);
}

}  // namespace
}  // namespace fourwis
