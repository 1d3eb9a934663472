#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <actionlib_msgs/GoalStatusArray.h>
#include <nav_msgs/GetMap.h>
#include <nav_msgs/MapMetaData.h>
#include <octomap/OcTree.h>

#include "fourwis_navigation/map/map_file.h"
#include "fourwis_navigation/map/octomap_projection.h"
#include "fourwis_navigation/parameters/parameters.h"
#include "node_process.h"
#include "planner_fixture.h"

namespace fourwis
{
namespace
{

namespace fs = std::filesystem;

const std::string kConfig = FOURWIS_SOURCE_DIR "/config/";

void set_parameters(const std::string& name, const ParameterMap& parameters)
{
  for (const auto& [key, value] : parameters)
    std::visit([path = name + '/' + key](const auto& plain) { ros::param::set(path, plain); }, value);
}

/// Those of a node and of a group of its parameters, besides the robot's.
void set_shipped_parameters(const std::string& name, const std::string& node = "global_planner",
                            const std::string& group = "planner")
{
  ros::param::del(name);
  set_parameters(name, read_parameter_file(kConfig + node + ".yaml"));
  set_parameters(name + "/robot", read_parameter_file(kConfig + "robot.yaml"));
  set_parameters(name + '/' + group, read_parameter_file(kConfig + group + ".yaml"));
}

/// Starts the planner with the shipped files and these parameters beside them, and expects it to refuse them.
void expect_refused(const ParameterMap& parameters, const std::vector<std::string>& said)
{
  set_shipped_parameters("/refused");
  set_parameters("/refused", parameters);
  NodeProcess node("global_planner_node", {"__name:=refused"});
  const std::string output = node.read_to_end();
  EXPECT_EQ(node.exit_status(), 2) << output;
  for (const std::string& part : said)
    EXPECT_NE(output.find(part), std::string::npos) << "'" << output << "' lacks '" << part << "'";
}

void expect_ends_with(const std::string& executable, const std::vector<std::string>& arguments, const std::string& said)
{
  NodeProcess node(executable, arguments);
  const std::string output = node.read_to_end();
  EXPECT_EQ(node.exit_status(), 2) << output;
  EXPECT_NE(output.find(said), std::string::npos) << "'" << output << "' lacks '" << said << "'";
}

/// A file in the temporary directory, removed in the end.
class TemporaryFile
{
public:
  explicit TemporaryFile(const std::string& name) : path_(testing::TempDir() + "fourwis_nodes_" + name) {}
  ~TemporaryFile() { std::remove(path_.c_str()); }
  const std::string& path() const { return path_; }

private:
  std::string path_;
};

void expect_same(const nav_msgs::OccupancyGrid& map, const OccupancyGrid& grid)
{
  EXPECT_EQ(map.header.frame_id, "map");
  const OccupancyGrid published = to_grid(map);
  EXPECT_EQ(published.width, grid.width);
  EXPECT_EQ(published.height, grid.height);
  EXPECT_FLOAT_EQ(static_cast<float>(published.resolution), static_cast<float>(grid.resolution));
  EXPECT_EQ(published.origin.x, grid.origin.x);
  EXPECT_EQ(published.origin.y, grid.origin.y);
  EXPECT_NEAR(published.origin.theta, grid.origin.theta, 1e-12);
  EXPECT_EQ(published.data, grid.data);
}

/// What a latched topic says to a subscriber that comes when the node already runs; null when it has another type.
template <class Message>
boost::shared_ptr<const Message> said_on(const std::string& topic)
{
  return Inbox<Message>(topic).wait_for_any();
}

TEST(GlobalPlannerNode, a_bad_parameter_stops_it_naming_key_value_and_range)
{
  expect_refused({{"robot/length", -1.0}}, {"'length'", "-1", "0.05 to 20"});
  expect_refused({{"planner/heuristic_weight", std::string("much")}}, {"'heuristic_weight'", "'much'", "0 to 100"});
  expect_refused({{"start_from", std::string("nowhere")}}, {"'start_from'", "'nowhere'", "one of tf, initialpose"});
}

TEST(GlobalPlannerNode, an_unknown_parameter_stops_it_by_name)
{
  expect_refused({{"robot/wheels", 6.0}}, {"unknown", "'wheels'", "6"});
  expect_refused({{"goal_tolerance", 0.1}}, {"unknown", "'goal_tolerance'", "0.1"});
}

TEST(GlobalPlannerNode, a_missing_parameter_takes_its_default_and_is_said_so)
{
  ros::param::del("/bare");
  ros::param::set("/bare/robot/length", 1.25);
  ros::param::set("/bare/robot/width", std::string("7e-1"));  // as PyYAML has it
  NodeProcess node("global_planner_node", {"__name:=bare"});
  EXPECT_TRUE(said_on<PlannerStatus>("/bare/planner_status"));
  node.terminate();
  const std::string output = node.read_to_end();
  EXPECT_NE(output.find("in 'robot': missing parameters take their defaults: wheelbase = 0.68"), std::string::npos)
      << output;
  EXPECT_NE(output.find("in 'planner': missing"), std::string::npos) << output;
}

TEST(GlobalPlannerNode, tells_its_status_on_both_topics_where_the_name_is_not_the_actions)
{
  set_shipped_parameters("/planner");
  NodeProcess node("global_planner_node", {"__name:=planner"});
  for (const std::string topic : {"/planner/planner_status", "/planner/status"})
  {
    const auto status = said_on<PlannerStatus>(topic);
    ASSERT_TRUE(status) << topic;
    EXPECT_EQ(status->status, "idle") << topic;
  }
  EXPECT_TRUE(said_on<actionlib_msgs::GoalStatusArray>("/move_base/status"));
}

TEST(GlobalPlannerNode, leaves_its_status_to_the_action_of_the_same_name)
{
  set_shipped_parameters("/move_base");
  NodeProcess node("global_planner_node", {"__name:=move_base"});
  EXPECT_TRUE(said_on<PlannerStatus>("/move_base/planner_status"));
  EXPECT_TRUE(said_on<actionlib_msgs::GoalStatusArray>("/move_base/status"));
  ros::master::V_TopicInfo topics;
  ASSERT_TRUE(ros::master::getTopics(topics));
  for (const ros::master::TopicInfo& topic : topics)
  {
    if (topic.name != "/move_base/status") continue;
    EXPECT_EQ(topic.datatype, "actionlib_msgs/GoalStatusArray");
  }
}

TEST(BaseSimulatorNode, a_clock_without_use_sim_time_stops_it)
{
  set_shipped_parameters("/timeless", "base_simulator", "simulator");
  expect_ends_with("base_simulator_node", {"__name:=timeless"}, "'publish_clock' is true, expected false where");
}

TEST(MapPublisherNode, publishes_latched_what_the_file_says)
{
  OccupancyGrid grid = free_grid(7, 5, 0.05, {-1.5, 2.25, 0.3});
  for (std::size_t i = 0; i < grid.data.size(); i += 3) grid.data[i] = 100;
  for (std::size_t i = 2; i < grid.data.size(); i += 3) grid.data[i] = -1;
  const TemporaryFile yaml("map.yaml"), image("map.pgm");
  write_map_file(grid, yaml.path().substr(0, yaml.path().size() - 5));

  NodeProcess node("map_publisher_node", {yaml.path()});
  Inbox<nav_msgs::OccupancyGrid> early("map");
  const auto map = early.wait_for_any();
  ASSERT_TRUE(map);
  expect_same(*map, read_map_file(yaml.path()));
  Inbox<nav_msgs::OccupancyGrid> late("map");
  EXPECT_TRUE(late.wait_for_any()) << "not latched";

  Inbox<nav_msgs::MapMetaData> metadata("map_metadata");
  const auto info = metadata.wait_for_any();
  ASSERT_TRUE(info);
  EXPECT_EQ(*info, map->info);
  nav_msgs::GetMap asked;
  ASSERT_TRUE(ros::service::call("static_map", asked));
  EXPECT_EQ(asked.response.map, *map);
}

/// A folder with a space in its name that is the home directory of the nodes started meanwhile.
class Home
{
public:
  Home() : before_(std::getenv("HOME") ? std::getenv("HOME") : "")
  {
    fs::create_directory(folder_);
    setenv("HOME", folder_.c_str(), 1);
  }
  ~Home()
  {
    setenv("HOME", before_.c_str(), 1);
    fs::remove_all(folder_);
  }
  std::string operator/(const std::string& name) const { return (folder_ / name).string(); }

private:
  const std::string before_;
  const fs::path folder_ = fs::path(testing::TempDir()) / "fourwis nodes";
};

TEST(MapPublisherNode, finds_a_file_in_the_home_directory_also_with_spaces)
{
  const Home home;
  const OccupancyGrid grid = free_grid(7, 5, 0.05);
  write_map_file(grid, home / "my map");
  for (const std::string& argument :
       {std::string("_map_file:=~/my map.yaml"), std::string("~/my map.yaml"), "_map_file:=" + (home / "my map.yaml")})
  {
    SCOPED_TRACE(argument);
    NodeProcess node("map_publisher_node", {argument, "map:=/homely", "__name:=homely"});
    const auto map = said_on<nav_msgs::OccupancyGrid>("homely");
    ASSERT_TRUE(map);
    expect_same(*map, grid);
    ros::param::del("/homely");
  }
}

TEST(MapPublisherNode, warns_of_unseen_cells_that_become_free)
{
  const Home home;
  OccupancyGrid grid = free_grid(7, 5, 0.05);
  grid.data[3] = grid.data[20] = -1;
  write_map_file(grid, home / "map");
  std::ofstream(home / "nav2.yaml") << "image: map.pgm\nmode: trinary\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n"
                                       "occupied_thresh: 0.65\nfree_thresh: 0.25\n";
  NodeProcess node("map_publisher_node", {home / "nav2.yaml", "map:=/opened", "__name:=opened"});
  const auto map = said_on<nav_msgs::OccupancyGrid>("opened");
  ASSERT_TRUE(map);
  EXPECT_EQ(std::count(map->data.begin(), map->data.end(), 0), 35);
  node.terminate();
  const std::string output = node.read_to_end();
  EXPECT_NE(output.find("nav2.yaml: free_thresh is 0.25"), std::string::npos) << output;
  EXPECT_NE(output.find("becomes free: 2 of 35 pixels"), std::string::npos) << output;
  EXPECT_NE(output.find("WARN"), std::string::npos) << output;
}

TEST(MapPublisherNode, a_bad_file_stops_it_in_one_line_that_names_it)
{
  expect_ends_with("map_publisher_node", {"/nowhere/map.yaml"}, "/nowhere/map.yaml");
  expect_ends_with("map_publisher_node", {}, "missing parameter 'map_file'");
  const TemporaryFile yaml("broken.yaml");
  std::ofstream(yaml.path()) << "image: broken.pgm\nresolution: fine\n";
  expect_ends_with("map_publisher_node", {yaml.path()}, "resolution");
}

TEST(OctomapProjectorNode, publishes_latched_the_height_band_of_the_file)
{
  const TemporaryFile file("tree.bt");
  octomap::OcTree tree(0.1);
  tree.updateNode(octomap::point3d(0.05f, 0.05f, 0.55f), true);
  tree.updateNode(octomap::point3d(0.55f, 0.05f, 0.55f), false);
  tree.updateNode(octomap::point3d(0.25f, 0.25f, 1.95f), true);
  ASSERT_TRUE(tree.writeBinary(file.path()));

  for (const HeightBand band : {HeightBand{0.1, 1.0}, HeightBand{1.5, 2.5}})
  {
    NodeProcess node("octomap_projector_node",
                     {"_octomap_file:=" + file.path(), "_min_height:=" + std::to_string(band.min),
                      "_max_height:=" + std::to_string(band.max), "map:=/projected", "__name:=projector"});
    Inbox<nav_msgs::OccupancyGrid> inbox("projected");
    const auto map = inbox.wait_for_any();
    ASSERT_TRUE(map);
    expect_same(*map, project_octomap_file(file.path(), band));
  }
}

TEST(OctomapProjectorNode, a_bad_file_stops_it_in_one_line_that_names_it)
{
  expect_ends_with("octomap_projector_node", {"_octomap_file:=/nowhere/tree.bt"}, "/nowhere/tree.bt");
  const Home home;
  expect_ends_with("octomap_projector_node", {"_octomap_file:=~/no tree.bt"}, home / "no tree.bt");
}

}  // namespace
}  // namespace fourwis

int main(int argc, char** argv)
{
  return fourwis::run_rostest(argc, argv, "test_nodes");
}
